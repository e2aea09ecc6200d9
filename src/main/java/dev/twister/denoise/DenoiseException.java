package dev.twister.denoise;

/** A denoiser failed or is not there; the message says why and what to do. */
public final class DenoiseException extends RuntimeException {
    private static final long serialVersionUID = 1L;

    public DenoiseException(String message) {
        super(message);
    }

    public DenoiseException(String message, Throwable cause) {
        super(message, cause);
    }
}
