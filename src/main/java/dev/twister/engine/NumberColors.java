package dev.twister.engine;

import dev.twister.image.Frame;
import dev.twister.world.Picture;
import java.awt.Color;
import java.util.stream.IntStream;

/**
 * How views that are no colors look in 8 bits. Neither exposure nor tone map applies, and every picture has the same
 * scale.
 */
public final class NumberColors {
    private static final int CHANNELS = 3;
    private static final int OPAQUE = 0xFF000000;

    /** Meters that are shown as a middle gray. */
    private static final double MIDDLE_DEPTH = 10;

    private static final float GOLDEN_RATIO = 0.618034f;
    private static final float SATURATION = 0.65f;
    private static final float BRIGHTNESS = 0.95f;

    /** Counts at the hot end of their scale; beyond, all look alike. */
    private static final double MOST_BOUNCES = 64;

    private static final double MOST_TESTS = 65_535;

    /** From cold to hot. */
    private static final int[] HEAT = {0x000000, 0x2020C0, 0x00A0C0, 0x20B040, 0xF0E020, 0xE03010, 0xFFFFFF};

    private NumberColors() {}

    /**
     * 0xAARRGGBB of each pixel.
     *
     * @param picture a view that is no color
     * @param values three floats a pixel, as a linear {@link Frame} has them
     */
    public static int[] pixels(Picture picture, float[] values) {
        int[] pixels = new int[values.length / CHANNELS];
        paint(picture, values, pixels);
        return pixels;
    }

    /** The same into pixels that are there already. */
    public static void paint(Picture picture, float[] values, int[] argb) {
        IntStream.range(0, argb.length)
                .parallel()
                .forEach(pixel -> argb[pixel] = OPAQUE | color(picture, values, CHANNELS * pixel));
    }

    private static int color(Picture picture, float[] values, int at) {
        return switch (picture) {
            case DEPTH -> gray(values[at] > 0 ? MIDDLE_DEPTH / (MIDDLE_DEPTH + values[at]) : 0);
            case BODY -> body(Math.round(values[at]));
            case SHADOW -> gray(values[at]);
            case BOUNCES -> heat(values[at], MOST_BOUNCES);
            case TESTS -> heat(values[at], MOST_TESTS);
            default -> level(values[at]) << 16 | level(values[at + 1]) << 8 | level(values[at + 2]);
        };
    }

    /** Nothing is black, the light white; bodies that follow each other differ. */
    private static int body(int number) {
        int color = number < 0 ? 0 : 0xFFFFFF;
        return number > 0 ? Color.HSBtoRGB(number * GOLDEN_RATIO, SATURATION, BRIGHTNESS) : color;
    }

    /** On a logarithmic scale, from 0 to the most. */
    private static int heat(double count, double most) {
        double place = Math.min(Math.log1p(count) / Math.log1p(most), 1) * (HEAT.length - 1);
        int colder = Math.min((int) place, HEAT.length - 2);
        double hotter = place - colder;
        int color = 0;
        for (int shift = 16; shift >= 0; shift -= 8) {
            double low = HEAT[colder] >> shift & 0xFF;
            double high = HEAT[colder + 1] >> shift & 0xFF;
            color |= level((low + (high - low) * hotter) / 255) << shift;
        }
        return color;
    }

    private static int gray(double value) {
        return 0x010101 * level(value);
    }

    private static int level(double value) {
        return Math.clamp(Math.round(255 * value), 0, 255);
    }
}
