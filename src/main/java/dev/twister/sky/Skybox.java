package dev.twister.sky;

/**
 * An equirectangular panorama of linear radiance.
 *
 * @param width texels around the horizon, 1 or more
 * @param height texels from straight up (row 0) to straight down
 * @param radiance {@code 3 * width * height} floats: red, green, blue of each texel, row by row from the top
 * @param opacity {@code width * height} floats in [0, 1]; of none if all texels are opaque, or the radiance is that
 *     over black
 */
@SuppressWarnings(
        "ArrayRecordComponent") // a snapshot that the kernel reads in place; comparing skyboxes is no one's need
public record Skybox(int width, int height, float[] radiance, float[] opacity) implements TextureImage {
    private static final float[] OPAQUE = {};

    /** Gray all around. */
    static Skybox uniform(float radiance) {
        return new Skybox(1, 1, new float[] {radiance, radiance, radiance});
    }

    public Skybox {
        if (width < 1 || height < 1 || radiance.length != 3L * width * height) {
            throw new IllegalArgumentException(
                    "a skybox of " + width + " x " + height + " texels with " + radiance.length + " floats");
        }
    }

    /** An opaque one. */
    public Skybox(int width, int height, float[] radiance) {
        this(width, height, radiance, OPAQUE);
    }

    /** The luminance that a white surface has which faces up, under nothing but the panorama. */
    public double lightFromAbove() {
        double sum = 0;
        double step = Math.PI / height;
        for (int row = 0; row < (height + 1) / 2; row++) {
            double top = Math.sin(row * step);
            double bottom = Math.sin(Math.min((row + 1) * step, Math.PI / 2));
            // The row's share of the light is its area as seen from above.
            double share = (bottom * bottom - top * top) / width;
            for (int texel = row * width; texel < (row + 1) * width; texel++) {
                sum += share
                        * (0.2126 * radiance[3 * texel]
                                + 0.7152 * radiance[3 * texel + 1]
                                + 0.0722 * radiance[3 * texel + 2]);
            }
        }
        return sum;
    }

    @Override
    public boolean isOpaque() {
        return opacity.length == 0;
    }
}
