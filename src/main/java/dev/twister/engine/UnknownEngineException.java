package dev.twister.engine;

/** No engine has this name; the message lists the known ones. */
public final class UnknownEngineException extends RuntimeException {
    private static final long serialVersionUID = 1L;

    public UnknownEngineException(String message) {
        super(message);
    }
}
