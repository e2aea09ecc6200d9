package dev.twister.gui.studio;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import dev.twister.engine.JvmEngines;
import dev.twister.gui.WindowScenes;
import dev.twister.gui.drawing.DrawingRequest;
import dev.twister.gui.drawing.DrawingRequest.EngineChoice;
import dev.twister.gui.drawing.DrawnPicture;
import dev.twister.gui.drawing.DrawnPicture.Gathered;
import dev.twister.gui.picture.FrameTimesView;
import dev.twister.gui.picture.FrameTimesView.GraphScale;
import dev.twister.image.Frame;
import dev.twister.image.FrameTimes;
import dev.twister.world.SampleWorld;
import dev.twister.world.SceneMeshes;
import java.util.Optional;
import org.junit.jupiter.api.Test;

class FrameHistoryTest {
    private static final long MILLI = 1_000_000;

    private final FrameHistory history = new FrameHistory();

    @Test
    void countsPicturesThatWereNotShownToo() {
        for (int i = 0; i <= 60; i++) {
            history.add(picture(3L * i, i * 1000L * MILLI / 60), 0.1);
        }

        assertThat(history.framesPerSecond(1000 * MILLI)).isCloseTo(180, within(0.5));
    }

    @Test
    void aSlowEngineHasARateToo() {
        history.add(picture(1, 0), 0.1);
        assertThat(history.framesPerSecond(0)).isZero();
        history.add(picture(2, 4000 * MILLI), 0.1);
        history.add(picture(3, 8000 * MILLI), 0.1);

        assertThat(history.framesPerSecond(8000 * MILLI)).isCloseTo(0.25, within(1e-9));
        assertThat(history.framesPerSecond(19_000 * MILLI)).isCloseTo(0.25, within(1e-9));
        assertThat(history.framesPerSecond(21_000 * MILLI)).isZero();
    }

    @Test
    void atRestThereIsNoRate() {
        for (int i = 0; i <= 60; i++) {
            history.add(picture(i, i * 1000L * MILLI / 60), 0.1);
        }

        assertThat(history.framesPerSecond(2900 * MILLI)).isPositive();
        assertThat(history.framesPerSecond(3100 * MILLI)).isZero();
        assertThat(history.entries(10_500 * MILLI)).hasSize(31);
        assertThat(history.entries(12_000 * MILLI)).isEmpty();
    }

    @Test
    void forgetsWhatIsOlderThanTenSeconds() {
        for (int i = 0; i < 100; i++) {
            history.add(picture(i, i * 1000L * MILLI), 0.1);
        }

        assertThat(history.entries(99_000 * MILLI)).hasSize(11);
    }

    @Test
    void tellsTheTransferApart() {
        history.add(picture(1, 0), 0.25);

        assertThat(history.mean().renderMillis()).isCloseTo(7, within(1e-9));
        assertThat(history.mean().transferMillis()).isCloseTo(3, within(1e-9));
        assertThat(FrameTimesView.parts(history, 0, Optional.empty()))
                .containsExactly(
                        "0.0\u00a0FPS",
                        "render\u00a07.0\u00a0ms",
                        "transfer\u00a03.0\u00a0ms",
                        "display\u00a00.25\u00a0ms");
    }

    @Test
    void aSlowEnginesRateIsNotNothing() {
        history.add(picture(1, 0), 0.1);
        history.add(picture(2, 40_000L * MILLI), 0.1);

        assertThat(FrameTimesView.parts(history, 40_000L * MILLI, Optional.empty())
                        .getFirst())
                .isEqualTo("0.025\u00a0FPS");
    }

    @Test
    void theScaleIsANumberOneCanRead() {
        assertThat(GraphScale.above(0)).isEqualTo(1);
        assertThat(GraphScale.above(1.5)).isEqualTo(2);
        assertThat(GraphScale.above(16.6)).isEqualTo(20);
        assertThat(GraphScale.above(100)).isEqualTo(100);
        assertThat(GraphScale.above(5001)).isEqualTo(10_000);
        assertThat(GraphScale.label(20, 20)).isEqualTo("20 ms");
        assertThat(GraphScale.label(2.5, 5)).isEqualTo("2.5 ms");
        assertThat(GraphScale.label(1000, 1000)).isEqualTo("1000 ms");
        assertThat(GraphScale.label(1000, 2000)).isEqualTo("1 s");
        assertThat(GraphScale.label(2500, 5000)).isEqualTo("2.5 s");
        assertThat(GraphScale.label(10_000, 10_000)).isEqualTo("10 s");
    }

    private static DrawnPicture picture(long number, long nanos) {
        DrawingRequest request =
                new DrawingRequest(1, WindowScenes.tiny(), 2, 2, new EngineChoice(0, JvmEngines.parallel()), 0);
        FrameTimes times = new FrameTimes(10 * MILLI, 7 * MILLI, MILLI, 2 * MILLI);
        return new DrawnPicture(
                Frame.ofPixels(2, 2),
                request,
                SampleWorld.ofSize(2, 2).snapshot(),
                SceneMeshes.NONE,
                "test",
                "a test",
                times,
                Gathered.of(1),
                number,
                number,
                nanos);
    }

    @Test
    void aFinishedPictureIsSaidToBeIdle() {
        assertThat(FrameTimesView.parts(new FrameHistory(), 0, Optional.of(64)).getFirst())
                .isEqualTo("idle,\u00a064\u00a0samples\u00a0per\u00a0pixel");
    }
}
