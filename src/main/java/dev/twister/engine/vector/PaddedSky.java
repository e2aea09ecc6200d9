package dev.twister.engine.vector;

import dev.twister.kernel.Layout;
import dev.twister.world.FrameInput;

/**
 * The panorama with four floats a texel and a border of one texel, which wraps in the columns and repeats in the rows:
 * the four texels about any direction then lie at fixed distances, and each is one short vector. Kept while the input's
 * sky is the same.
 */
final class PaddedSky {
    static final int FLOATS_A_TEXEL = 3;

    float[] texels = {};

    /** In texels, without the border. */
    int width;

    int height;

    private float[] source;

    /** Texels from one row to the next. */
    int stride() {
        return width + 2;
    }

    @SuppressWarnings("ReferenceEquality") // an input's arrays never change
    void take(FrameInput input) {
        if (input.skybox() != source) {
            source = input.skybox();
            width = input.skyboxDimensions()[Layout.SKYBOX_WIDTH];
            height = input.skyboxDimensions()[Layout.SKYBOX_HEIGHT];
            texels = new float[1 + Math.multiplyExact(FLOATS_A_TEXEL, Math.multiplyExact(stride(), height + 2))];
            for (int row = -1; row <= height; row++) {
                copyRow(row);
            }
        }
    }

    private void copyRow(int row) {
        int from = 3 * width * Math.clamp(row, 0, height - 1);
        int to = FLOATS_A_TEXEL * stride() * (row + 1);
        for (int column = -1; column <= width; column++) {
            int texel = from + 3 * Math.floorMod(column, width);
            texels[to] = source[texel];
            texels[to + 1] = source[texel + 1];
            texels[to + 2] = source[texel + 2];
            to += FLOATS_A_TEXEL;
        }
    }
}
