package dev.twister.engine.auto;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assumptions.assumeThat;

import dev.twister.engine.Engine;
import dev.twister.engine.EngineException;
import dev.twister.engine.EngineOffer;
import dev.twister.engine.Engines;
import dev.twister.engine.FakeEngine;
import dev.twister.image.Frame;
import dev.twister.image.FrameTimes;
import dev.twister.world.FrameInput;
import dev.twister.world.SampleWorld;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Clock;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.locks.LockSupport;
import java.util.function.BooleanSupplier;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

// A thread that spins or parks as a crew does ignores interruption, so timeouts need a separate thread.
@Timeout(value = 300, threadMode = Timeout.ThreadMode.SEPARATE_THREAD)
class FastestEngineTest {
    private static final Map<String, Integer> MILLIS =
            Map.of("sequential", 40, "parallel", 20, "vector", 5, "tornado:0:0", 9, "auto", 1);

    private static final FastestEngine.Waiting NO_WAIT = (time, canceled) -> {};

    @TempDir
    private Path folder;

    private final List<String> tried = new ArrayList<>();

    @Test
    void takesTheFastest() {
        assertThat(open(offers("sequential", "parallel", "vector", "tornado:0:0")))
                .isEqualTo("vector");
    }

    @Test
    void leavesOutSequentialItselfAndWhatDoesNotWork() {
        List<EngineOffer> offers = new ArrayList<>(offers("auto", "sequential", "parallel"));
        offers.add(EngineOffer.impossible("vector", "lanes", "wide", "no module"));

        assertThat(open(offers)).isEqualTo("parallel");
        assertThat(tried).containsExactly("parallel");
    }

    @Test
    void devicesAreTriedLast() {
        open(offers("tornado:0:0", "sequential", "parallel"));

        assertThat(tried).containsExactly("parallel", "tornado:0:0");
    }

    @Test
    void measuresOnceForTheSameEngines() {
        List<EngineOffer> offers = offers("sequential", "parallel");
        open(offers);
        tried.clear();

        assertThat(open(offers)).isEqualTo("parallel");
        assertThat(tried).isEmpty();
        assertThat(fastest().remembered(offers)).contains("parallel");
    }

    @Test
    void anotherEngineIsMeasuredAgain() {
        open(offers("sequential", "parallel"));
        tried.clear();

        assertThat(open(offers("sequential", "parallel", "vector"))).isEqualTo("vector");
        assertThat(tried).hasSize(2);
    }

    @Test
    void aDamagedFileIsMeasuredAgain() throws IOException {
        List<EngineOffer> offers = offers("sequential", "parallel");
        for (String damage : List.of("", "engine=\\u00zz", "engine=warp", "\0\0\0")) {
            open(offers);
            for (Path file : files()) {
                Files.writeString(file, damage);
            }
            assertThat(fastest().remembered(offers)).isEmpty();

            assertThat(open(offers)).isEqualTo("parallel");
            assertThat(fastest().remembered(offers)).contains("parallel");
        }
    }

    @Test
    void aPipeInTheFilesPlaceIsNotWaitedFor() throws IOException, InterruptedException {
        List<EngineOffer> offers = offers("sequential", "parallel");
        open(offers);
        for (Path file : files()) {
            Files.delete(file);
            assumeThat(new ProcessBuilder("mkfifo", file.toString()).start().waitFor())
                    .isZero();
        }

        assertThat(fastest().remembered(offers)).isEmpty();
        assertThat(open(offers)).isEqualTo("parallel");
        assertThat(fastest().remembered(offers)).isEmpty();
    }

    @Test
    void whereNothingCanBeWrittenItMeasuresEachTime() throws IOException {
        Path file = Files.createFile(folder.resolve("not-a-folder"));
        List<EngineOffer> offers = offers("sequential", "parallel");
        for (Optional<Path> place : List.of(Optional.of(file), Optional.<Path>empty())) {
            FastestEngine fastest = new FastestEngine(this::time, new ChoiceStore(place, Clock.systemUTC()), NO_WAIT);
            try (Engine engine = fastest.openMeasured(offers)) {
                assertThat(engine.id()).isEqualTo("parallel");
            }
            assertThat(fastest.remembered(offers)).isEmpty();
        }
    }

    @Test
    void anEngineThatDoesNotOpenGivesWayToTheNext() {
        List<EngineOffer> offers = new ArrayList<>(offers("sequential", "parallel"));
        offers.add(EngineOffer.working("vector", "lanes", "wide", () -> {
            throw new EngineException("out of order");
        }));

        assertThat(open(offers)).isEqualTo("parallel");
        assertThat(open(offers)).isEqualTo("parallel");
    }

    @Test
    void whereNoneIsReadyInTimeParallelIsTakenAndNothingRemembered() {
        List<EngineOffer> offers = offers("sequential", "parallel");
        FastestEngine fastest = new FastestEngine(
                (offer, limit, canceled) -> Optional.empty(),
                new ChoiceStore(Optional.of(folder), Clock.systemUTC()),
                NO_WAIT);

        try (Engine engine = fastest.openMeasured(offers)) {
            assertThat(engine.id()).isEqualTo("parallel");
        }
        assertThat(fastest.remembered(offers)).isEmpty();
    }

    @Test
    void withoutAnyEngineItSaysSo() {
        FastestEngine fastest = fastest();

        assertThatThrownBy(() -> fastest.openMeasured(List.of()))
                .isInstanceOf(EngineException.class)
                .hasMessageContaining("no engine works here");
    }

    @Test
    void measuringPatientlyListsTheFastestFirst() {
        assertThat(fastest().measurePatiently(offers("sequential", "unready", "tornado:0:0", "parallel")))
                .extracting(FastestEngine.Time::engine)
                .containsExactly("tornado:0:0", "parallel", "unready");
    }

    @Test
    void whatIsCancelledIsNotRemembered() throws InterruptedException {
        List<EngineOffer> offers = offers("parallel", "vector", "tornado:0:0");
        CountDownLatch begun = new CountDownLatch(1);
        CountDownLatch cancelledTrials = new CountDownLatch(2);
        FastestEngine fastest = new FastestEngine(
                (offer, limit, canceled) -> {
                    begun.countDown();
                    while (!canceled.getAsBoolean()) {
                        Thread.onSpinWait();
                    }
                    cancelledTrials.countDown();
                    return Optional.of(Duration.ofMillis(1));
                },
                new ChoiceStore(Optional.of(folder), Clock.systemUTC()),
                NO_WAIT);
        try (Engine engine = fastest.openAtOnce(offers)) {
            engine.render(SampleWorld.ofSize(8, 8).snapshot(), Frame.ofPixels(8, 8));
            begun.await();
        }
        cancelledTrials.await();

        assertThat(fastest.remembered(offers)).isEmpty();
    }

    @Test
    void whatHasLostIsNotTriedBesideTheFrames() {
        List<EngineOffer> offers = offers("parallel", "vector", "tornado:0:0");

        drawUntilRemembered(offers);

        assertThat(tried).containsExactly("vector", "tornado:0:0");
    }

    @Test
    void whatHasWonWithoutRivalsIsRememberedUntried() {
        List<EngineOffer> offers = offers("parallel", "vector");

        drawUntilRemembered(offers);

        assertThat(tried).isEmpty();
        assertThat(fastest().remembered(offers)).contains("vector");
    }

    /** The search for devices starts while vector renders. */
    private void drawUntilRemembered(List<EngineOffer> offers) {
        CountDownLatch won = new CountDownLatch(1);
        FastestEngine fastest = new FastestEngine(
                this::time, new ChoiceStore(Optional.of(folder), Clock.systemUTC()), (_, _) -> Latches.await(won));
        try (Engine engine = fastest.openAtOnce(offers("parallel", "vector"), () -> offers)) {
            drawUntil(engine, "vector");
            won.countDown();
            while (fastest.remembered(offers).isEmpty()) {
                Thread.onSpinWait();
            }
        }
    }

    @Test
    void drawsAtOnceWithParallelAndRemembersTheFastest() {
        List<EngineOffer> offers = offers("sequential", "parallel", "vector");
        Frame frame = Frame.ofPixels(8, 8);
        FrameInput input = SampleWorld.ofSize(8, 8).snapshot();
        try (Engine engine = fastest().openAtOnce(offers)) {
            assertThat(engine.id()).isEqualTo("parallel");
            while (fastest().remembered(offers).isEmpty()) {
                engine.render(input, frame);
            }
        }

        assertThat(fastest().remembered(offers)).contains("vector");
    }

    @Test
    void whereParallelWasTheFastestNothingElseIsOpened() {
        List<EngineOffer> offers = offers("sequential", "parallel");
        open(offers);

        try (Engine engine = fastest().openAtOnce(offers)) {
            assertThat(engine).isNotInstanceOf(AutoEngine.class);
            assertThat(engine.id()).isEqualTo("parallel");
        }
    }

    @Test
    void whereParallelOnceWonTheUsualEngineIsTriedNonetheless() {
        List<EngineOffer> offers = offers("parallel", "vector");
        ChoiceStore store = new ChoiceStore(Optional.of(folder), Clock.systemUTC());
        store.write(MachineKey.beforeDevices(offers), "parallel");
        store.write(MachineKey.of(offers), "parallel");

        try (Engine engine = fastest().openAtOnce(offers)) {
            drawUntil(engine, "vector");
        }
        try (Engine engine = fastest().openAtOnce(offers, () -> offers)) {
            drawUntil(engine, "vector");
        }
    }

    @Test
    void anEngineThatNeedsNoDeviceIsTakenBeforeDevicesAreLookedFor() throws Exception {
        List<EngineOffer> all = offers("sequential", "parallel", "vector", "tornado:0:0");
        open(all);
        tried.clear();
        CompletableFuture<Thread> looked = new CompletableFuture<>();
        Thread looking;
        try (Engine engine = fastest().openAtOnce(offers("sequential", "parallel", "vector"), () -> {
            looked.complete(Thread.currentThread());
            return all;
        })) {
            assertThat(looked).isNotDone();
            drawUntil(engine, "vector");
            looking = looked.get();
        }
        // The search writes the remembered result into a folder that is deleted after the test.
        looking.join();
        assertThat(tried).isEmpty();
    }

    @Test
    void devicesThatWereNotMeasuredAreMeasuredOnceThereIsTime() {
        List<EngineOffer> jvm = offers("sequential", "parallel");
        List<EngineOffer> all = offers("sequential", "parallel", "tornado:0:0");
        open(jvm);
        try (Engine engine = fastest().openAtOnce(jvm, () -> all)) {
            drawUntil(engine, "tornado:0:0");
        }

        assertThat(fastest().remembered(all)).contains("tornado:0:0");
    }

    @Test
    void whereADeviceWasTheFastestItIsLookedForAtOnce() {
        List<EngineOffer> jvm = offers("sequential", "parallel");
        List<EngineOffer> all = offers("sequential", "parallel", "tornado:0:0");
        open(all);
        AtomicBoolean looked = new AtomicBoolean();
        fastest()
                .openAtOnce(jvm, () -> {
                    looked.set(true);
                    return all;
                })
                .close();

        assertThat(looked).isTrue();
    }

    private static void drawUntil(Engine engine, String id) {
        Frame frame = Frame.ofPixels(8, 8);
        FrameInput input = SampleWorld.ofSize(8, 8).snapshot();
        while (!engine.id().equals(id)) {
            engine.render(input, frame);
        }
    }

    @Test
    void aTrialThatSettlesEndsBeforeItsLimit() {
        EngineOffer offer = EngineOffer.working(
                "parallel", "a device", "draws", () -> new FakeEngine("parallel", 0, FrameTimes.onJvm(1_000_000)));

        assertThat(new TimedTrial().frameTime(offer, Duration.ofHours(1), () -> false))
                .contains(Duration.ofMillis(1));
    }

    @Test
    void aTrialThatRunsOutOfMemoryFindsNothing() {
        EngineOffer greedy = EngineOffer.working("vector", "lanes", "wide", OneFrameEngine::new);

        assertThat(new TimedTrial().frameTime(greedy, Duration.ofHours(1), () -> false))
                .isEmpty();
    }

    @Test
    void aTrialThatIsCancelledEndsBeforeItsLimit() {
        EngineOffer stuck = EngineOffer.working("vector", "lanes", "wide", () -> {
            LockSupport.park();
            throw new EngineException("woken");
        });

        assertThat(new TimedTrial().frameTime(stuck, Duration.ofHours(1), () -> true))
                .isEmpty();
    }

    @Test
    void autoIsAnEngineByName() {
        assertThat(Engines.offers()).extracting(EngineOffer::id).contains("auto");
        try (Engine engine = Engines.open("auto")) {
            assertThat(engine.id()).isNotEqualTo("auto");
        }
    }

    private FastestEngine fastest() {
        return new FastestEngine(this::time, new ChoiceStore(Optional.of(folder), Clock.systemUTC()), NO_WAIT);
    }

    private String open(List<EngineOffer> offers) {
        try (Engine engine = fastest().openMeasured(offers)) {
            return engine.id();
        }
    }

    private Optional<Duration> time(EngineOffer offer, Duration limit, BooleanSupplier canceled) {
        tried.add(offer.id());
        return Optional.ofNullable(MILLIS.get(offer.id())).map(Duration::ofMillis);
    }

    private List<Path> files() throws IOException {
        try (Stream<Path> files = Files.list(folder)) {
            return files.toList();
        }
    }

    private static List<EngineOffer> offers(String... ids) {
        return Stream.of(ids)
                .map(id -> EngineOffer.working(
                        id,
                        "a device",
                        "draws",
                        () -> new FakeEngine(id, 0, FrameTimes.onJvm(MILLIS.getOrDefault(id, 1)))))
                .toList();
    }

    /** Has memory for one frame only. */
    private static final class OneFrameEngine implements Engine {
        private boolean drew;

        @Override
        public String id() {
            return "vector";
        }

        @Override
        public String device() {
            return "a device of the test's";
        }

        @Override
        public void render(FrameInput input, Frame frame) {
            if (drew) {
                throw new OutOfMemoryError("Java heap space");
            }
            drew = true;
            frame.setTimes(FrameTimes.onJvm(1_000_000));
        }

        @Override
        public void close() {
            // Nothing to release.
        }
    }
}
