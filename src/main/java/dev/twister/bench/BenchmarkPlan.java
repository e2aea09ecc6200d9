package dev.twister.bench;

import dev.twister.image.PictureSize;
import java.util.List;

/**
 * What to measure.
 *
 * @param engines their ids, in the order of the report
 * @param sizes in the order of the report
 * @param shadowSamples points on the light's disc
 * @param bounces limit of reflections
 * @param warmupFrames frames drawn before the measured ones at each size; where there are any, small pictures are drawn before
 *     an engine's first size until they get no faster, so that compilers are done; all of them of bodies at their
 *     start, where they move
 * @param frames measured frames
 * @param maxSeconds for one engine at one size, warm-up included, half of it at most; fewer frames are taken where it
 *     is short, but always one of each. And as long again, at most, for an engine's small pictures
 */
public record BenchmarkPlan(
        List<String> engines,
        List<PictureSize> sizes,
        int shadowSamples,
        int bounces,
        int warmupFrames,
        int frames,
        double maxSeconds) {
    public BenchmarkPlan {
        engines = List.copyOf(engines);
        sizes = List.copyOf(sizes);
    }
}
