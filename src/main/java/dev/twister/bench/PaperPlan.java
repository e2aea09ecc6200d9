package dev.twister.bench;

import dev.twister.image.PictureSize;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Stream;

/**
 * The paper's evaluation: which settings its figures have.
 *
 * @param engines their ids, in the order of the report
 * @param sizes of the first and the last figure; the first of them is that of the other figures
 * @param shadowSamples of the second figure
 * @param bounces of the third figure
 * @param warmupFrames frames drawn before the measured ones
 * @param frames measured frames
 * @param maxSeconds for one engine at one setting; fewer frames are taken where it is short, but always one of each
 */
public record PaperPlan(
        List<String> engines,
        List<PictureSize> sizes,
        List<Integer> shadowSamples,
        List<Integer> bounces,
        int warmupFrames,
        int frames,
        double maxSeconds) {
    /** The hard shadow of the first figure. */
    public static final int HARD_SHADOW_SAMPLES = 1;

    /** Bounces of the first and the second figure. */
    public static final int FEW_BOUNCES = 1;

    /** Shadow samples of the third and the last figure. */
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

    /** Leaves room within ten minutes for compilers, reference pictures and frames that take longer than their time. */
    private static final double QUICK_SECONDS_IN_ALL = 360;

    public PaperPlan {
        engines = List.copyOf(engines);
        sizes = List.copyOf(sizes);
        shadowSamples = List.copyOf(shadowSamples);
        bounces = List.copyOf(bounces);
    }

    /** The evaluation in full. */
    public static PaperPlan full(List<String> engines) {
        return new PaperPlan(engines, SIZES, SHADOW_SAMPLES, BOUNCES, FULL_WARMUP, FULL_FRAMES, FULL_SECONDS);
    }

    /** The same settings within ten minutes on two cores, however many engines there are. */
    public static PaperPlan quick(List<String> engines) {
        PaperPlan plan =
                new PaperPlan(engines, SIZES, SHADOW_SAMPLES, BOUNCES, QUICK_WARMUP, QUICK_FRAMES, QUICK_SECONDS);
        double share = QUICK_SECONDS_IN_ALL
                / Math.max(1, engines.size() * plan.settings().size());
        return plan.within(QUICK_WARMUP, QUICK_FRAMES, Math.min(QUICK_SECONDS, share));
    }

    /** The same settings with other limits. */
    public PaperPlan within(int newWarmupFrames, int newFrames, double newMaxSeconds) {
        return new PaperPlan(engines, sizes, shadowSamples, bounces, newWarmupFrames, newFrames, newMaxSeconds);
    }

    /** A figure's settings, in the order of its axis. */
    public List<PaperSetting> settings(PaperFigure figure) {
        PictureSize usual = sizes.getFirst();
        return switch (figure) {
            case SIZES ->
                sizes.stream()
                        .map(size -> new PaperSetting(size, HARD_SHADOW_SAMPLES, FEW_BOUNCES))
                        .toList();
            case SHADOW_SAMPLES ->
                shadowSamples.stream()
                        .map(samples -> new PaperSetting(usual, samples, FEW_BOUNCES))
                        .toList();
            case BOUNCES ->
                bounces.stream()
                        .map(limit -> new PaperSetting(usual, SOFT_SHADOW_SAMPLES, limit))
                        .toList();
            case SPEEDUP ->
                sizes.stream()
                        .map(size -> new PaperSetting(size, SOFT_SHADOW_SAMPLES, MANY_BOUNCES))
                        .toList();
        };
    }

    /** All figures' settings, each once: figures share some. */
    public List<PaperSetting> settings() {
        return Arrays.stream(PaperFigure.values())
                .flatMap(figure -> settings(figure).stream())
                .distinct()
                .toList();
    }

    /** The settings whose pictures are shown. */
    public List<PaperSetting> shown() {
        return Stream.of(
                        settings(PaperFigure.SIZES).getFirst(),
                        settings(PaperFigure.SPEEDUP).getFirst())
                .distinct()
                .toList();
    }

    /** Frames of one engine at one setting, at most. */
    public int framesEach() {
        return warmupFrames + frames;
    }
}
