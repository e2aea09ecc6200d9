package dev.twister.cli;

/** Options that make no sense; the message is one line that names the option, what was found and what is allowed. */
final class BadInputException extends RuntimeException {
    private static final long serialVersionUID = 1L;

    BadInputException(String message) {
        super(message);
    }
}
