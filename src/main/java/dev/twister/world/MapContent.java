package dev.twister.world;

import dev.twister.sky.Skybox;

/** Texels as the kernel reads them, made from a decoded image. */
final class MapContent {
    private MapContent() {}

    static float[] of(MapUse use, SceneImages images) {
        Skybox image = use.image(images);
        return switch (use.content()) {
            case COLOR -> image.radiance();
            case NUMBERS -> stored(image.radiance(), 1);
            case NORMALS -> normals(image);
            case ALPHA -> image.opacity();
            case RED -> stored(image.radiance(), 3);
        };
    }

    /** The numbers that an image of 0 to 1 stores, before they were made linear; every {@code step}th. */
    private static float[] stored(float[] linear, int step) {
        float[] stored = new float[linear.length / step];
        float known = 0;
        float result = 0;
        for (int i = 0; i < stored.length; i++) {
            float value = linear[step * i];
            if (value != known) {
                known = value;
                result = (float) (value <= 0.0031308 ? 12.92 * value : 1.055 * Math.pow(value, 1 / 2.4) - 0.055);
            }
            stored[i] = result;
        }
        return stored;
    }

    private static float[] normals(Skybox image) {
        float[] stored = stored(image.radiance(), 1);
        boolean gray = true;
        for (int i = 0; i < stored.length && gray; i += 3) {
            gray = stored[i] == stored[i + 1] && stored[i] == stored[i + 2];
        }
        return gray ? ofHeights(stored, image.width(), image.height()) : stored;
    }

    /** Normals of a surface that is one texel higher at 1 than at 0. */
    private static float[] ofHeights(float[] heights, int width, int height) {
        float[] normals = new float[heights.length];
        for (int row = 0; row < height; row++) {
            int above = Math.floorMod(row - 1, height) * width;
            int below = (row + 1) % height * width;
            for (int column = 0; column < width; column++) {
                int left = Math.floorMod(column - 1, width);
                int right = (column + 1) % width;
                double x = (heights[3 * (row * width + left)] - heights[3 * (row * width + right)]) / 2;
                double y = (heights[3 * (below + column)] - heights[3 * (above + column)]) / 2;
                double half = 0.5 / Math.sqrt(x * x + y * y + 1);
                int at = 3 * (row * width + column);
                normals[at] = (float) (0.5 + x * half);
                normals[at + 1] = (float) (0.5 + y * half);
                normals[at + 2] = (float) (0.5 + half);
            }
        }
        return normals;
    }
}
