package dev.twister.engine.auto;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import dev.twister.engine.Engine;
import dev.twister.engine.EngineException;
import dev.twister.image.Frame;
import dev.twister.image.FrameTimes;
import dev.twister.world.FrameInput;
import dev.twister.world.SampleWorld;
import dev.twister.world.World;
import java.time.Duration;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.BooleanSupplier;
import java.util.function.Function;
import java.util.function.IntConsumer;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

// A thread that spins or parks as a crew does ignores interruption, so timeouts need a separate thread.
@Timeout(value = 300, threadMode = Timeout.ThreadMode.SEPARATE_THREAD)
class AutoEngineTest {
    private static final int WIDTH = 640;
    private static final int HEIGHT = 200;
    private static final int SHADOW_SAMPLES = 2;

    private final World world = SampleWorld.ofSize(WIDTH, HEIGHT);
    private final FrameInput input = ofShadows(SHADOW_SAMPLES);
    private final Frame frame = Frame.ofPixels(WIDTH, HEIGHT);
    private final CountingEngine standIn = new CountingEngine("parallel", 100);
    private final CountingEngine another = new CountingEngine("parallel", 100);

    @Test
    void theFirstFrameIsTheStandIns() {
        CountingEngine fast = new CountingEngine("vector", 1);
        try (Engine auto = auto(_ -> Optional.of(fast))) {
            auto.render(input, frame);

            assertThat(auto.id()).isEqualTo("parallel");
            assertThat(standIn.frames.get()).isEqualTo(1);
        }
    }

    @Test
    void goesOverToTheFasterAndClosesTheStandIn() {
        CountingEngine fast = new CountingEngine("vector", 99);
        try (Engine auto = auto(_ -> Optional.of(fast))) {
            renderUntil(auto, "vector");

            assertThat(standIn.closed).isOne();
            assertThat(frame.argb()).containsOnly(fast.id.hashCode());
        }
        assertThat(fast.closed).isOne();
    }

    @Test
    void aStandInGoesOnWhereTheFasterOneFails() {
        CountingEngine fast = new CountingEngine("vector", 99);
        try (Engine auto = auto(_ -> Optional.of(fast))) {
            renderUntil(auto, "vector");
            fast.pauses = _ -> {
                throw new EngineException("engine vector: out of order");
            };
            auto.render(input, frame);
            assertThat(auto.id()).isEqualTo("parallel");
            assertThat(auto.device()).isEqualTo("a device of the test's; engine vector: out of order");
            assertThat(frame.argb()).containsOnly(another.id.hashCode());
            assertThat(fast.closed).isOne();

            another.pauses = fast.pauses;
            assertThatThrownBy(() -> auto.render(input, frame)).isInstanceOf(EngineException.class);
        }
        assertThat(another.closed).isOne();
    }

    @Test
    void drawingEngineRests() {
        CountingEngine fast = new CountingEngine("vector", 99);
        try (Engine auto = auto(_ -> Optional.of(fast))) {
            auto.rest();
            assertThat(standIn.rests).isOne();
            renderUntil(auto, "vector");
            assertThat(fast.rests).isZero();
            auto.rest();
            assertThat(fast.rests).isOne();
        }
    }

    @Test
    void tellsWhenThereIsAFasterOneThoughNothingIsDrawn() throws InterruptedException {
        CountDownLatch told = new CountDownLatch(2);
        try (Engine auto = auto(_ -> Optional.of(new CountingEngine("vector", 99)))) {
            auto.onFaster(told::countDown);
            auto.render(input, frame);
            assertThat(auto.id()).isEqualTo("parallel");
            while (told.getCount() == 2) {
                Thread.onSpinWait();
            }
            // A listener that registers late is called at once.
            auto.onFaster(told::countDown);
            told.await();
            auto.render(input, frame);
            assertThat(auto.id()).isEqualTo("vector");
        }
    }

    @Test
    void theWarmUpDrawsTheSameViewSmaller() throws InterruptedException {
        CountingEngine slow = new CountingEngine("tornado:0:0", 1000);
        try (Engine auto = auto(_ -> Optional.of(slow))) {
            auto.render(input, frame);
            slow.awaitFrames(1);
        }
        assertThat(slow.lastWidth).isEqualTo(320);
        assertThat(slow.lastHeight).isEqualTo(100);
    }

    /** Rows of the sky alone take less time than others, by every engine. */
    @Test
    void theWarmUpDrawsTheRowsOfTheLatestBand() throws InterruptedException {
        CountingEngine slow = new CountingEngine("tornado:0:0", 1000);
        CountDownLatch looked = new CountDownLatch(1);
        slow.pauses = _ -> Latches.await(looked);
        Frame rows = Frame.ofPixels(WIDTH, 40);
        try (Engine auto = auto(_ -> Optional.of(slow))) {
            auto.render(input.band(0, 40), rows);
            slow.awaitFrames(1);
            assertThat(slow.lastBand).isEqualTo(List.of(0, 20));
            auto.render(input.band(80, 40), rows);
            looked.countDown();
            slow.awaitFrames(2);
            assertThat(slow.lastBand).isEqualTo(List.of(40, 20));
        }
    }

    @Test
    void otherWorkOnTheMachineDoesNotCount() {
        CountingEngine fast = new CountingEngine("vector", 1000);
        fast.processorNanosPerPixel = 99 * Runtime.getRuntime().availableProcessors();
        try (Engine auto = auto(_ -> Optional.of(fast))) {
            renderUntil(auto, "vector");
        }
        assertThat(fast.closed).isOne();
    }

    @Test
    void aSlowerOneNeverDraws() throws InterruptedException {
        CountingEngine slow = new CountingEngine("tornado:0:0", 101);
        try (Engine auto = auto(_ -> Optional.of(slow))) {
            auto.render(input, frame);
            slow.awaitFrames(20);
            auto.render(input, frame);

            assertThat(auto.id()).isEqualTo("parallel");
        }
        slow.awaitClosed();
    }

    /** The stand-in's first frame includes slow interpretation, so any engine beats that one. */
    @Test
    void oneThatBeatsOnlyTheFirstFrameNeverDraws() throws InterruptedException {
        CountingEngine slow = new CountingEngine("vector", 101);
        CountDownLatch drawn = new CountDownLatch(1);
        standIn.nanosPerPixelAtFirst = 1000;
        try (Engine auto = auto(_ -> {
            Latches.await(drawn);
            return Optional.of(slow);
        })) {
            auto.render(input, frame);
            auto.render(input, frame);
            drawn.countDown();
            slow.awaitClosed();
            auto.render(input, frame);

            assertThat(auto.id()).isEqualTo("parallel");
        }
    }

    @Test
    void oneThatIsFasterWaitsForThreeFramesToBeat() throws InterruptedException {
        CountingEngine fast = new CountingEngine("vector", 1);
        CountDownLatch threeDrawn = new CountDownLatch(1);
        int frames = 5;
        fast.pauses = frame -> {
            if (frame == frames) {
                Latches.await(threeDrawn);
            }
        };
        try (Successor successor = new Successor(_ -> Optional.of(fast))) {
            successor.mustBeat(100, 1);
            successor.follow(input);
            fast.awaitFrames(frames + 1);
            assertThat(successor.take()).isEmpty();

            successor.mustBeat(100, 1);
            successor.mustBeat(100, 1);
            threeDrawn.countDown();
            while (successor.take().isEmpty()) {
                Thread.onSpinWait();
            }
        }
    }

    /** A frame of several seconds is hardly slowed down by interpretation. */
    @Test
    void oneThatBeatsALongFrameDoesNotWaitForThree() throws InterruptedException {
        CountingEngine fast = new CountingEngine("vector", 99);
        CountDownLatch compared = new CountDownLatch(1);
        fast.pauses = frame -> {
            if (frame == 1) {
                Latches.await(compared);
            }
        };
        try (Successor successor = new Successor(_ -> Optional.of(fast))) {
            successor.mustBeat(2_000_000_000, 20_000_000);
            successor.onReady(compared::countDown);
            successor.follow(input);
            assertThat(compared.await(10, TimeUnit.SECONDS)).isTrue();
            assertThat(successor.take()).contains(fast);
            assertThat(fast.frames).hasValue(1);
        }
    }

    @Test
    void oneThatDoesNotBecomeFasterIsGivenUp() throws InterruptedException {
        CountingEngine slow = new CountingEngine("tornado:0:0", 1000);
        try (Engine auto = auto(_ -> Optional.of(slow))) {
            auto.render(input, frame);
            slow.awaitClosed();
            int tries = slow.frames.get();
            auto.render(input, frame);

            assertThat(auto.id()).isEqualTo("parallel");
            assertThat(standIn.frames).hasValue(2);
            assertThat(standIn.closed).isZero();
            assertThat(tries).isGreaterThan(1);
            assertThat(slow.frames).hasValue(tries);
        }
    }

    @Test
    void oneThatLeavesFramesToTheKernelWaitsForOthers() {
        CountingEngine fast = new CountingEngine("vector", 99);
        FrameInput declined = ofShadows(16 * SHADOW_SAMPLES);
        fast.declined = Optional.of(declined);
        Successor successor = new Successor(_ -> Optional.of(fast), Duration.ofDays(1));
        try (Engine auto = new AutoEngine(standIn, successor, () -> another)) {
            standIn.bands = true;
            while (!auto.drawsBandsInProportion()) {
                auto.render(declined, frame);
            }
            // Each of these calls would otherwise wait for a fraction of a second.
            for (int i = 0; i < 1000; i++) {
                auto.render(declined, frame);
            }
            assertThat(auto.id()).isEqualTo("parallel");
            assertThat(fast.frames).hasValue(0);

            renderUntil(auto, "vector");
        }
        assertThat(fast.closed).isOne();
    }

    @Test
    void aTrialHasOneSamplePerPixel() throws InterruptedException {
        CountingEngine slow = new CountingEngine("tornado:0:0", 1000);
        try (Engine auto = auto(_ -> Optional.of(slow))) {
            auto.render(input.withSamples(0, 16), frame);
            slow.awaitFrames(1);
        }
        assertThat(slow.lastSamples).isOne();
    }

    /** A light picture by the current engine takes less time than a heavy one by any engine. */
    @Test
    void whatBecomesLighterIsTriedAnew() throws InterruptedException {
        CountingEngine fast = new CountingEngine("vector", 20);
        FrameInput heavy = ofShadows(16 * SHADOW_SAMPLES);
        CountDownLatch lighter = new CountDownLatch(1);
        fast.pauses = frame -> {
            if (frame == 0) {
                Latches.await(lighter);
            }
        };
        try (Engine auto = auto(_ -> Optional.of(fast))) {
            auto.render(heavy, frame);
            fast.awaitFrames(1);
            for (int i = 0; i < 3; i++) {
                auto.render(input, frame);
            }
            lighter.countDown();
            renderUntil(auto, "vector");
        }
        assertThat(fast.closed).isOne();
    }

    @Test
    void picturesAreDrawnInBandsOnceNothingIsMeasured() {
        standIn.bands = true;
        CountingEngine fast = new CountingEngine("vector", 99);
        fast.bands = true;
        try (Engine auto = auto(_ -> Optional.of(fast))) {
            assertThat(auto.drawsBandsInProportion()).isFalse();
            renderUntil(auto, "vector");
            assertThat(auto.drawsBandsInProportion()).isTrue();
        }
    }

    @Test
    void picturesAreDrawnInBandsByTheStandInThatStays() {
        standIn.bands = true;
        try (Engine auto = auto(_ -> Optional.empty())) {
            auto.render(input, frame);
            while (!auto.drawsBandsInProportion()) {
                Thread.onSpinWait();
            }
            assertThat(auto.id()).isEqualTo("parallel");
        }
    }

    @Test
    void oneThatFailsLeavesTheStandIn() throws InterruptedException {
        CountDownLatch asked = new CountDownLatch(1);
        try (Engine auto = auto(_ -> {
            asked.countDown();
            throw new EngineException("out of order");
        })) {
            auto.render(input, frame);
            asked.await();
            auto.render(input, frame);

            assertThat(auto.id()).isEqualTo("parallel");
            assertThat(standIn.frames.get()).isEqualTo(2);
        }
    }

    @Test
    void closingTellsWhoStillLooksForTheFastest() throws InterruptedException {
        CountDownLatch told = new CountDownLatch(1);
        Engine auto = auto(canceled -> {
            while (!canceled.getAsBoolean()) {
                Thread.onSpinWait();
            }
            told.countDown();
            return Optional.empty();
        });
        auto.render(input, frame);

        auto.close();

        told.await();
        assertThat(standIn.closed).isOne();
    }

    @Test
    void whoNeverDrawsStartsNothing() {
        AtomicInteger asked = new AtomicInteger();
        auto(_ -> {
                    asked.incrementAndGet();
                    return Optional.empty();
                })
                .close();

        assertThat(asked.get()).isZero();
        assertThat(standIn.closed).isOne();
    }

    @Test
    void noFrameWaitsForOneThatIsNotThere() {
        Successor broken = new Successor(
                _ -> {
                    throw new EngineException("the driver is not there");
                },
                Duration.ofDays(1));
        try (Engine auto = new AutoEngine(standIn, broken, () -> standIn)) {
            // Each call would otherwise wait for a fraction of a second.
            for (int i = 0; i < 1000; i++) {
                auto.render(input, frame);
            }
            assertThat(auto.id()).isEqualTo("parallel");
        }
    }

    @Test
    void oneThatNeedsTooMuchMemoryIsGivenUpInSilence() throws InterruptedException {
        CountingEngine greedy = new CountingEngine("vector", 1);
        AtomicReference<Optional<Throwable>> complaint = new AtomicReference<>(Optional.empty());
        AtomicReference<Optional<Thread>> warmUp = new AtomicReference<>(Optional.empty());
        greedy.pauses = _ -> {
            Thread.currentThread().setUncaughtExceptionHandler((_, problem) -> complaint.set(Optional.of(problem)));
            warmUp.set(Optional.of(Thread.currentThread()));
            throw new OutOfMemoryError("Java heap space");
        };
        try (Engine auto = auto(_ -> Optional.of(greedy))) {
            auto.render(input, frame);
            greedy.awaitClosed();
            warmUp.get().orElseThrow().join();
            auto.render(input, frame);

            assertThat(auto.id()).isEqualTo("parallel");
            assertThat(complaint.get()).isEmpty();
        }
    }

    private FrameInput ofShadows(int samples) {
        world.setSettings(world.settings().withShadowSamples(samples));
        return world.snapshot();
    }

    private Engine auto(Function<BooleanSupplier, Optional<Engine>> successor) {
        return new AutoEngine(standIn, new Successor(successor), () -> another);
    }

    private void renderUntil(Engine auto, String id) {
        while (!auto.id().equals(id)) {
            auto.render(input, frame);
        }
    }

    /** Reports a fixed number of nanoseconds per pixel at the default number of shadow samples. */
    private static final class CountingEngine implements Engine {
        private final String id;
        private final int nanosPerPixel;
        private final AtomicInteger frames = new AtomicInteger();
        private volatile int closed;
        private int rests;
        private boolean bands;
        private int nanosPerPixelAtFirst;
        private int processorNanosPerPixel;
        private volatile List<Integer> lastBand = List.of();
        private IntConsumer pauses = _ -> {};
        private Optional<FrameInput> declined = Optional.empty();
        private volatile int lastSamples;
        private volatile int lastWidth;
        private volatile int lastHeight;

        CountingEngine(String id, int nanosPerPixel) {
            this.id = id;
            this.nanosPerPixel = nanosPerPixel;
            nanosPerPixelAtFirst = nanosPerPixel;
        }

        @Override
        public String id() {
            return id;
        }

        @Override
        public String device() {
            return "a device of the test's";
        }

        @Override
        public void render(FrameInput drawn, Frame into) {
            lastWidth = drawn.width();
            lastHeight = drawn.height();
            lastSamples = drawn.samplesPerPixel();
            lastBand = List.of(drawn.firstRow(), drawn.rows());
            Arrays.fill(into.argb(), id.hashCode());
            int drawnBefore = frames.getAndIncrement();
            pauses.accept(drawnBefore);
            int nanos =
                    (drawnBefore == 0 ? nanosPerPixelAtFirst : nanosPerPixel) * drawn.shadowSamples() / SHADOW_SAMPLES;
            long pixels = (long) drawn.width() * drawn.rows();
            into.setTimes(FrameTimes.onJvm(nanos * pixels, processorNanosPerPixel * pixels));
        }

        @Override
        public boolean drawsBandsInProportion() {
            return bands;
        }

        @Override
        public boolean declines(FrameInput offered) {
            return declined.equals(Optional.of(offered));
        }

        @Override
        public void rest() {
            rests++;
        }

        void awaitFrames(int wanted) throws InterruptedException {
            while (frames.get() < wanted) {
                Thread.sleep(1);
            }
        }

        void awaitClosed() throws InterruptedException {
            while (closed == 0) {
                Thread.sleep(1);
            }
        }

        @Override
        public void close() {
            closed = 1;
        }
    }
}
