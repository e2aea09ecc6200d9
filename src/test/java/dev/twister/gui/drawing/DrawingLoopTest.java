package dev.twister.gui.drawing;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.engine.EngineOffer;
import dev.twister.gui.WindowScenes;
import dev.twister.gui.drawing.DrawingRequest.EngineChoice;
import dev.twister.gui.drawing.DrawingRequest.Motion;
import dev.twister.gui.drawing.DrawingRequest.Refinement;
import dev.twister.image.HdrWriter;
import dev.twister.scene.Rendering;
import dev.twister.scene.Scene;
import dev.twister.scene.ToneMap;
import dev.twister.world.SceneMeshes;
import dev.twister.world.StageOrView;
import java.io.IOException;
import java.nio.file.Path;
import java.time.Duration;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.SynchronousQueue;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicLong;
import java.util.concurrent.locks.Condition;
import java.util.concurrent.locks.LockSupport;
import java.util.function.BooleanSupplier;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

class DrawingLoopTest {
    private static final int RED = 0xFFFF0000;
    private static final int GREEN = 0xFF00FF00;
    private static final int BLUE = 0xFF0000FF;
    private static final int WIDTH = 32;
    private static final int HEIGHT = 18;

    /** Of a picture that has enough pixels to be drawn in bands, of one row each where it is slow. */
    private static final int LARGE_WIDTH = 64;

    private static final int LARGE_HEIGHT = 2048;

    private static final Duration LIMIT = Duration.ofMinutes(5);

    @TempDir
    private Path folder;

    private final TestEngine.Kind substitute = new TestEngine.Kind("substitute", BLUE);
    private final TestEngine.Kind green = new TestEngine.Kind("green", GREEN);
    private final TestEngine.Kind red = new TestEngine.Kind("red", RED);
    private final AtomicLong nanos = new AtomicLong();
    private final ImageCache skies = new ImageCache();
    private final DrawingLoop loop =
            new DrawingLoop(skies, new MeshCache(SceneMeshes.reader(skies::warn)), substitute.offer(), nanos::get);
    private final Scene scene = WindowScenes.tiny();
    private Thread thread;
    private long requests;
    private long choices;
    private EngineChoice chosen = new EngineChoice(0, green.offer());
    private Optional<DrawnPicture> shown = Optional.empty();

    @BeforeEach
    void start() {
        Set<Thread> others = drawingThreads();
        loop.start();
        Set<Thread> threads = drawingThreads();
        threads.removeAll(others);
        assertThat(threads).hasSize(1);
        thread = threads.iterator().next();
    }

    private static Set<Thread> drawingThreads() {
        return Thread.getAllStackTraces().keySet().stream()
                .filter(started -> started.getName().equals("drawing"))
                .collect(Collectors.toSet());
    }

    @AfterEach
    void nothingIsLeft() throws InterruptedException {
        for (TestEngine.Kind kind : new TestEngine.Kind[] {substitute, green, red}) {
            kind.allowAll();
        }
        loop.close();

        assertThat(loop.awaitEnd(LIMIT)).isTrue();
        await(() -> substitute.alive.get() + green.alive.get() + red.alive.get() == 0);
    }

    @Test
    void drawsWithTheChosenEngine() {
        request(scene, 0);

        DrawnPicture picture = awaitPicture(drawnBy(green));

        assertThat(picture.frame().argb()).hasSize(WIDTH * HEIGHT).containsOnly(GREEN);
        // Told after the picture.
        await(() -> loop.status().equals(DrawingLoop.Status.QUIET));
    }

    @Test
    void theEngineRestsWhenNothingIsAskedForAnyMore() {
        request(scene, 16);
        await(() -> green.rests.get() > 0);
        int frames = green.frames.get();
        assertThat(green.framesBeforeRest).hasValue(frames);

        request(scene, 16);
        // It may rest once more before, where it is told late that it has been opened.
        await(() -> green.framesBeforeRest.get() > frames);

        awaitQuiet();
        assertThat(green.framesBeforeRest).hasValue(green.frames.get());
        assertThat(green.rests.get()).isLessThanOrEqualTo(3);
        assertThat(substitute.rests).hasValue(0);
    }

    @Test
    void somethingIsSeenWhileTheEngineIsMadeReady() {
        green.hold();
        request(scene, 0);

        DrawnPicture picture = awaitPicture(drawnBy(substitute).and(DrawnPicture::isWhole));
        await(() -> loop.status().opening().equals(Optional.of("green")));

        assertThat(picture.frame().argb()).containsOnly(BLUE);
        green.allowAll();
        awaitPicture(drawnBy(green));
        assertThat(substitute.alive).hasValue(0);
    }

    @Test
    void theFirstPictureIsASmallOne() {
        green.hold();
        request(scene, 0);

        awaitPicture(DrawnPicture::isWhole);

        assertThat(substitute.frames.get()).isEqualTo(4);
    }

    @Test
    void aRequestIsSeenInTheNextPicture() {
        request(scene, 0);
        awaitPicture(drawnBy(green));
        green.hold();
        await(green::isWaitedFor);
        shown = loop.takeNewest().or(() -> shown);
        long before = shown.orElseThrow().number();
        Scene moved = scene.withCamera(WindowScenes.shipped("benchmark").camera());
        request(moved, 0);
        long asked = requests;
        green.allow(2);

        DrawnPicture answer = awaitPicture(picture -> picture.request().number() == asked);

        assertThat(answer.request().scene()).isEqualTo(moved);
        // One was in the making.
        assertThat(answer.number()).isEqualTo(before + 2);
    }

    @Test
    @Timeout(300)
    void whoWatchesSeesEveryWholePictureAndIsWaitedFor() throws InterruptedException {
        request(scene, 0);
        awaitPicture(drawnBy(green));
        SynchronousQueue<Long> numbers = new SynchronousQueue<>();
        loop.watch(picture -> {
            try {
                numbers.put(picture.number());
            } catch (InterruptedException problem) {
                throw new AssertionError(problem);
            }
        });
        long first = numbers.take();
        for (int i = 1; i < 50; i++) {
            assertThat(numbers.take()).isEqualTo(first + i);
        }
        loop.close();
        while (!loop.awaitEnd(Duration.ofMillis(1))) {
            numbers.poll();
        }
    }

    @Test
    void aPictureOfVeryManySamplesIsFirstDrawnWithFew() {
        Scene many = scene.withRendering(scene.rendering().withSamplesPerPixel(Rendering.MAX_SAMPLES_PER_PIXEL));
        request(many, 0);

        assertThat(awaitPicture(drawnBy(green)).input().samplesPerPixel()).isEqualTo(64);
    }

    @Test
    void atRestItRefinesAndStops() {
        request(scene, 6);

        DrawnPicture picture = awaitPicture(drawnBy(green).and(done -> done.samples() == 6));
        int frames = green.frames.get();
        awaitQuiet();

        assertThat(picture.frame().argb()).containsOnly(0xFFFFFFFF);
        assertThat(green.frames).hasValue(frames);
    }

    @Test
    void ofThePicturesThatBecomeFinerSomeInASecondAreShownAndTheLast() {
        request(scene, 0);
        awaitPicture(drawnBy(green));
        green.hold();
        request(scene, 64);
        // The one in the making, the plain one, and ten finer ones, of which only the first is old enough to be seen.
        green.allow(2 + 10);
        awaitPicture(picture -> picture.samples() > 1);
        await(green::isWaitedFor);
        assertThat(awaitPicture(drawnBy(green)).samples()).isEqualTo(4);

        nanos.set(TimeUnit.MILLISECONDS.toNanos(50));
        green.allow(1);
        awaitPicture(picture -> picture.samples() > 4);
        green.allowAll();

        awaitPicture(picture -> picture.samples() == 64);
    }

    @Test
    void whoWatchesSeesThePictureBecomeFinerSampleBySample() {
        request(scene, 0);
        awaitPicture(drawnBy(green));
        List<Integer> samples = new CopyOnWriteArrayList<>();
        green.hold();
        await(green::isWaitedFor);
        request(scene, 9);
        loop.watch(picture -> samples.add(picture.samples()));
        green.allowAll();
        awaitPicture(picture -> picture.samples() == 9);

        await(() -> samples.size() == 8);
        // The one in the making, the plain one, the finer ones.
        assertThat(samples).containsExactly(1, 1, 4, 5, 6, 7, 8, 9);

        loop.unwatch();
        request(scene, 9);
        awaitAnswer();
        awaitQuiet();
        assertThat(samples).hasSize(8);
    }

    @Test
    void aPictureAtRestIsDrawnOnceMoreWhereTheEngineHasBecomeFaster() {
        request(scene, 6);
        DrawnPicture rest = awaitPicture(drawnBy(green).and(done -> done.samples() == 6));
        awaitQuiet();
        int frames = green.frames.get();

        green.onFaster.run();

        awaitPicture(picture -> picture.number() > rest.number() && picture.samples() == 6);
        awaitQuiet();
        // As it is, and then sample by sample.
        assertThat(green.frames).hasValue(frames + 1 + 6);
    }

    @Test
    void aPictureDrawnAgainIsTheOneBeforeUntilSomethingChanges() {
        request(scene, 0);
        DrawnPicture first = awaitPicture(drawnBy(green));
        DrawnPicture again = awaitPicture(picture -> picture.number() > first.number());
        assertThat(again.original()).isEqualTo(first.original());
        assertThat(again.frame()).isSameAs(first.frame());

        request(scene, 0);
        DrawnPicture asked = awaitAnswer();
        assertThat(asked.original()).isGreaterThan(again.number());

        green.onFaster.run();
        DrawnPicture faster = awaitPicture(picture -> picture.original() > asked.number());

        choose(red.offer());
        request(scene, 0);
        DrawnPicture other = awaitPicture(drawnBy(red));
        assertThat(other.original()).isGreaterThan(faster.number());
        assertThat(other.frame().argb()).containsOnly(RED);

        choose(green.offer());
        request(scene, 0);
        awaitPicture(drawnBy(green));
        green.become("blue", BLUE);
        DrawnPicture changed = awaitPicture(drawnBy(green));
        assertThat(changed.frame().argb()).containsOnly(BLUE);
    }

    @Test
    void noPictureOfMovingBodiesIsARepetition() {
        request(scene, 0, new Motion(1, true, 0));
        DrawnPicture picture = awaitPicture(drawnBy(green));
        for (int i = 0; i < 5; i++) {
            long before = picture.number();
            picture = awaitPicture(next -> next.number() > before);
            assertThat(picture.original()).isEqualTo(picture.number());
        }

        request(scene, 0, new Motion(1, false, 0));
        DrawnPicture paused = awaitAnswer();
        awaitPicture(next -> next.number() > paused.number() && next.original() == paused.original());

        request(scene, 0, new Motion(1, false, 1));
        assertThat(awaitAnswer().original()).isGreaterThan(paused.number());
    }

    @Test
    void aMoveStartsRefiningAnew() {
        request(scene, 6);
        awaitPicture(drawnBy(green).and(done -> done.samples() == 6));
        request(scene.withCamera(WindowScenes.shipped("benchmark").camera()), 6);
        long asked = requests;

        DrawnPicture first = awaitPicture(picture -> picture.request().number() == asked);
        DrawnPicture last = awaitPicture(done -> done.request().number() == asked && done.samples() == 6);

        assertThat(first.number()).isLessThanOrEqualTo(last.number());
    }

    @Test
    void anEngineThatDoesNotOpenLeavesTheOldOne() {
        request(scene, 0);
        awaitPicture(drawnBy(green));
        choose(EngineOffer.impossible("none", "nothing", "never", "it is not there"));
        request(scene, 0);

        await(() -> loop.status().engineFailure().isPresent());
        long asked = requests;

        assertThat(loop.status().engineFailure().orElseThrow()).contains("none", "it is not there");
        assertThat(awaitPicture(picture -> picture.request().number() == asked).engine())
                .isEqualTo("green");
        assertThat(green.opened).hasValue(1);
    }

    @Test
    void anEngineThatBreaksIsReplacedAndTriedAgainWhenChosenAgain() {
        request(scene, 0);
        awaitPicture(drawnBy(green));
        green.breaks = true;
        awaitPicture(drawnBy(substitute));
        assertThat(loop.status().engineFailure()).contains("green broke");
        green.breaks = false;

        choose(green.offer());
        request(scene, 0);

        awaitPicture(drawnBy(green));
        assertThat(loop.status().engineFailure()).isEmpty();
    }

    @Test
    void tooLittleMemoryIsToldInPlainWords() {
        green.onFrame = () -> {
            throw new OutOfMemoryError("a test's");
        };
        request(scene, 0);
        await(() -> loop.status().engineFailure().isPresent());
        assertThat(loop.status().engineFailure())
                .contains("engine green: there is not enough memory for this picture; choose a smaller one");
    }

    @Test
    void whereNothingWorksItWaits() {
        green.breaks = true;
        substitute.breaks = true;
        request(scene, 0);

        await(() -> loop.status().engineFailure().isPresent());
        awaitQuiet();
        substitute.breaks = false;
        request(scene, 0);

        awaitPicture(drawnBy(substitute));
    }

    @Test
    void onlyTheLastOfManyChoicesIsOpened() {
        green.hold();
        request(scene, 0);
        await(() -> green.opened.get() == 1);
        for (int i = 0; i < 20; i++) {
            choose(red.offer());
            request(scene, 0);
            long asked = requests;
            awaitPicture(picture -> picture.request().number() == asked);
        }
        green.allowAll();

        awaitPicture(drawnBy(red));
        assertThat(red.opened.get()).isLessThan(20);
    }

    @Test
    void aSlowPictureIsLeftForAnotherEngine() {
        beSlow(green);
        requestLarge(scene, 1);
        awaitPicture(drawnBy(green));
        awaitQuiet();
        green.hold();
        Scene moved = scene.withCamera(WindowScenes.shipped("benchmark").camera());
        requestLarge(moved, 1);
        int before = green.frames.get();
        green.allow(1);
        await(() -> green.frames.get() > before);
        choose(red.offer());
        requestLarge(moved, 1);

        // The other one may be long in the making: bands are allowed ever more rarely, so that they do not run out.
        AtomicLong turns = new AtomicLong();
        await(() -> {
            if (Long.bitCount(turns.incrementAndGet()) == 1) {
                green.allow(1);
            }
            shown = loop.takeNewest().or(() -> shown);
            return shown.filter(drawnBy(red)).isPresent();
        });

        assertThat(shown.orElseThrow().isWhole()).isTrue();
        assertThat(green.frames.get() - before).isLessThan(LARGE_HEIGHT / 2);
    }

    @Test
    void aSlowPictureIsNotDrawnAgainWhileAnotherEngineIsMadeReady() {
        beSlow(green);
        requestLarge(scene, 1);
        awaitPicture(drawnBy(green));
        awaitQuiet();
        int before = green.frames.get();
        red.hold();
        choose(red.offer());
        requestLarge(scene, 1);
        await(() -> red.opened.get() == 1);
        awaitQuiet();

        assertThat(loop.status().opening()).contains("red");
        assertThat(green.frames.get()).isEqualTo(before);
        red.allowAll();
        awaitPicture(drawnBy(red));
    }

    @Test
    void aSlowPictureIsPrecededByASmallerOneWhereverTheCameraMoves() {
        List<Long> answered = beginASlowPicture();
        awaitPicture(picture -> picture.request().number() == requests && !picture.isWhole());
        requestLarge(scene, 1);
        // One band of the picture before, which is left then.
        green.allow(2);
        awaitPicture(picture -> picture.request().number() == requests && !picture.isWhole());
        green.allowAll();

        await(() -> answered.contains(requests));
        assertThat(shown.orElseThrow().frame().width()).isEqualTo(LARGE_WIDTH / 8);
    }

    @Test
    void anotherToneIsSeenWithoutAnotherFrame() {
        requestLarge(scene, 16);
        awaitPicture(picture -> picture.samples() == 16);
        awaitQuiet();
        int before = green.frames.get();
        requestLarge(
                scene.withRendering(scene.rendering()
                        .withTone(-3, ToneMap.ACES, scene.rendering().srgb())),
                16);
        DrawnPicture toned = awaitPicture(picture -> picture.request().number() == requests);

        assertThat(toned.samples()).isEqualTo(16);
        assertThat(green.frames.get()).isEqualTo(before);
    }

    @Test
    void aSlowPictureIsLeftForAnotherSceneThatWasOpened() {
        assertLeftFor(large(1, scene, Motion.NONE));
    }

    @Test
    void aSlowPictureIsLeftForBodiesThatBeginToMove() {
        assertLeftFor(large(0, scene, new Motion(1, true, 0)));
    }

    @Test
    void aSlowPictureIsLeftForAnotherSky() {
        assertLeftFor(large(
                0, scene.withSky(scene.sky().withFile(Path.of("another.hdr").toAbsolutePath())), Motion.NONE));
    }

    @Test
    void aSlowPictureIsDrawnAgainWhereTheSameSceneIsOpenedAnew() {
        beSlow(green);
        requestLarge(scene, 1);
        awaitPicture(drawnBy(green));
        awaitQuiet();
        List<Integer> samples = new CopyOnWriteArrayList<>();
        loop.watch(picture -> samples.add(picture.samples()));
        loop.request(new DrawingRequest(
                2, 1, scene, LARGE_WIDTH, LARGE_HEIGHT, chosen, Refinement.to(16), Motion.NONE, StageOrView.BEAUTY));

        await(() -> !samples.isEmpty());
        // What is clicked in the one before is of no scene any more, and more samples take as much longer.
        assertThat(samples.getFirst()).isEqualTo(scene.rendering().samplesPerPixel());
    }

    private void assertLeftFor(DrawingRequest other) {
        List<Long> answered = beginASlowPicture();
        loop.request(other);
        green.allowAll();

        await(() -> !answered.isEmpty());
        assertThat(answered.getFirst()).isEqualTo(other.number());
    }

    /**
     * Has a part of a slow picture drawn, from another place than one before; the rest waits. Returns the numbers of
     * the requests that are answered from then on.
     */
    private List<Long> beginASlowPicture() {
        beSlow(green);
        requestLarge(scene, 1);
        awaitPicture(drawnBy(green));
        awaitQuiet();
        List<Long> answered = new CopyOnWriteArrayList<>();
        loop.watch(picture -> answered.add(picture.request().number()));
        green.hold();
        requestLarge(scene.withCamera(WindowScenes.shipped("benchmark").camera()), 1);
        int before = green.frames.get();
        green.allow(1);
        await(() -> green.frames.get() > before);
        return answered;
    }

    /** To follow all others. */
    private DrawingRequest large(long document, Scene wanted, Motion motion) {
        return new DrawingRequest(
                Long.MAX_VALUE,
                document,
                wanted,
                LARGE_WIDTH,
                LARGE_HEIGHT,
                chosen,
                Refinement.to(1),
                motion,
                StageOrView.BEAUTY);
    }

    private void beSlow(TestEngine.Kind kind) {
        kind.onFrame = () -> nanos.addAndGet(TimeUnit.MINUTES.toNanos(1));
    }

    private void requestLarge(Scene wanted, int refineTo) {
        requests++;
        loop.request(new DrawingRequest(requests, wanted, LARGE_WIDTH, LARGE_HEIGHT, chosen, refineTo));
    }

    @Test
    void aSkyThatIsNotThereLeavesTheOldOne() {
        request(scene, 0);
        awaitPicture(drawnBy(green));
        request(scene.withSky(scene.sky().withFile(Path.of("no-such-sky.hdr").toAbsolutePath())), 0);
        long asked = requests;

        awaitPicture(picture -> picture.request().number() == asked);
        await(() -> loop.status().sceneFailure().isPresent());

        assertThat(loop.status().sceneFailure().orElseThrow()).contains("no-such-sky.hdr");
        request(scene, 0);
        await(() -> loop.status().sceneFailure().isEmpty());
    }

    @Test
    void aSkyIsSeenAsItsFileWasReadLast() throws IOException {
        Path file = folder.resolve("sky.hdr");
        Scene underIt = scene.withSky(scene.sky().withFile(file));
        request(underIt, 0);
        awaitAnswer();
        await(() -> loop.status().sceneFailure().isPresent());

        writeSky(file, 1f);
        skies.refresh(file);
        request(underIt, 0);
        assertThat(awaitAnswer().input().images()).containsOnly(1f);
        await(() -> loop.status().sceneFailure().isEmpty());

        writeSky(file, 2f);
        request(underIt, 0);
        assertThat(awaitAnswer().input().images()).containsOnly(1f);
        skies.refresh(file);
        request(underIt, 0);
        assertThat(awaitAnswer().input().images()).containsOnly(2f);
    }

    private static void writeSky(Path file, float radiance) throws IOException {
        float[] texels = new float[3 * 2];
        Arrays.fill(texels, radiance);
        HdrWriter.write(file, 2, 1, texels);
    }

    @Test
    void whatCannotBeDrawnIsSaidAndTheNextIsDrawn() {
        request(scene, 0);
        awaitPicture(drawnBy(green));
        requests++;
        loop.request(new DrawingRequest(requests, scene, 0, HEIGHT, chosen, 0));
        await(() -> loop.status().sceneFailure().isPresent());

        request(scene, 0);
        awaitAnswer();
        assertThat(loop.status().sceneFailure()).isEmpty();
    }

    private void choose(EngineOffer offer) {
        choices++;
        chosen = new EngineChoice(choices, offer);
    }

    private void request(Scene wanted, int refineTo) {
        request(wanted, refineTo, Motion.NONE);
    }

    private void request(Scene wanted, int refineTo, Motion motion) {
        requests++;
        loop.request(new DrawingRequest(
                requests, 0, wanted, WIDTH, HEIGHT, chosen, Refinement.to(refineTo), motion, StageOrView.BEAUTY));
    }

    private DrawnPicture awaitAnswer() {
        long asked = requests;
        return awaitPicture(picture -> picture.request().number() == asked);
    }

    private static Predicate<DrawnPicture> drawnBy(TestEngine.Kind kind) {
        return picture -> picture.engine().equals(kind.id());
    }

    private DrawnPicture awaitPicture(Predicate<DrawnPicture> wanted) {
        await(() -> {
            shown = loop.takeNewest().or(() -> shown);
            return shown.filter(wanted).isPresent();
        });
        return shown.orElseThrow();
    }

    /** Until the drawing thread waits for something to do; in a frame that is held up it does not. */
    private void awaitQuiet() {
        // It also waits for locks, but for no condition while there is something to do.
        await(() -> LockSupport.getBlocker(thread) instanceof Condition);
    }

    private static void await(BooleanSupplier condition) {
        long end = System.nanoTime() + LIMIT.toNanos();
        while (!condition.getAsBoolean()) {
            assertThat(System.nanoTime()).as("the time is over").isLessThan(end);
            LockSupport.parkNanos(TimeUnit.MILLISECONDS.toNanos(1));
        }
    }
}
