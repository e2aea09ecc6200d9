package dev.twister.scene;

import java.io.Serial;

/**
 * A scene that cannot be read, written or made. The message is one line for a person, or one line for each of several
 * faults: the file, the line and column and the JSON path where they are known, what was found and what is allowed.
 */
public final class SceneException extends RuntimeException {
    @Serial
    private static final long serialVersionUID = 1;

    public SceneException(String message) {
        super(message);
    }
}
