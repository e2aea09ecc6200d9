package dev.twister.engine;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import dev.twister.image.Frame;
import dev.twister.image.FrameStop;
import dev.twister.image.RenderStoppedException;
import dev.twister.oracle.ShippedScenes;
import dev.twister.world.FrameInput;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.concurrent.ConcurrentSkipListSet;
import java.util.concurrent.atomic.AtomicBoolean;
import org.junit.jupiter.api.RepeatedTest;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Frames of which several engines render bands. */
class AllEngineTest {
    /** Of all engines, of two and of one. */
    private static final int FRAMES = 17;

    private final Set<Integer> heights = new ConcurrentSkipListSet<>();
    private final AtomicBoolean closed = new AtomicBoolean();

    /** Renders as {@code sequential}, but says that it compiles for each height, as a device does. */
    private final class ForEachHeight implements Engine {
        private final Engine sequential = Engines.open(JvmEngines.SEQUENTIAL);

        @Override
        public String id() {
            return "compiling";
        }

        @Override
        public String device() {
            return "a test";
        }

        @Override
        public void render(FrameInput input, Frame frame) {
            heights.add(frame.height());
            sequential.render(input, frame);
        }

        @Override
        public void close() {
            closed.set(true);
        }
    }

    /** Fails at each frame. */
    private record Broken(String id, String device) implements Engine {
        @Override
        public void render(FrameInput input, Frame frame) {
            throw new EngineException("the device is lost");
        }

        @Override
        public void close() {
            // It holds nothing.
        }
    }

    private static Engine together(Engine... others) {
        List<Engine> all = new ArrayList<>(List.of(others));
        all.addFirst(JvmEngines.parallel().opener().get());
        return new AllEngine(all);
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 2, 15, 16, 17, 87})
    void pictureIsThatOfOneEngine(int height) {
        FrameInput input = input(67, height);
        Frame expected = Frame.ofPixels(67, height);
        Engines.open(JvmEngines.SEQUENTIAL).render(input, expected);
        try (Engine all = together(new ForEachHeight(), new ForEachHeight())) {
            for (int i = 0; i < FRAMES; i++) {
                Frame frame = Frame.ofPixels(67, height);
                all.render(input, frame);
                assertThat(frame.argb()).isEqualTo(expected.argb());
                assertThat(frame.times().totalNanos()).isPositive();
            }
        }
    }

    @Test
    void bandOfAPictureAndLinearFramesAreThoseOfOneEngine() {
        FrameInput band = input(67, 87).band(20, 50);
        Frame expected = Frame.ofRadiance(67, 50);
        Engines.open(JvmEngines.SEQUENTIAL).render(band, expected);
        try (Engine all = together(new ForEachHeight())) {
            all.render(input(67, 87), Frame.ofPixels(67, 87));
            Frame frame = Frame.ofRadiance(67, 50);
            all.render(band, frame);
            assertThat(frame.radiance()).isEqualTo(expected.radiance());
        }
    }

    @Test
    void anEngineThatCompilesForEachHeightGetsOneBeforeItsSpeedIsKnownAndOneAfterAndTheWhole() {
        try (Engine all = together(new ForEachHeight())) {
            for (int i = 0; i < FRAMES; i++) {
                all.render(input(160, 160), Frame.ofPixels(160, 160));
            }
        }
        assertThat(heights).hasSizeBetween(1, 3);
        assertThat(closed).isTrue();
    }

    /** Repeated, because engines may fail before the frame waits for them, or after. */
    @RepeatedTest(50)
    void theFailureOfAnEngineIsTheFrames() {
        // Another engine might take all bands before this one begins.
        Engine broken = new Broken("broken", "a test");
        try (Engine all = new AllEngine(List.of(broken, broken))) {
            assertThatThrownBy(() -> all.render(input(160, 160), Frame.ofPixels(160, 160)))
                    .isInstanceOf(EngineException.class)
                    .hasMessage("the device is lost");
        }
    }

    @Test
    void anInterruptOfTheCallerStopsAllEngines() {
        // Another engine might take all bands before this one begins.
        Engine interrupting = new Interrupting(Thread.currentThread());
        Frame frame = Frame.ofPixels(160, 160);
        try (Engine all = new AllEngine(List.of(interrupting, interrupting))) {
            assertThatThrownBy(() -> all.render(input(160, 160), frame)).isInstanceOf(RenderStoppedException.class);
        } finally {
            assertThat(Thread.interrupted()).isTrue();
        }
    }

    /** Interrupts the thread that waits for it, and renders until it is stopped. */
    private record Interrupting(Thread caller) implements Engine {
        @Override
        public String id() {
            return "interrupting";
        }

        @Override
        public String device() {
            return "a test";
        }

        @Override
        public void render(FrameInput input, Frame frame) {
            caller.interrupt();
            FrameStop stop = FrameStop.of(frame);
            while (!stop.isAsked()) {
                Thread.onSpinWait();
            }
            stop.check();
        }

        @Override
        public void close() {
            // It holds nothing.
        }
    }

    @Test
    void withoutADeviceItSaysSo() {
        EngineOffer offer = Engines.offer(AllEngines.ALL);
        boolean device = Engines.offers().stream()
                .anyMatch(other -> other.works() && Engines.isDevice(other.id()) && !other.equals(offer));

        assertThat(offer.works()).isEqualTo(device);
        assertThat(offer.obstacle().orElse("no device works here; see 'twister devices'"))
                .startsWith("no device works here; ");
    }

    private static FrameInput input(int width, int height) {
        return ShippedScenes.quick("teaching").world().snapshot().withSize(width, height);
    }
}
