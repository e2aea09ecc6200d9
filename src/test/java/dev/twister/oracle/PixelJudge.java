package dev.twister.oracle;

import dev.twister.scene.Scene;
import dev.twister.sky.Skybox;
import java.util.ArrayList;
import java.util.List;

/**
 * Holds pictures to the oracle, pixel by pixel, and counts. A pixel that differs is excused only where the oracle
 * itself swings as far as the engine's value once the view ray is moved by a few roundings of a float; any other is a
 * bug.
 */
public final class PixelJudge {
    private long pixels;
    private long excused;

    /**
     * Judges one picture of 0xAARRGGBB pixels.
     *
     * @throws AssertionError where a pixel differs without an excuse
     */
    public void judge(int[] actual, Scene scene, Skybox sky) {
        judge(actual, new LitScene(scene, sky));
    }

    /**
     * The same of a scene with textures.
     *
     * @throws AssertionError where a pixel differs without an excuse
     */
    public void judge(int[] actual, LitScene scene) {
        Oracle oracle = new Oracle(scene);
        judgeAgainst(oracle.picture(), actual, scene.scene(), oracle);
    }

    /**
     * Judges one picture by another's pixels; the oracle is asked for excuses only.
     *
     * @throws AssertionError where a pixel differs without an excuse
     */
    public void judgeAgainst(int[] expected, int[] actual, Scene scene, Skybox sky) {
        judgeAgainst(expected, actual, scene, new Oracle(scene, sky));
    }

    private void judgeAgainst(int[] expected, int[] actual, Scene scene, Oracle oracle) {
        PictureDifference difference = PictureDifference.between(actual, expected);
        List<String> faults = new ArrayList<>();
        int width = scene.settings().width();
        for (int pixel : difference.differing()) {
            PixelSpan span = oracle.span(pixel % width, pixel / width);
            if (span.holds(actual[pixel])) {
                excused++;
            } else {
                faults.add("(%d, %d): %08x, but %08x is expected, in %08x to %08x when moved"
                        .formatted(
                                pixel % width,
                                pixel / width,
                                actual[pixel],
                                expected[pixel],
                                span.lowest(),
                                span.highest()));
            }
        }
        pixels += actual.length;
        if (!faults.isEmpty()) {
            throw new AssertionError(faults.size() + " pixels differ without an excuse: "
                    + String.join("; ", faults.subList(0, Math.min(5, faults.size()))) + "; scene " + scene);
        }
    }

    /** All pixels that were judged so far. */
    public long pixels() {
        return pixels;
    }

    /** Those that differed and were excused. */
    public long excused() {
        return excused;
    }

    /**
     * Ends the count.
     *
     * @throws AssertionError where more than 1 pixel in so many had to be excused
     */
    public void requireExcusedAtMostOneIn(long pixelsAnExcuse) {
        if (excused * pixelsAnExcuse > pixels) {
            throw new AssertionError(
                    excused + " of " + pixels + " pixels were excused, more than 1 in " + pixelsAnExcuse);
        }
    }
}
