package dev.twister.gui.drawing;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.engine.EngineOffer;
import dev.twister.gui.WindowScenes;
import dev.twister.image.Frame;
import dev.twister.image.FrameTimes;
import dev.twister.world.FrameInput;
import dev.twister.world.SampleWorld;
import java.util.ArrayList;
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
        List<Frame> onScreen = new ArrayList<>();
        Set<Frame> all = Collections.newSetFromMap(new IdentityHashMap<>());
        for (int i = 0; i < 10_000; i++) {
            if (random.nextInt(3) == 0) {
                boolean[] taken = {false};
                exchange.takeNewest().ifPresent(picture -> {
                    onScreen.addFirst(picture.frame());
                    taken[0] = true;
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
                    exchange.finished(picture(frame));
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

    private DrawnPicture picture(Frame frame) {
        number++;
        DrawingRequest request =
                new DrawingRequest(number, WindowScenes.tiny(), SIDE, SIDE, new EngineChoice(0, ENGINE), 0);
        return new DrawnPicture(frame, request, SEEN, "test", "a test", FrameTimes.NONE, 1, number, number);
    }
}
