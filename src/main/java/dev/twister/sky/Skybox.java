package dev.twister.sky;

/**
 * An equirectangular panorama of linear radiance.
 *
 * @param width texels around the horizon, 1 or more
 * @param height texels from straight up (row 0) to straight down
 * @param radiance {@code 3 * width * height} floats: red, green, blue of each texel, row by row from the top
 */
@SuppressWarnings(
        "ArrayRecordComponent") // a snapshot that the kernel reads in place; comparing skyboxes is no one's need
public record Skybox(int width, int height, float[] radiance) {
    public Skybox {
        if (width < 1 || height < 1 || radiance.length != 3L * width * height) {
            throw new IllegalArgumentException(
                    "a skybox of " + width + " x " + height + " texels with " + radiance.length + " floats");
        }
    }
}
