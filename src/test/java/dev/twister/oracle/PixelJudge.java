package dev.twister.oracle;

import dev.twister.scene.Scene;
import dev.twister.sky.Skybox;
import java.util.ArrayList;
import java.util.List;

/**
 * Compares pictures with the oracle pixel by pixel and counts. A differing pixel is excused only if the oracle itself
 * reaches the engine's value when the view ray is perturbed by a few float roundings; any other is a bug.
 */
public final class PixelJudge {
    private long pixels;
    private long excused;

    /**
     * Judges one picture of 0xAARRGGBB pixels.
     *
     * @throws AssertionError if a pixel differs without an excuse
     */
    public void judge(int[] actual, Scene scene, Skybox sky) {
        judge(actual, new LitScene(scene, sky));
    }

    /**
     * Judges one picture of a scene with textures.
     *
     * @throws AssertionError if a pixel differs without an excuse
     */
    public void judge(int[] actual, LitScene scene) {
        Oracle oracle = new Oracle(scene);
        judgeAgainst(oracle.picture(), actual, scene.scene(), oracle);
    }

    /**
     * Judges one picture by reference pixels; the oracle is used for excuses only.
     *
     * @throws AssertionError if a pixel differs without an excuse
     */
    public void judgeAgainst(int[] expected, int[] actual, Scene scene, Skybox sky) {
        judgeAgainst(expected, actual, scene, new Oracle(scene, sky));
    }

    private void judgeAgainst(int[] expected, int[] actual, Scene scene, Oracle oracle) {
        PictureDifference difference = PictureDifference.between(actual, expected);
        List<String> faults = new ArrayList<>();
        int width = scene.rendering().width();
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

    /** Returns the number of pixels judged so far. */
    public long pixels() {
        return pixels;
    }

    /** Returns the number of pixels that differed and were excused. */
    public long excused() {
        return excused;
    }

    /**
     * Checks the rate of excused pixels.
     *
     * @throws AssertionError if more than 1 pixel in this many was excused
     */
    public void requireExcusedAtMostOneIn(long pixelsAnExcuse) {
        if (excused * pixelsAnExcuse > pixels) {
            throw new AssertionError(
                    excused + " of " + pixels + " pixels were excused, more than 1 in " + pixelsAnExcuse);
        }
    }
}
