package dev.twister.gui.drawing;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.engine.Engine;
import dev.twister.gui.WindowScenes;
import dev.twister.image.Frame;
import dev.twister.image.FrameTimes;
import dev.twister.oracle.Crowds;
import dev.twister.sky.Skybox;
import dev.twister.world.FrameInput;
import dev.twister.world.World;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;

class WarmUpTest {
    private static final int SMALL_ROWS = 40;

    private final List<Integer> rows = new ArrayList<>();
    private long nanos;
    private long nanosAFrame;

    /** Draws nothing, in next to no time. */
    private final class Noted implements Engine {
        private final String id;
        private final boolean bands;

        Noted(String id, boolean bands) {
            this.id = id;
            this.bands = bands;
        }

        @Override
        public String id() {
            return id;
        }

        @Override
        public String device() {
            return "a test";
        }

        @Override
        public void render(FrameInput input, Frame frame) {
            rows.add(frame.height());
            nanos += nanosAFrame;
            frame.setTimes(FrameTimes.onJvm(1));
        }

        @Override
        public boolean drawsBandsInProportion() {
            return bands;
        }

        @Override
        public void close() {
            // It holds nothing.
        }
    }

    private WarmUp ofMany() {
        return warmUp(Crowds.world(100, 512, 8 * SMALL_ROWS));
    }

    private WarmUp ofFew() {
        World world = World.of(WindowScenes.tiny(), new Skybox(1, 1, new float[3]));
        world.setSettings(world.settings().withSize(512, 8 * SMALL_ROWS));
        return warmUp(world);
    }

    private WarmUp warmUp(World world) {
        FrameInput whole = world.snapshot();
        return new WarmUp(whole, whole.withSize(64, SMALL_ROWS), () -> nanos);
    }

    /** A slow engine that is not wanted any more would keep the next one waiting. */
    @Test
    void leavesTheFirstPictureBetweenBands() {
        ofMany().run(new Noted("slow", true), () -> rows.size() == 3);
        assertThat(rows).containsExactly(2, 2, 2);
    }

    @Test
    void leavesTheFirstPictureWhereItTakesTooLong() {
        nanosAFrame = TimeUnit.SECONDS.toNanos(3);
        ofMany().run(new Noted("slow", true), () -> false);
        assertThat(rows).containsExactly(2, 2, 2);
    }

    @Test
    void drawsWholePicturesAfterTheFirst() {
        ofMany().run(new Noted("swift", true), () -> false);
        assertThat(rows).hasSize(21).endsWith(SMALL_ROWS);
        assertThat(rows.subList(0, 20)).containsOnly(2);
    }

    @Test
    void drawsWholePicturesAloneOfFewBodies() {
        ofFew().run(new Noted("swift", true), () -> false);
        assertThat(rows).containsExactly(SMALL_ROWS);
    }

    @Test
    void drawsWholePicturesAloneWhereBandsAreNotInProportion() {
        ofMany().run(new Noted("whole", false), () -> false);
        assertThat(rows).containsExactly(SMALL_ROWS);
    }

    @Test
    void drawsThePictureItselfAndRadianceOnADevice() {
        ofMany().run(new Noted("tornado:0:0", false), () -> false);
        assertThat(rows).containsExactly(8 * SMALL_ROWS, SMALL_ROWS);
    }

    @Test
    void drawsNoRadianceOnADeviceThatIsNotWanted() {
        ofMany().run(new Noted("tornado:0:0", false), () -> true);
        assertThat(rows).containsExactly(8 * SMALL_ROWS);
    }
}
