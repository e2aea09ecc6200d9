package dev.twister.sky.webp;

import java.util.Arrays;

/**
 * Luma or one chroma of a frame in whole macroblocks, with a column of 129 at the left and a row of 127 above, from
 * which macroblocks at the border are predicted (RFC 6386, section 12.2).
 */
final class Vp8Plane {
    private final byte[] values;
    private final int stride;

    Vp8Plane(int width, int height) {
        stride = width + 1;
        values = new byte[stride * (height + 1)];
        for (int row = 1; row <= height; row++) {
            values[row * stride] = (byte) 129;
        }
        Arrays.fill(values, 0, stride, (byte) 127);
    }

    byte[] values() {
        return values;
    }

    /** The distance between neighbors in a column. */
    int stride() {
        return stride;
    }

    /** Where a value is; -1 is the border. */
    int at(int x, int y) {
        return (y + 1) * stride + x + 1;
    }

    int value(int index) {
        return values[index] & 0xff;
    }

    void set(int index, int value) {
        values[index] = (byte) Math.clamp(value, 0, 255);
    }

    /** Adds the inverse cosine transform of a block's 16 coefficients (section 14.4), unless all are 0. */
    void addTransformed(short[] coefficients, int first, int to) {
        if (isZero(coefficients, first)) {
            return;
        }
        int[] columns = new int[16];
        for (int i = 0; i < 4; i++) {
            int in = first + i;
            int a = coefficients[in] + coefficients[in + 8];
            int b = coefficients[in] - coefficients[in + 8];
            int c = sine(coefficients[in + 4]) - cosine(coefficients[in + 12]);
            int d = cosine(coefficients[in + 4]) + sine(coefficients[in + 12]);
            columns[4 * i] = a + d;
            columns[4 * i + 1] = b + c;
            columns[4 * i + 2] = b - c;
            columns[4 * i + 3] = a - d;
        }
        for (int i = 0; i < 4; i++) {
            int rounded = columns[i] + 4;
            int a = rounded + columns[8 + i];
            int b = rounded - columns[8 + i];
            int c = sine(columns[4 + i]) - cosine(columns[12 + i]);
            int d = cosine(columns[4 + i]) + sine(columns[12 + i]);
            int at = to + i * stride;
            set(at, value(at) + ((a + d) >> 3));
            set(at + 1, value(at + 1) + ((b + c) >> 3));
            set(at + 2, value(at + 2) + ((b - c) >> 3));
            set(at + 3, value(at + 3) + ((a - d) >> 3));
        }
    }

    private static boolean isZero(short[] coefficients, int first) {
        for (int i = first; i < first + 16; i++) {
            if (coefficients[i] != 0) {
                return false;
            }
        }
        return true;
    }

    /** Times the square root of 2 and the cosine of pi / 8. */
    private static int cosine(int value) {
        return ((value * 20_091) >> 16) + value;
    }

    /** Times the square root of 2 and the sine of pi / 8. */
    private static int sine(int value) {
        return (value * 35_468) >> 16;
    }

    /**
     * Converts a frame to red, green and blue, by the arithmetic of libwebp, with chroma interpolated between its
     * values.
     */
    static final class Vp8Colors {
        private static final int OPAQUE = 0xff << 24;

        private Vp8Colors() {}

        static int[] argb(Vp8Plane luma, Vp8Plane u, Vp8Plane v, int width, int height) {
            int[] argb = new int[width * height];
            int[] us = new int[width];
            int[] vs = new int[width];
            int chromaHeight = (height + 1) >> 1;
            for (int row = 0; row < height; row++) {
                int near = row >> 1;
                int far = Math.clamp((row & 1) == 0 ? near - 1 : near + 1, 0, chromaHeight - 1);
                interpolate(u, u.at(0, near), u.at(0, far), us);
                interpolate(v, v.at(0, near), v.at(0, far), vs);
                int from = luma.at(0, row);
                for (int column = 0; column < width; column++) {
                    argb[row * width + column] = color(luma.value(from + column), us[column], vs[column]);
                }
            }
            return argb;
        }

        /** Chroma of a row of texels, from the row of chroma that is near and the one that is farther. */
        private static void interpolate(Vp8Plane chroma, int near, int far, int[] row) {
            int width = row.length;
            for (int column = 0; column < width; column++) {
                int at = column >> 1;
                int beside = (column & 1) == 0 ? at - 1 : at + 1;
                int nearest = chroma.value(near + at);
                int across = chroma.value(far + at);
                if (beside < 0 || beside > (width - 1) >> 1) {
                    row[column] = (3 * nearest + across + 2) >> 2;
                } else {
                    int nearBeside = chroma.value(near + beside);
                    int farBeside = chroma.value(far + beside);
                    int all = nearest + across + nearBeside + farBeside + 8;
                    row[column] = (((all + 2 * (nearBeside + across)) >> 3) + nearest) >> 1;
                }
            }
        }

        private static int color(int y, int u, int v) {
            int luma = (y * 19_077) >> 8;
            int red = luma + ((v * 26_149) >> 8) - 14_234;
            int green = luma - ((u * 6_419) >> 8) - ((v * 13_320) >> 8) + 8_708;
            int blue = luma + ((u * 33_050) >> 8) - 17_685;
            return OPAQUE | channel(red) << 16 | channel(green) << 8 | channel(blue);
        }

        private static int channel(int value) {
            return Math.clamp(value >> 6, 0, 255);
        }
    }
}
