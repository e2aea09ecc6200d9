package dev.twister.engine;

import dev.twister.image.Frame;
import dev.twister.world.StageOrView;
import java.awt.Color;
import java.util.stream.IntStream;

/** 8-bit colors for views whose values are not colors. Exposure and tone map do not apply, and the scale is fixed. */
public final class NumberColors {
    private static final int CHANNELS = 3;
    private static final int OPAQUE = 0xFF000000;

    /** Depth in meters that is shown as middle gray. */
    private static final double MIDDLE_DEPTH = 10;

    private static final float GOLDEN_RATIO = 0.618034f;
    private static final float SATURATION = 0.65f;
    private static final float BRIGHTNESS = 0.95f;

    /** Counts at the hot end of the scale; larger ones look the same. */
    private static final double MOST_BOUNCES = 64;

    private static final double MOST_TESTS = 65_535;

    /** RGB colors from cold to hot. */
    private static final int[] HEAT = {0x000000, 0x2020C0, 0x00A0C0, 0x20B040, 0xF0E020, 0xE03010, 0xFFFFFF};

    private NumberColors() {}

    /**
     * The 0xAARRGGBB value of each pixel.
     *
     * @param picture a view whose values are not colors
     * @param values three floats per pixel, as in a linear {@link Frame}
     */
    public static int[] pixels(StageOrView picture, float[] values) {
        int[] pixels = new int[values.length / CHANNELS];
        paint(picture, values, pixels);
        return pixels;
    }

    /** As above, into existing pixels. */
    public static void paint(StageOrView picture, float[] values, int[] argb) {
        IntStream.range(0, argb.length)
                .parallel()
                .forEach(pixel -> argb[pixel] = OPAQUE | color(picture, values, CHANNELS * pixel));
    }

    private static int color(StageOrView picture, float[] values, int at) {
        return switch (picture) {
            case DEPTH -> gray(values[at] > 0 ? MIDDLE_DEPTH / (MIDDLE_DEPTH + values[at]) : 0);
            case BODY -> body(Math.round(values[at]));
            case SHADOW -> gray(values[at]);
            case BOUNCES -> heat(values[at], MOST_BOUNCES);
            case TESTS -> heat(values[at], MOST_TESTS);
            default -> level(values[at]) << 16 | level(values[at + 1]) << 8 | level(values[at + 2]);
        };
    }

    /** No body is black and the light is white; adjacent numbers get different hues. */
    private static int body(int number) {
        int color = number < 0 ? 0 : 0xFFFFFF;
        return number > 0 ? Color.HSBtoRGB(number * GOLDEN_RATIO, SATURATION, BRIGHTNESS) : color;
    }

    /** A color on a logarithmic scale from 0 to {@code most}. */
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
