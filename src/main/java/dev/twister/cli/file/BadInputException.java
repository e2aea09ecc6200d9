package dev.twister.cli.file;

/** Options that make no sense; the message is one line that names the option, what was found and what is allowed. */
public final class BadInputException extends RuntimeException {
    private static final long serialVersionUID = 1L;

    public BadInputException(String message) {
        super(message);
    }
}
