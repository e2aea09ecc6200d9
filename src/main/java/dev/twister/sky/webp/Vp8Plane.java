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
}
