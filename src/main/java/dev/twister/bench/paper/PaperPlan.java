package dev.twister.bench.paper;

import dev.twister.bench.benchmark.BenchmarkPlan;
import dev.twister.bench.benchmark.PaperFigure;
import dev.twister.bench.benchmark.Setting;
import dev.twister.image.PictureSize;
import java.util.List;
import java.util.Map;

/** The settings of the paper's evaluation. */
public final class PaperPlan {
    /** Shadow samples of the first figure, for hard shadows. */
    public static final int HARD_SHADOW_SAMPLES = 1;

    /** Bounces of the first and second figure. */
    public static final int FEW_BOUNCES = 1;

    /** Shadow samples of the third and last figure. */
    public static final int SOFT_SHADOW_SAMPLES = 200;

    /** Bounces of the last figure. */
    public static final int MANY_BOUNCES = 3;

    private static final List<PictureSize> SIZES = List.of(PictureSize.HD, PictureSize.FULL_HD, PictureSize.ULTRA_HD);
    private static final List<Integer> SHADOW_SAMPLES = List.of(1, 50, 100, 200, 300, 400);
    private static final List<Integer> BOUNCES = List.of(1, 2, 3, 4, 5, 6);
    private static final int FULL_WARMUP = 100;
    private static final int FULL_FRAMES = 20;
    private static final double FULL_SECONDS = 30;
    private static final int QUICK_WARMUP = 20;
    private static final int QUICK_FRAMES = 10;
    private static final double QUICK_SECONDS = 4;

    /** Leaves time within ten minutes for compilers, reference pictures and frames that exceed their limit. */
    private static final double QUICK_SECONDS_IN_ALL = 360;

    private PaperPlan() {}

    /** The full evaluation. */
    public static BenchmarkPlan full(List<String> engines) {
        return of(engines, SIZES, SHADOW_SAMPLES, BOUNCES).within(FULL_WARMUP, FULL_FRAMES, FULL_SECONDS);
    }

    /** The same settings within ten minutes on two cores, for any number of engines. */
    public static BenchmarkPlan quick(List<String> engines) {
        BenchmarkPlan plan = of(engines, SIZES, SHADOW_SAMPLES, BOUNCES);
        double share = QUICK_SECONDS_IN_ALL
                / Math.max(1, engines.size() * plan.settings().size());
        return plan.within(QUICK_WARMUP, QUICK_FRAMES, Math.min(QUICK_SECONDS, share));
    }

    /**
     * The figures at other settings, with one frame each and no warm-up.
     *
     * @param sizes sizes of the first and last figure; the other figures use the first size
     * @param shadowSamples shadow samples of the second figure
     * @param bounces bounces of the third figure
     */
    public static BenchmarkPlan of(
            List<String> engines, List<PictureSize> sizes, List<Integer> shadowSamples, List<Integer> bounces) {
        PictureSize usual = sizes.getFirst();
        return new BenchmarkPlan(
                engines,
                Map.of(
                        PaperFigure.SIZES,
                        sizes.stream()
                                .map(size -> new Setting(size, HARD_SHADOW_SAMPLES, FEW_BOUNCES))
                                .toList(),
                        PaperFigure.SHADOW_SAMPLES,
                        shadowSamples.stream()
                                .map(samples -> new Setting(usual, samples, FEW_BOUNCES))
                                .toList(),
                        PaperFigure.BOUNCES,
                        bounces.stream()
                                .map(limit -> new Setting(usual, SOFT_SHADOW_SAMPLES, limit))
                                .toList(),
                        PaperFigure.SPEEDUP,
                        sizes.stream()
                                .map(size -> new Setting(size, SOFT_SHADOW_SAMPLES, MANY_BOUNCES))
                                .toList()),
                0,
                1,
                FULL_SECONDS);
    }
}
