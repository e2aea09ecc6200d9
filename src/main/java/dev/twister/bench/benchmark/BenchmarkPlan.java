package dev.twister.bench.benchmark;

import dev.twister.engine.JvmEngines;
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
 * @param figures settings of each figure in the report, in the order of its axis; figures may share settings
 * @param warmupFrames frames before the measured ones at each setting. If there are any, small frames are rendered
 *     before an engine's first setting until their times settle, so that compilers have finished. Moving bodies stay at
 *     their start meanwhile.
 * @param frames measured frames
 * @param maxSeconds limit per engine and setting, of which warm-up takes at most half; if it is short, fewer frames are
 *     measured, but always at least one of each, and 6 of a device's warm-up. Small frames have the same limit for each
 *     of the {@link #shown} settings.
 */
public record BenchmarkPlan(
        List<String> engines,
        Map<PaperFigure, List<Setting>> figures,
        int warmupFrames,
        int frames,
        double maxSeconds) {
    /** The engine whose pictures are the reference. */
    public static final String REFERENCE = JvmEngines.SEQUENTIAL;

    public BenchmarkPlan {
        engines = List.copyOf(engines);
        figures = Collections.unmodifiableMap(new EnumMap<>(figures));
    }

    /**
     * A plan by size.
     *
     * @param settings of all sizes, with the same shading
     */
    public static BenchmarkPlan bySize(
            List<String> engines, List<Setting> settings, int warmupFrames, int frames, double maxSeconds) {
        return new BenchmarkPlan(engines, Map.of(PaperFigure.SIZES, settings), warmupFrames, frames, maxSeconds);
    }

    /** The same settings with other limits. */
    public BenchmarkPlan within(int newWarmupFrames, int newFrames, double newMaxSeconds) {
        return new BenchmarkPlan(engines, figures, newWarmupFrames, newFrames, newMaxSeconds);
    }

    /** A figure's settings; empty if the plan does not include the figure. */
    public List<Setting> settings(PaperFigure figure) {
        return figures.getOrDefault(figure, List.of());
    }

    /** Whether all settings belong to a single figure, with the same shadows and bounces. */
    public boolean hasOneFigure() {
        return figures.size() == 1;
    }

    /** The settings of all figures, without duplicates. */
    public List<Setting> settings() {
        return figures.values().stream().flatMap(Collection::stream).distinct().toList();
    }

    /** The settings whose pictures are shown: the fastest and the slowest one at the first size. */
    public List<Setting> shown() {
        return Stream.of(PaperFigure.SIZES, PaperFigure.SPEEDUP)
                .flatMap(figure -> settings(figure).stream().limit(1))
                .distinct()
                .toList();
    }

    /** Maximum number of frames per engine and setting. */
    public int framesEach() {
        return warmupFrames + frames;
    }
}
