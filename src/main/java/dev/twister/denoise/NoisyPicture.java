package dev.twister.denoise;

import java.util.Optional;

/**
 * A picture whose noise is to be removed.
 *
 * @param width in pixels
 * @param height in pixels
 * @param radiance linear red, green and blue
 * @param guides of the same size; without them edges and textures are blurred
 * @param noise of the radiance, where it is known
 */
public record NoisyPicture(int width, int height, Plane radiance, Optional<Guides> guides, Optional<Noise> noise) {
    private static final int CHANNELS = 3;

    /**
     * Features of the first surfaces seen, behind mirrors and clear glass.
     *
     * @param albedo colors in [0, 1]
     * @param normal components in [-1, 1]
     */
    public record Guides(Plane albedo, Plane normal) {}

    /**
     * What is known of the noise.
     *
     * @param difference noise alone, of the same variance as that of the radiance
     * @param samples per pixel
     */
    public record Noise(Plane difference, int samples) {}

    /** A picture whose noise is not known. */
    public NoisyPicture(int width, int height, Plane radiance, Optional<Guides> guides) {
        this(width, height, radiance, guides, Optional.empty());
    }

    /** Number of values in a plane. */
    public int values() {
        return Math.multiplyExact(CHANNELS, Math.multiplyExact(width, height));
    }
}
