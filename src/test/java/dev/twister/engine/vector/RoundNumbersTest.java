package dev.twister.engine.vector;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.engine.Engine;
import dev.twister.engine.Engines;
import dev.twister.image.Frame;
import dev.twister.oracle.PictureDifference;
import dev.twister.scene.Camera;
import dev.twister.scene.Ground;
import dev.twister.scene.Light;
import dev.twister.scene.Rendering;
import dev.twister.scene.Rgb;
import dev.twister.scene.Scene;
import dev.twister.scene.Vector3;
import dev.twister.scene.light.Lights;
import dev.twister.sky.Skybox;
import dev.twister.world.World;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.stream.IntStream;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestInstance;
import org.junit.jupiter.api.TestInstance.Lifecycle;

/**
 * Views in which whole rows or columns of pixels hit the ground at round coordinates: rounding alone must not decide
 * what they show.
 */
@TestInstance(Lifecycle.PER_CLASS)
final class RoundNumbersTest {
    private static final int WIDTH = 320;
    private static final int HEIGHT = 180;
    private static final int SKY = 0xFF0000FF;
    private static final double HALF = 0.5;
    private static final Rgb BRIGHT = new Rgb(0.8, 0.8, 0.8);
    private static final Rgb DARK = new Rgb(0.2, 0.2, 0.2);

    private Engine sequential;
    private Engine vector;

    @BeforeAll
    void open() {
        sequential = Engines.open("sequential");
        vector = Engines.open("vector");
    }

    @AfterAll
    void close() {
        sequential.close();
        vector.close();
    }

    @Test
    void levelViewsFromWholeHeightsHaveTheSameChecks() {
        for (int height : new int[] {1, 2, 5, 149}) {
            for (int fieldOfView = 40; fieldOfView <= 90; fieldOfView += 10) {
                for (int yaw = 0; yaw < 360; yaw += 90) {
                    assertSame(new Vector3(0, height, 0), yaw, 0, fieldOfView, 40);
                    assertSame(new Vector3(3, height, -2), yaw, 0, fieldOfView, 1000);
                }
            }
        }
    }

    /** At a field of view of 90 degrees, row centers lie at distances of height * 180 / (2 k + 1). */
    @Test
    void rowsOnThePlanesBorderAreOnThePlane() {
        for (int height : new int[] {1, 2, 5, 149}) {
            for (int divisor : new int[] {3, 5, 9, 15, 45}) {
                for (int yaw = 0; yaw < 360; yaw += 90) {
                    int[] argb = assertSame(new Vector3(0, height, 0), yaw, 0, 90, 2.0 * height * HEIGHT / divisor);
                    int first = WIDTH * (HEIGHT + divisor - 1) / 2;
                    assertThat(IntStream.range(first, first + WIDTH).filter(pixel -> argb[pixel] == SKY))
                            .as("sky pixels, height %s, divisor %s, yaw %s", height, divisor, yaw)
                            .hasSize(WIDTH - HEIGHT);
                }
            }
        }
    }

    /** Looking straight down, column centers lie at odd multiples of half a meter. */
    @Test
    void columnsOnThePlanesBorderAreOnThePlane() {
        for (int size = 21; size <= 141; size += 20) {
            for (int yaw = 0; yaw < 360; yaw += 90) {
                int[] argb = assertSame(new Vector3(0, HALF * HEIGHT, 0), yaw, 90, 90, size);
                assertThat(Arrays.stream(argb).filter(pixel -> pixel != SKY))
                        .as("plane pixels, %s m, yaw %s", size, yaw)
                        .hasSize((size + 1) * (size + 1));
            }
        }
    }

    /** Returns the picture after checking that both engines render it the same. */
    private int[] assertSame(Vector3 position, double yaw, double pitch, double fieldOfView, double size) {
        Scene scene = Scene.under(Path.of("none.hdr"))
                .withCamera(Camera.of(position, yaw, pitch, fieldOfView))
                .withLights(Lights.of(Light.of(new Vector3(3, 170, -3), 0.5, new Rgb(1, 1, 1))))
                .withGround(Ground.of(size, 0, BRIGHT, DARK, 0))
                .withRendering(Rendering.DEFAULT
                        .withSize(WIDTH, HEIGHT)
                        .withShadowSamples(1)
                        .withBounces(1));
        int[] argb = argb(sequential, scene);
        PictureDifference difference = PictureDifference.between(argb(vector, scene), argb);
        assertThat(difference)
                .as("at %s, yaw %s, pitch %s, %s degrees, plane of %s m", position, yaw, pitch, fieldOfView, size)
                .matches(PictureDifference::isWithinBound, "is within the design's bound");
        return argb;
    }

    private static int[] argb(Engine engine, Scene scene) {
        Frame frame = Frame.ofPixels(WIDTH, HEIGHT);
        engine.render(World.of(scene, new Skybox(1, 1, new float[] {0, 0, 1})).snapshot(), frame);
        return frame.argb();
    }
}
