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

    @Override
    public boolean isOpaque() {
        return opacity.length == 0;
    }
}
