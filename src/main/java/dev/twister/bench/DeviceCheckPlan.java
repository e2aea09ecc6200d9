package dev.twister.bench;

import dev.twister.image.PictureSize;
import java.util.List;
import java.util.Map;

/**
 * What is checked of every engine.
 *
 * @param pictureSize of the scenes' pictures
 * @param timedSize of the picture that is measured, with hard shadows and one bounce, and with soft shadows and several
 * @param warmupFrames as {@link BenchmarkPlan#warmupFrames}
 * @param frames as {@link BenchmarkPlan#frames}
 * @param maxSeconds as {@link BenchmarkPlan#maxSeconds}
 */
public record DeviceCheckPlan(
        PictureSize pictureSize, PictureSize timedSize, int warmupFrames, int frames, double maxSeconds) {
    /** A minute for an engine, on a small machine. */
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

    /** Frames of one engine in this number of scenes, at most; the references and a frame's warm-up with them. */
    public int framesEach(int scenes) {
        return scenes + 2 + 1 + 2 * (warmupFrames + frames);
    }
}
