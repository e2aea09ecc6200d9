package dev.twister.gui;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.engine.EngineOffer;
import dev.twister.engine.Engines;
import dev.twister.engine.JvmEngines;
import dev.twister.engine.vector.VectorEngines;
import dev.twister.gui.drawing.DrawnPicture;
import dev.twister.gui.studio.Studio;
import dev.twister.scene.Scene;
import java.lang.management.ManagementFactory;
import java.lang.ref.WeakReference;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/** Opens, resizes, changes engine and scene again and again; {@code -Dtwister.soak=500} for as often as that. */
@Tag("slow")
class SoakTest {
    private static final int ROUNDS = Integer.getInteger("twister.soak", 6);
    private static final int WARM_UP_ROUNDS = 3;

    /**
     * JavaFX's software pipeline keeps textures of windows long closed for later ones, within a limit of its own: 150
     * were seen, 34 MB. Were each of 500 windows to leave its pictures behind, it would be several times as much as
     * this.
     */
    private static final long SLACK_BYTES = 96L << 20;

    /** JavaFX holds on to the window that had the focus last. */
    private static final int STILL_HELD = 2;

    private static final int OPAQUE = 0xFF;

    /** Long enough for the slowest machine; only a failure takes it. */
    private static final Duration PATIENCE = Duration.ofMinutes(5);

    private final List<WeakReference<Studio>> studios = new ArrayList<>();
    private final Random random = new Random(20261121);
    private final List<EngineOffer> engines = Engines.offers().stream()
            .filter(offer -> List.of(JvmEngines.SEQUENTIAL, JvmEngines.PARALLEL, VectorEngines.VECTOR)
                    .contains(offer.id()))
            .toList();
    private final List<Scene> scenes = List.of(
            WindowScenes.tiny(),
            WindowScenes.quick(WindowScenes.shipped("benchmark")),
            WindowScenes.quick(WindowScenes.shipped("spheres-100")));

    @Test
    void nothingLeaksAndNoPictureIsTornOrBlack() throws InterruptedException {
        for (int i = 0; i < WARM_UP_ROUNDS; i++) {
            round();
        }
        long limit = usedBytes() + SLACK_BYTES;
        int threads = drawingThreads();
        for (int i = 0; i < ROUNDS; i++) {
            round();
        }

        assertThat(drawingThreads()).isEqualTo(threads).isZero();
        awaitLittleMemory(limit);
        assertThat(usedBytes()).isLessThan(limit);
        assertThat(windowsInMemory()).as("windows that are still in memory").isLessThanOrEqualTo(STILL_HELD);
    }

    private void round() throws InterruptedException {
        WindowDriver driver = WindowDriver.open(scenes.get(random.nextInt(scenes.size())), JvmEngines.parallel());
        studios.add(new WeakReference<>(driver.studio));
        try (driver) {
            driver.run(() -> driver.stage.setWidth(200 + random.nextInt(400)));
            driver.run(() -> driver.studio.chooseEngine(engines.get(random.nextInt(engines.size()))));
            driver.run(() -> driver.stage.setHeight(150 + random.nextInt(300)));
            driver.pulse();
            assertSound(WindowDriver.call(
                    () -> driver.studio.pictureProperty().get().orElseThrow()));
            Scene other = scenes.get(random.nextInt(scenes.size()));
            driver.run(() -> driver.studio.edit("scene", _ -> other));
            driver.run(() -> driver.studio.refiningProperty().set(random.nextBoolean()));
            assertSound(driver.awaitCurrentPicture());
        }
        assertThat(driver.studio.awaitEnd(PATIENCE)).isTrue();
    }

    /** Every pixel is drawn, and a whole picture of these scenes is never of one color. */
    private static void assertSound(DrawnPicture picture) {
        int[] argb = picture.frame().argb();
        assertThat(Arrays.stream(argb).allMatch(pixel -> pixel >>> 24 == OPAQUE))
                .isTrue();
        assertThat(Arrays.stream(argb).distinct().limit(20).count()).isEqualTo(20);
    }

    /** Engines that are closed before they were opened end a little later than the window. */
    private static int drawingThreads() throws InterruptedException {
        long end = System.nanoTime() + PATIENCE.toNanos();
        while (count() > 0 && System.nanoTime() < end) {
            Thread.sleep(10);
        }
        return count();
    }

    /**
     * What a window only read, such as the list of devices, nobody waits for, and it holds the window until it is read.
     */
    private void awaitLittleMemory(long limit) throws InterruptedException {
        long end = System.nanoTime() + PATIENCE.toNanos();
        while ((usedBytes() >= limit || windowsInMemory() > STILL_HELD) && System.nanoTime() < end) {
            Thread.sleep(100);
        }
    }

    private long windowsInMemory() {
        return studios.stream().filter(studio -> studio.get() != null).count();
    }

    private static int count() {
        return (int) Thread.getAllStackTraces().keySet().stream()
                .filter(thread -> thread.getName().equals("drawing")
                        || thread.getName().startsWith("opening")
                        || thread.getName().startsWith("twister-vector"))
                .count();
    }

    private static long usedBytes() {
        for (int i = 0; i < 3; i++) {
            System.gc();
        }
        return ManagementFactory.getMemoryMXBean().getHeapMemoryUsage().getUsed();
    }
}
