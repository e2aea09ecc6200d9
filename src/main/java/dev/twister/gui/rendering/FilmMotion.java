package dev.twister.gui.rendering;

import dev.twister.scene.Scene;
import dev.twister.scene.Vector3;
import dev.twister.world.Animation;
import java.util.Arrays;
import java.util.List;

/** What moves in a film. */
public enum FilmMotion {
    KEYFRAMES("Keyframes", true, false),
    PHYSICS("Physics", false, true),
    KEYFRAMES_AND_PHYSICS("Keyframes and physics", true, true);

    private static final Vector3 NONE = Vector3.ZERO;

    /** One keyframe moves nothing. */
    private static final int FEWEST_KEYFRAMES = 2;

    private final String label;
    private final boolean keyframes;
    private final boolean physics;

    FilmMotion(String label, boolean keyframes, boolean physics) {
        this.label = label;
        this.keyframes = keyframes;
        this.physics = physics;
    }

    /** What can move in a scene; empty if nothing can. */
    public static List<FilmMotion> of(Scene scene) {
        boolean path = scene.camera().keyframes().size() >= FEWEST_KEYFRAMES
                || scene.tracks().stream().anyMatch(track -> track.keyframes().size() >= FEWEST_KEYFRAMES)
                || Animation.isOfMeshes(scene);
        boolean bodies = !scene.spheres().isEmpty() || scene.pour().isPresent();
        boolean falls = bodies && !scene.physics().gravity().equals(NONE);
        return Arrays.stream(values())
                .filter(motion -> (path || !motion.keyframes) && (falls || !motion.physics))
                .toList();
    }

    /** The displayed name. */
    public String label() {
        return label;
    }

    /** Whether the camera, bodies and whatever else has keyframes follow them. */
    public boolean followsKeyframes() {
        return keyframes;
    }

    /** Whether bodies are simulated. */
    public boolean movesBodies() {
        return physics;
    }
}
