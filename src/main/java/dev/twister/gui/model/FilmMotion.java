package dev.twister.gui.model;

import dev.twister.scene.Scene;
import dev.twister.scene.Vector3;
import java.util.Arrays;
import java.util.List;

/** What moves in a film. */
public enum FilmMotion {
    CAMERA("Camera keyframes", true, false),
    PHYSICS("Physics", false, true),
    CAMERA_AND_PHYSICS("Camera keyframes and physics", true, true);

    private static final Vector3 NONE = Vector3.ZERO;

    /** One keyframe is no way. */
    private static final int FEWEST_KEYFRAMES = 2;

    private final String label;
    private final boolean camera;
    private final boolean physics;

    FilmMotion(String label, boolean camera, boolean physics) {
        this.label = label;
        this.camera = camera;
        this.physics = physics;
    }

    /** What can move in a scene; empty if nothing can. */
    public static List<FilmMotion> of(Scene scene) {
        boolean path = scene.camera().keyframes().size() >= FEWEST_KEYFRAMES;
        boolean bodies = !scene.spheres().isEmpty() || scene.pour().isPresent();
        boolean falls = bodies && !scene.physics().gravity().equals(NONE);
        return Arrays.stream(values())
                .filter(motion -> (path || !motion.camera) && (falls || !motion.physics))
                .toList();
    }

    /** The displayed name. */
    public String label() {
        return label;
    }

    /** Whether the camera follows its keyframes. */
    public boolean movesCamera() {
        return camera;
    }

    /** Whether bodies are simulated. */
    public boolean movesBodies() {
        return physics;
    }
}
