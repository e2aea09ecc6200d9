package dev.twister.gui.drawing;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.engine.EngineOffer;
import dev.twister.gui.WindowScenes;
import dev.twister.gui.drawing.DrawingRequest.EngineChoice;
import dev.twister.gui.drawing.DrawnPicture.Gathered;
import dev.twister.image.Frame;
import dev.twister.image.FrameTimes;
import dev.twister.world.FrameInput;
import dev.twister.world.SampleWorld;
import dev.twister.world.SceneMeshes;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.HashSet;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Random;
import java.util.Set;
import org.junit.jupiter.api.Test;

class PictureExchangeTest {
    private static final EngineOffer ENGINE = new TestEngine.Kind("test", 0).offer();
    private static final int SIDE = 4;
    private static final FrameInput SEEN = SampleWorld.ofSize(SIDE, SIDE).snapshot();

    private final PictureExchange exchange = new PictureExchange();
    private long number;

    @Test
    void theNewestIsTakenOnce() {
        exchange.finished(picture(exchange.frameToDraw(SIDE, SIDE)));
        DrawnPicture newest = picture(exchange.frameToDraw(SIDE, SIDE));
        exchange.finished(newest);

        assertThat(exchange.takeNewest()).contains(newest);
        assertThat(exchange.takeNewest()).isEmpty();
    }

    @Test
    void whatIsShownOrWasUntilTheLastPulseIsNotDrawnOver() {
        Random random = new Random(20261121);
        long original = 0;
        List<Frame> onScreen = new ArrayList<>();
        Set<Frame> all = Collections.newSetFromMap(new IdentityHashMap<>());
        for (int i = 0; i < 10_000; i++) {
            if (random.nextInt(3) == 0) {
                boolean[] taken = {false};
                exchange.takeNewest().ifPresent(picture -> {
                    if (onScreen.isEmpty() || onScreen.getFirst() != picture.frame()) {
                        onScreen.addFirst(picture.frame());
                        taken[0] = true;
                    }
                    assertThat(picture.frame().argb()).containsOnly((int) picture.original());
                });
                while (onScreen.size() > (taken[0] ? 2 : 1)) {
                    onScreen.removeLast();
                }
            } else {
                Frame frame = exchange.frameToDraw(SIDE, SIDE);
                assertThat(onScreen).noneMatch(shown -> shown == frame);
                all.add(frame);
                if (random.nextInt(5) == 0) {
                    exchange.abandon(frame);
                } else {
                    original = original > 0 && random.nextBoolean() ? original : number + 1;
                    Arrays.fill(frame.argb(), (int) original);
                    exchange.finished(repetition(frame, original));
                }
            }
        }
        assertThat(all).hasSizeLessThanOrEqualTo(4);
    }

    @Test
    void framesOfAnotherSizeAreLetGo() {
        Frame old = exchange.frameToDraw(SIDE, SIDE);
        exchange.abandon(old);
        Frame wide = exchange.frameToDraw(2 * SIDE, SIDE);
        exchange.abandon(wide);

        assertThat(wide.width()).isEqualTo(2 * SIDE);
        assertThat(new HashSet<>(List.of(exchange.frameToDraw(SIDE, SIDE)))).doesNotContain(old);
    }

    @Test
    void aRepetitionComesInTheFrameThatIsShown() {
        DrawnPicture first = picture(exchange.frameToDraw(SIDE, SIDE));
        exchange.finished(first);
        exchange.takeNewest();
        Frame second = exchange.frameToDraw(SIDE, SIDE);
        exchange.finished(repetition(second, first.number()));

        DrawnPicture taken = exchange.takeNewest().orElseThrow();

        assertThat(taken.frame()).isSameAs(first.frame());
        assertThat(taken.number()).isEqualTo(2);
        assertThat(exchange.takeNewest()).isEmpty();
        // No one has seen it, so that it can be drawn over at once.
        assertThat(exchange.frameToDraw(SIDE, SIDE)).isSameAs(second);
    }

    @Test
    void aRepetitionOfWhatWasNotTakenIsShown() {
        exchange.finished(picture(exchange.frameToDraw(SIDE, SIDE)));
        DrawnPicture shown = exchange.takeNewest().orElseThrow();
        DrawnPicture second = picture(exchange.frameToDraw(SIDE, SIDE));
        exchange.finished(second);
        DrawnPicture third = repetition(exchange.frameToDraw(SIDE, SIDE), second.number());
        exchange.finished(third);

        assertThat(exchange.takeNewest()).contains(third);
        assertThat(third.frame()).isNotSameAs(shown.frame());
    }

    private DrawnPicture picture(Frame frame) {
        return repetition(frame, number + 1);
    }

    private DrawnPicture repetition(Frame frame, long original) {
        number++;
        DrawingRequest request =
                new DrawingRequest(number, WindowScenes.tiny(), SIDE, SIDE, new EngineChoice(0, ENGINE), 0);
        return new DrawnPicture(
                frame,
                request,
                SEEN,
                SceneMeshes.NONE,
                "test",
                "a test",
                FrameTimes.NONE,
                Gathered.of(1),
                number,
                original,
                number);
    }
}
