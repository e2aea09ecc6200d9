package dev.twister.world.table;

import dev.twister.kernel.Layout;
import dev.twister.sky.PackedImage;
import dev.twister.sky.Skybox;
import dev.twister.world.SceneImages;
import java.util.Arrays;

/**
 * Texels as the kernel reads them, made from a decoded image.
 *
 * @param texels its number of floats
 * @param codes what the texels' codes stand for; of none if they are not packed
 */
@SuppressWarnings("ArrayRecordComponent") // written in place
record MapContent(long texels, float[] codes, Writer writer) {
    private static final float[] NOT_PACKED = {};

    /** Writes the texels behind each other. */
    private interface Writer {
        void write(float[] target, int start);
    }

    static MapContent of(MapUse use, SceneImages images) {
        return switch (use.image(images)) {
            case Skybox image -> ofFloats(image, use.content());
            case PackedImage image -> ofBytes(image, use.content());
        };
    }

    boolean isPacked() {
        return codes.length > 0;
    }

    /**
     * Writes the texels, and before them the codes.
     *
     * @param start place of the first texel
     */
    void write(float[] target, int start) {
        System.arraycopy(codes, 0, target, start - codes.length, codes.length);
        writer.write(target, start);
    }

    private static MapContent ofFloats(Skybox image, MapUse.Content content) {
        return switch (content) {
            case COLOR -> floats(image.radiance());
            case NUMBERS -> floats(stored(image.radiance(), 1));
            case NORMALS -> normals(image);
            case ALPHA -> floats(image.opacity());
            case RED -> floats(stored(image.radiance(), 3));
        };
    }

    private static MapContent floats(float[] texels) {
        return new MapContent(
                texels.length,
                NOT_PACKED,
                (target, start) -> System.arraycopy(texels, 0, target, start, texels.length));
    }

    private static MapContent normals(Skybox image) {
        float[] stored = stored(image.radiance(), 1);
        boolean gray = true;
        for (int i = 0; i < stored.length && gray; i += 3) {
            gray = stored[i] == stored[i + 1] && stored[i] == stored[i + 2];
        }
        return floats(gray ? ofHeights(stored, image.width(), image.height()) : stored);
    }

    private static MapContent ofBytes(PackedImage image, MapUse.Content content) {
        return switch (content) {
            case COLOR -> packed(image, image.linear());
            case NUMBERS -> packed(image, stored(image.linear(), 1));
            case NORMALS -> normals(image);
            case ALPHA -> singles(image, 3, parts());
            case RED -> singles(image, 0, stored(image.linear(), 1));
        };
    }

    private static MapContent packed(PackedImage image, float[] codes) {
        return new MapContent(image.texels().length, codes, (target, start) -> {
            for (int texel = 0; texel < image.texels().length; texel++) {
                target[start + texel] = image.texels()[texel] & 0xffffff;
            }
        });
    }

    private static MapContent singles(PackedImage image, int channel, float[] meaning) {
        return new MapContent(image.texels().length, NOT_PACKED, (target, start) -> {
            for (int texel = 0; texel < image.texels().length; texel++) {
                target[start + texel] = meaning[image.value(texel, channel)];
            }
        });
    }

    private static MapContent normals(PackedImage image) {
        float[] codes = stored(image.linear(), 1);
        boolean gray = Arrays.stream(image.texels())
                .allMatch(texel -> (texel >> 8 & 0xff) == (texel & 0xff) && (texel >> 16 & 0xff) == (texel & 0xff));
        if (!gray) {
            return packed(image, codes);
        }
        float[] heights = new float[Layout.TEXEL_STRIDE * image.texels().length];
        for (int texel = 0; texel < image.texels().length; texel++) {
            heights[Layout.TEXEL_STRIDE * texel] = codes[image.value(texel, 0)];
        }
        return floats(ofHeights(heights, image.width(), image.height()));
    }

    /** Opacities of 8 bits. */
    private static float[] parts() {
        float[] parts = new float[PackedImage.VALUES];
        for (int value = 0; value < parts.length; value++) {
            parts[value] = value / 255f;
        }
        return parts;
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
