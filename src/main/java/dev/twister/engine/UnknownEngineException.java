package dev.twister.engine;

/** A name that no engine has; the message lists those there are. */
public final class UnknownEngineException extends RuntimeException {
    private static final long serialVersionUID = 1L;

    public UnknownEngineException(String message) {
        super(message);
    }
}
