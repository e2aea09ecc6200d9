package dev.twister.gui.controls;

import dev.twister.mesh.MeshException;
import dev.twister.scene.SceneException;
import dev.twister.sky.SkyException;
import java.io.IOException;

/** The messages of failures. */
public final class Problems {
    private Problems() {}

    /** The message of a failure that a user can cause; names anything else as a bug. */
    public static String explain(Throwable problem) {
        return switch (problem) {
            case SceneException _, SkyException _, MeshException _, IOException _ -> problem.getMessage();
            case OutOfMemoryError _ -> "There is not enough memory for it.";
            default -> "This is a bug of Twister's: " + problem;
        };
    }
}
