package dev.twister.bench.device;

import dev.twister.bench.benchmark.BenchmarkPlan;
import dev.twister.bench.benchmark.PaperFigure;
import dev.twister.bench.benchmark.Setting;
import dev.twister.bench.paper.PaperPlan;
import dev.twister.image.PictureSize;
import java.util.List;
import java.util.Map;

/**
 * What to check in every engine.
 *
 * @param pictureSize size of the scenes' pictures
 * @param timedSize size for the measurements, which are with hard shadows and one bounce, and with soft shadows and
 *     several bounces
 * @param warmupFrames as for {@link BenchmarkPlan#warmupFrames}
 * @param frames as for {@link BenchmarkPlan#frames}
 * @param maxSeconds as for {@link BenchmarkPlan#maxSeconds}
 */
public record DeviceCheckPlan(
        PictureSize pictureSize, PictureSize timedSize, int warmupFrames, int frames, double maxSeconds) {
    /** About two minutes for an engine of a small processor. */
    public static final DeviceCheckPlan USUAL =
            new DeviceCheckPlan(new PictureSize(640, 360), PictureSize.HD, 20, 10, 5);

    Setting quick() {
        return new Setting(timedSize, PaperPlan.HARD_SHADOW_SAMPLES, PaperPlan.FEW_BOUNCES);
    }

    Setting slow() {
        return new Setting(timedSize, PaperPlan.SOFT_SHADOW_SAMPLES, PaperPlan.MANY_BOUNCES);
    }

    BenchmarkPlan timed(String engine) {
        return new BenchmarkPlan(
                List.of(engine),
                Map.of(PaperFigure.SIZES, List.of(quick()), PaperFigure.SPEEDUP, List.of(slow())),
                warmupFrames,
                frames,
                maxSeconds);
    }

    /** Maximum number of frames per engine for a number of scenes, including references and warm-up. */
    public int framesEach(int scenes) {
        return scenes + 2 + 1 + 2 * (warmupFrames + frames);
    }
}
