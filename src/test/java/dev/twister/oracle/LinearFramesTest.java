package dev.twister.oracle;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.engine.JvmEngines;
import dev.twister.scene.Rgb;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Frames of linear radiance, which nothing clamps and no rounding to 8 bits smooths, against the oracle. */
class LinearFramesTest {
    /** Of the radiance, however dark: what an 8-bit white can just tell apart. */
    private static final double RELATIVE_BOUND = 1 / 255.0;

    /** Where there is hardly any light. */
    private static final double ABSOLUTE_BOUND = 1e-5;

    /**
     * One odd pixel in so many, where more than the design's: the bound is relative, so that a dark pixel's is far
     * narrower than 1 of 255, and in these scenes most edges are seen in curved mirrors, which widen a rounding.
     */
    private static final Map<String, Integer> PIXELS_AN_ODD_ONE =
            Map.of("bokeh", 2000, "mirrors", 1000, "spheres-10000", 200);

    static List<String> names() {
        return ShippedScenes.names();
    }

    @ParameterizedTest
    @MethodSource("names")
    void radianceIsTheOracles(String name) {
        LitScene quick = ShippedScenes.quick(name);
        float[] actual = Pictures.radiance(JvmEngines.SEQUENTIAL, quick);
        Oracle oracle = new Oracle(quick);
        int width = quick.scene().settings().width();
        int pixels = actual.length / 3;
        long differing = IntStream.range(0, pixels)
                .parallel()
                .filter(pixel -> isDifferent(actual, pixel, oracle.radiance(pixel % width, pixel / width)))
                .count();
        int pixelsAnOddOne = PIXELS_AN_ODD_ONE.getOrDefault(name, PictureDifference.PIXELS_AN_ODD_ONE);
        assertThat(differing * pixelsAnOddOne).isLessThanOrEqualTo(pixels);
    }

    private static boolean isDifferent(float[] actual, int pixel, Rgb expected) {
        return isDifferent(actual[3 * pixel], expected.red())
                || isDifferent(actual[3 * pixel + 1], expected.green())
                || isDifferent(actual[3 * pixel + 2], expected.blue());
    }

    /** True of a NaN too. */
    private static boolean isDifferent(float actual, double expected) {
        return !(Math.abs(actual - expected) <= RELATIVE_BOUND * expected + ABSOLUTE_BOUND);
    }
}
