package dev.twister.engine.vector.shortcut;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.engine.Engine;
import dev.twister.engine.Engines;
import dev.twister.image.Frame;
import dev.twister.scene.Camera;
import dev.twister.scene.Ground;
import dev.twister.scene.Light;
import dev.twister.scene.Rendering;
import dev.twister.scene.Rgb;
import dev.twister.scene.Scene;
import dev.twister.scene.Shading;
import dev.twister.scene.Sphere;
import dev.twister.scene.Vector3;
import dev.twister.scene.light.Lights;
import dev.twister.sky.Skybox;
import dev.twister.sky.SkyboxReader;
import dev.twister.world.FrameInput;
import dev.twister.world.World;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Compares the ground's radiance with {@code sequential}'s where highlights and shadows are strongest. */
final class OpenGroundTest {
    private static final Skybox SKY = SkyboxReader.read(Path.of("skyboxes", "day.hdr"));

    /** Parameters start with the light's height above the ground and its distance along the view, in meters. */
    @ParameterizedTest
    @CsvSource({
        "2, 6, 32, 1, 1",
        "2, 6, 31, 1, 1",
        "2, 6, 1, 3, 1",
        "2, 6, 0, 2, 1",
        "2, 6, 128, 0, 1",
        "2, 6, 64, 1, 3",
        "0.3, 40, 32, 1, 1",
        "60, 2, 32, 1, 2",
        "-3, 10, 32, 1, 1",
    })
    void hasTheKernelsRadiance(double lightHeight, double lightAway, double power, int bounces, int samples) {
        FrameInput input = World.of(scene(lightHeight, lightAway, power, bounces, samples), SKY)
                .snapshot();
        float[] expected;
        float[] actual;
        try (Engine sequential = Engines.open("sequential");
                Engine vector = Engines.open("vector")) {
            expected = radiance(sequential, input);
            actual = radiance(vector, input);
        }
        int off = 0;
        for (int k = 0; k < expected.length; k++) {
            off += Math.abs(actual[k] - expected[k]) <= 1e-4f * (1f + expected[k]) ? 0 : 1;
        }
        // The edges of the checker may shift by a pixel.
        assertThat(off).isLessThanOrEqualTo(expected.length / 5000);
    }

    /** Ground in light and in shadow that mirrors a sphere. */
    private static Scene scene(double lightHeight, double lightAway, double power, int bounces, int samples) {
        return Scene.under(Path.of("none.hdr"))
                .withCamera(Camera.of(new Vector3(0, 3, -10), 10, 15, 50))
                .withLights(Lights.of(Light.of(new Vector3(1, lightHeight, lightAway), 0.2, new Rgb(1, 0.9, 0.8))))
                .withGround(Ground.of(200, 0, new Rgb(0.5, 0.4, 0.3), new Rgb(0.2, 0.25, 0.3), power))
                .withSpheres(List.of(Sphere.of(new Vector3(-1, 1, 0), 1, new Rgb(0.3, 0.6, 0.9), 20)))
                .withShading(new Shading(0.05))
                .withRendering(Rendering.DEFAULT
                        .withSize(483, 270)
                        .withShadowSamples(4)
                        .withBounces(bounces)
                        .withSamplesPerPixel(samples));
    }

    private static float[] radiance(Engine engine, FrameInput input) {
        Frame frame = Frame.ofRadiance(input.width(), input.rows());
        engine.render(input, frame);
        return frame.radiance();
    }
}
