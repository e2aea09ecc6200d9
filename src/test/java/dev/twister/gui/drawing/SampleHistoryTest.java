package dev.twister.gui.drawing;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import dev.twister.denoise.NoisyPicture;
import dev.twister.denoise.Plane;
import dev.twister.engine.Engine;
import dev.twister.engine.JvmEngines;
import dev.twister.image.Frame;
import dev.twister.kernel.Layout;
import dev.twister.scene.Camera;
import dev.twister.scene.Ground;
import dev.twister.scene.Rgb;
import dev.twister.scene.Scene;
import dev.twister.scene.Sphere;
import dev.twister.scene.Vector3;
import dev.twister.sky.Skybox;
import dev.twister.world.FrameInput;
import dev.twister.world.StageOrView;
import dev.twister.world.World;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import org.junit.jupiter.api.Test;

/** A white ball over a gray floor, lit alike everywhere, with noise. */
class SampleHistoryTest {
    private static final int WIDTH = 64;
    private static final int HEIGHT = 48;
    private static final int PIXELS = WIDTH * HEIGHT;
    private static final Camera CAMERA = Camera.of(new Vector3(0, 2, -6), 0, 15, 50);
    private static final float FLOOR = 0.3f;

    private final Random random = new Random(20261128);

    @Test
    void samplesFromElsewhereAreUsed() {
        SampleHistory history = history(CAMERA, Optional.empty());
        double alone = error(history);
        for (int picture = 1; picture < 12; picture++) {
            history = history(
                    CAMERA.withPosition(new Vector3(0.05 * picture, 2, -6)).withYawDegrees(0.4 * picture),
                    Optional.of(history));
        }

        assertThat(error(history)).isLessThan(alone / 4);
        assertThat(history.nextSample()).isEqualTo(12);
    }

    @Test
    void fromTheSamePlaceItIsTheMeanOfAll() {
        SampleHistory first = history(CAMERA, Optional.empty());
        SampleHistory second = history(CAMERA, Optional.of(first));
        SampleHistory alone = history(CAMERA, Optional.empty());
        SampleHistory third = history(CAMERA, Optional.of(alone));

        assertThat(error(second)).isCloseTo(error(third), within(0.2 * error(third)));
        assertThat(error(second)).isCloseTo(error(first) / 2, within(0.1 * error(first)));
        NoisyPicture.Noise noise = second.noisy().noise().orElseThrow();
        assertThat(squares(noise.difference().values()) / PIXELS)
                .as("variance")
                .isCloseTo(error(second), within(0.1 * error(second)));
    }

    @Test
    void whatWasOutsideOrHiddenHasOnlyNewSamples() {
        SampleHistory behind = history(CAMERA.withYawDegrees(180), Optional.empty());
        SampleHistory first = history(CAMERA, Optional.empty());
        long seed = 7;
        random.setSeed(seed);
        SampleHistory turned = history(CAMERA, Optional.of(behind));
        random.setSeed(seed);
        SampleHistory alone = history(CAMERA, Optional.empty());

        assertThat(turned.noisy().radiance().values())
                .containsExactly(alone.noisy().radiance().values());

        // From far to the right, the floor that the ball has hidden is seen, and nothing of the ball's light is on it.
        Camera right = CAMERA.withPosition(new Vector3(3, 2, -6)).withYawDegrees(-26);
        SampleHistory moved = history(right, Optional.of(first));
        float[] albedo = moved.noisy().guides().orElseThrow().albedo().values();
        for (float color : albedo) {
            assertThat(color * (color - FLOOR) * (color - 1)).as("product").isCloseTo(0, within(1e-6f));
        }
    }

    /** The picture of a camera, with noise in its light. */
    private SampleHistory history(Camera camera, Optional<SampleHistory> earlier) {
        Rgb white = new Rgb(1, 1, 1);
        Scene scene = Scene.under(Path.of("white.hdr"))
                .withCamera(camera)
                .withGround(Ground.of(40, 0, white, white, 0))
                .withSpheres(List.of(Sphere.of(new Vector3(0, 1, 0), 1, white, 0)));
        scene = scene.withRendering(scene.rendering().withSize(WIDTH, HEIGHT));
        FrameInput input =
                World.of(scene, new Skybox(1, 1, new float[] {1, 1, 1})).snapshot();
        float[] distances = new float[PIXELS];
        float[] albedo = new float[3 * PIXELS];
        float[] normal = new float[3 * PIXELS];
        float[] radiance = new float[3 * PIXELS];
        try (Engine engine = JvmEngines.parallel().opener().get()) {
            float[] depth = drawn(engine, input, StageOrView.DEPTH);
            float[] body = drawn(engine, input, StageOrView.BODY);
            float[] normals = drawn(engine, input, StageOrView.NORMAL);
            for (int pixel = 0; pixel < PIXELS; pixel++) {
                int at = 3 * pixel;
                distances[pixel] = depth[at];
                float color = body[at] == Layout.PLANE ? FLOOR : body[at] >= Layout.FIRST_SPHERE ? 1 : 0;
                Arrays.fill(albedo, at, at + 3, color);
                System.arraycopy(normals, at, normal, at, 3);
                Arrays.fill(radiance, at, at + 3, light(color) * (float) (1 + 0.5 * random.nextGaussian()));
            }
        }
        NoisyPicture picture = new NoisyPicture(
                WIDTH,
                HEIGHT,
                new Plane(radiance, 0),
                Optional.of(new NoisyPicture.Guides(new Plane(albedo, 0), new Plane(normal, 0))));
        return new SampleHistory(new SampleHistory.View(input, distances), picture, 1, earlier);
    }

    private static float light(float albedo) {
        return albedo > 0 ? albedo : 1;
    }

    private static float[] drawn(Engine engine, FrameInput input, StageOrView view) {
        Frame frame = Frame.ofRadiance(WIDTH, HEIGHT, 0);
        engine.render(input.showing(view), frame);
        return frame.radiance();
    }

    /** Of the red light. */
    private static double error(SampleHistory history) {
        float[] radiance = history.noisy().radiance().values();
        float[] albedo = history.noisy().guides().orElseThrow().albedo().values();
        double sum = 0;
        for (int i = 0; i < radiance.length; i += 3) {
            double difference = radiance[i] - light(albedo[i]);
            sum += difference * difference;
        }
        return sum / PIXELS;
    }

    private static double squares(float[] values) {
        double sum = 0;
        for (int i = 0; i < values.length; i += 3) {
            sum += values[i] * values[i];
        }
        return sum;
    }
}
