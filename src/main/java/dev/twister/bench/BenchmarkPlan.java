package dev.twister.bench;

import dev.twister.image.PictureSize;
import java.util.Collection;
import java.util.Collections;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;

/**
 * What to measure.
 *
 * @param engines their ids, in the order of the report
 * @param figures what each figure of the report shows, in the order of its axis; figures may share settings
 * @param warmupFrames frames drawn before the measured ones at each setting; where there are any, small pictures are
 *     drawn before an engine's first setting until they get no faster, so that compilers are done; all of them of
 *     bodies at their start, where they move
 * @param frames measured frames
 * @param maxSeconds for one engine at one setting, warm-up included, half of it at most; fewer frames are taken where
 *     it is short, but always one of each. And as long again, at most, for small pictures of each of the {@link #shown}
 *     settings
 */
public record BenchmarkPlan(
        List<String> engines,
        Map<PaperFigure, List<Setting>> figures,
        int warmupFrames,
        int frames,
        double maxSeconds) {
    public BenchmarkPlan {
        engines = List.copyOf(engines);
        figures = Collections.unmodifiableMap(new EnumMap<>(figures));
    }

    /** Engines by sizes, all with the same shadows and bounces. */
    public static BenchmarkPlan bySize(
            List<String> engines,
            List<PictureSize> sizes,
            int shadowSamples,
            int bounces,
            int warmupFrames,
            int frames,
            double maxSeconds) {
        List<Setting> settings = sizes.stream()
                .map(size -> new Setting(size, shadowSamples, bounces))
                .toList();
        return new BenchmarkPlan(engines, Map.of(PaperFigure.SIZES, settings), warmupFrames, frames, maxSeconds);
    }

    /** The same settings with other limits. */
    public BenchmarkPlan within(int newWarmupFrames, int newFrames, double newMaxSeconds) {
        return new BenchmarkPlan(engines, figures, newWarmupFrames, newFrames, newMaxSeconds);
    }

    /** A figure's settings; none where the plan is without the figure. */
    public List<Setting> settings(PaperFigure figure) {
        return figures.getOrDefault(figure, List.of());
    }

    /** Whether all settings have the same shadows and bounces, being those of a single figure. */
    public boolean hasOneFigure() {
        return figures.size() == 1;
    }

    /** All figures' settings, each once. */
    public List<Setting> settings() {
        return figures.values().stream().flatMap(Collection::stream).distinct().toList();
    }

    /** The settings whose pictures are shown: the quickest and the slowest at the first size. */
    public List<Setting> shown() {
        return Stream.of(PaperFigure.SIZES, PaperFigure.SPEEDUP)
                .flatMap(figure -> settings(figure).stream().limit(1))
                .distinct()
                .toList();
    }

    /** Frames of one engine at one setting, at most. */
    public int framesEach() {
        return warmupFrames + frames;
    }
}
