package dev.twister.sky;

/** A panorama that cannot be read; the message is one line that names the file, what was found and what is allowed. */
public final class SkyException extends RuntimeException {
    private static final long serialVersionUID = 1L;

    public SkyException(String message, Throwable cause) {
        super(message, cause);
    }
}
