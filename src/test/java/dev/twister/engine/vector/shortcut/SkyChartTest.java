package dev.twister.engine.vector.shortcut;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import dev.twister.engine.vector.frame.Drawing;
import dev.twister.engine.vector.lanes.Tile;
import dev.twister.engine.vector.step.CameraLanes;
import dev.twister.image.Frame;
import dev.twister.scene.Camera;
import dev.twister.scene.Scene;
import dev.twister.scene.Vector3;
import dev.twister.scene.format.SceneReader;
import dev.twister.sky.Skybox;
import dev.twister.world.FrameInput;
import dev.twister.world.World;
import java.nio.file.Path;
import java.util.Random;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/** Compares the polynomials with double-precision angles, at all pixels of random tiles. */
final class SkyChartTest {
    private static final Scene SCENE = SceneReader.read(Path.of("scenes/teaching.json"));
    private static final int SKY_WIDTH = 64;
    private static final int SKY_HEIGHT = 32;
    private static final Skybox SKY = new Skybox(SKY_WIDTH, SKY_HEIGHT, new float[3 * SKY_WIDTH * SKY_HEIGHT]);

    /** Sum, in radians, of the errors of polynomial, float direction, float arc tangent and float full turn. */
    private static final double MOST_ERROR = 1e-6 + 2e-7 + 2e-7 + 8e-7;

    private final Drawing drawing = new Drawing();
    private final SkyChart chart = new SkyChart();
    private final Tile tile = new Tile();
    private int covered;
    private int uncovered;

    @Tag("slow")
    @Test
    void isAsExactAsColumnsAndRowsAreAsFloats() {
        Random random = new Random(20261123);
        for (int count = 0; count < 2000; count++) {
            int height = 32 + random.nextInt(2000);
            look(
                    360 * random.nextDouble(),
                    180 * random.nextDouble() - 90,
                    1 + 100 * random.nextDouble(),
                    height + random.nextInt(height),
                    height);
            for (int tiles = 0; tiles < 8; tiles++) {
                checkTile(random.nextInt(drawing.tiles()), random.nextInt(3));
            }
        }
        assertThat(covered).as("covered tiles").isGreaterThan(4000);
        assertThat(uncovered).as("uncovered tiles").isGreaterThan(1000);
    }

    @Test
    void leavesOutTheZenithTheNadirAndTheSeam() {
        for (double pitch : new double[] {-90, 90}) {
            look(0, pitch, 50, 1920, 1080);
            assertThat(covers(1920 / 2, 1080 / 2)).as("pitch %f", pitch).isFalse();
            assertThat(covers(1920 / 2, 0))
                    .as("the horizon's side of pitch %f", pitch)
                    .isFalse();
        }
        // The seam of the panorama is behind the start direction; here it crosses a block of four tiles.
        look(180, 0, 50, 1900, 1080);
        assertThat(covers(900, 0)).isFalse();
        assertThat(covers(950, 1079)).isFalse();
        assertThat(covers(960, 1079)).isTrue();
        assertThat(covers(890, 0)).isTrue();
        look(0, 0, 50, 1900, 1080);
        assertThat(covers(950, 0)).isTrue();
    }

    @Test
    void leavesOutPicturesOfFewPixels() {
        look(0, 0, 50, 160, 90);
        assertThat(covers(80, 45)).isFalse();
        look(0, 0, 50, 1280, 720);
        assertThat(covers(640, 360)).isTrue();
    }

    /** The chart must not reuse a block's polynomials in the next frame. */
    @Test
    void followsTheCamera() {
        look(0, 0, 50, 1280, 720);
        checkTile(0, 0);
        look(40, -10, 50, 1280, 720);
        checkTile(0, 0);
        assertThat(covered).isEqualTo(2);
    }

    private void look(double yaw, double pitch, double fieldOfView, int width, int height) {
        World world = World.of(SCENE, SKY);
        world.setCamera(Camera.of(new Vector3(0, 1, 0), yaw, pitch, fieldOfView));
        world.setSettings(world.settings().withSize(width, height).withSamplesPerPixel(3));
        FrameInput input = world.snapshot();
        drawing.take(input, Frame.ofPixels(1, 1), false);
        chart.start(drawing);
    }

    private boolean covers(int x, int y) {
        tile.left = x / Tile.SIDE * Tile.SIDE;
        tile.top = y / Tile.SIDE * Tile.SIDE;
        return chart.covers(tile, drawing);
    }

    private void checkTile(int number, int sample) {
        tile.left = number % drawing.tilesAcross() * Tile.SIDE;
        tile.top = number / drawing.tilesAcross() * Tile.SIDE;
        tile.sample = sample;
        tile.live.addAll();
        tile.skies.addAll();
        if (chart.covers(tile, drawing)) {
            covered++;
            CameraLanes.aim(tile, drawing);
            chart.spread(tile, drawing);
            chart.place(tile, drawing, false);
            check(1);
            chart.place(tile, drawing, true);
            check(-1);
        } else {
            uncovered++;
        }
    }

    private void check(int turned) {
        float[] t = tile.values;
        for (int pixel = 0; pixel < Tile.SIZE; pixel++) {
            double x = t[Tile.DIRECTION_X + pixel];
            double y = turned * t[Tile.DIRECTION_Y + pixel];
            double z = t[Tile.DIRECTION_Z + pixel];
            double column = (Math.atan2(x, z) / (2 * Math.PI) + 0.5) * SKY_WIDTH + 0.5;
            double row = (0.5 - Math.atan2(y, Math.hypot(x, z)) / Math.PI) * SKY_HEIGHT + 0.5;
            double level = Math.hypot(x, z);
            assertThat((double) t[Tile.SKY_TO_RIGHT + pixel])
                    .as("column of (%f, %f, %f)", x, y, z)
                    .isCloseTo(column, within(MOST_ERROR / level * SKY_WIDTH / (2 * Math.PI)));
            assertThat((double) t[Tile.SKY_TO_BOTTOM + pixel])
                    .as("row of (%f, %f, %f)", x, y, z)
                    .isCloseTo(row, within(MOST_ERROR * SKY_HEIGHT / Math.PI));
        }
    }
}
