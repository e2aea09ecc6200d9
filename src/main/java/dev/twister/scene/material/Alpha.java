package dev.twister.scene.material;

import static java.util.Objects.requireNonNull;

/**
 * Opacity of a mesh.
 *
 * @param factor multiplies what maps and vertices say, in [0, 1]
 * @param cutoff with a mask, lower opacities are cut out
 */
public record Alpha(Mode mode, double factor, double cutoff) {
    public static final Alpha OPAQUE = new Alpha(Mode.OPAQUE, 1, 0.5);

    public Alpha {
        requireNonNull(mode, "mode");
    }

    /** What opacity does. */
    public enum Mode {
        /** Nothing. */
        OPAQUE,
        /** It cuts out. */
        MASK,
        /** What is behind passes in part. */
        BLEND
    }

    public Alpha withMode(Mode newMode) {
        return new Alpha(newMode, factor, cutoff);
    }

    public Alpha withCutoff(double newCutoff) {
        return new Alpha(mode, factor, newCutoff);
    }
}
