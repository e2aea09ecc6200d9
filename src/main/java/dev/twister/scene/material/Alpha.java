package dev.twister.scene.material;

import static java.util.Objects.requireNonNull;

import dev.twister.scene.property.Copied;

/**
 * Opacity of a mesh.
 *
 * @param factor multiplies what maps and vertices say, in [0, 1]
 * @param cutoff with a mask, lower opacities are cut out
 */
@Copied
public record Alpha(Mode mode, double factor, double cutoff) implements AlphaCopy.With {
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
}
