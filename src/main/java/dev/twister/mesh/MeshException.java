package dev.twister.mesh;

/** A mesh file cannot be used. The message is one line for the user: what is wrong, and where. */
public final class MeshException extends RuntimeException {
    private static final long serialVersionUID = 1;

    public MeshException(String message) {
        super(message);
    }

    public MeshException(String message, Throwable cause) {
        super(message, cause);
    }
}
