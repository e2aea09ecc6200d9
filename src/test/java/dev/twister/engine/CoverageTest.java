package dev.twister.engine;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import dev.twister.SceneBuilder;
import dev.twister.image.AlphaChannel;
import dev.twister.image.Frame;
import dev.twister.oracle.Pictures;
import dev.twister.scene.Camera;
import dev.twister.scene.Ground;
import dev.twister.scene.Integrator;
import dev.twister.scene.Material;
import dev.twister.scene.Mesh;
import dev.twister.scene.Rendering;
import dev.twister.scene.Rgb;
import dev.twister.scene.Shape;
import dev.twister.scene.Sphere;
import dev.twister.scene.Vector3;
import dev.twister.scene.material.Alpha;
import dev.twister.world.FrameInput;
import dev.twister.world.World;
import java.util.Arrays;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;

/** Alpha of pictures without background, and their colors, which are multiplied by it. */
class CoverageTest {
    private static final int WIDTH = 48;
    private static final int HEIGHT = 36;
    private static final Rgb SKY = new Rgb(0.5, 0.7, 2);
    private static final float[] SKY_CHANNELS = {0.5f, 0.7f, 2};
    private static final Material MATTE = Material.DEFAULT.withReflectivity(0).withColor(new Rgb(0.7, 0.3, 0.1));

    /** The picture over the sky is the picture with the sky. */
    @ParameterizedTest
    @CsvSource({"WHITTED,0.4", "WHITTED,0.95", "PATH,0.4", "PATH,0.95"})
    void overTheSkyItIsThePicture(Integrator integrator, double opacity) {
        FrameInput input = world(integrator, opacity, 100).snapshot();
        float[] plain = Pictures.linear(JvmEngines.PARALLEL, input).radiance();
        Frame cut = Pictures.linear(JvmEngines.PARALLEL, input.withoutBackground());

        assertThat(cut.layerCount()).isEqualTo(1);
        for (int i = 0; i < plain.length; i++) {
            float sky = (1 - cut.layers()[i]) * SKY_CHANNELS[i % 3];
            assertThat(cut.radiance()[i] + sky).isCloseTo(plain[i], within(1e-5f * (1 + plain[i])));
        }
    }

    /** Mirrors and glass cover the background; of two blended layers the part goes through that each lets through. */
    @ParameterizedTest
    @EnumSource(Integrator.class)
    void isWhatCoversTheBackground(Integrator integrator) {
        World world = world(integrator, 0.4, 0);
        world.setSettings(world.settings().withSamplesPerPixel(256));
        Frame cut = Pictures.linear(JvmEngines.PARALLEL, world.snapshot().withoutBackground());

        assertThat(alpha(cut, 2, 2)).isZero();
        assertThat(alpha(cut, 8, 18)).isEqualTo(1);
        assertThat(alpha(cut, 24, 18)).isEqualTo(1);
        assertThat(alpha(cut, 37, 18)).isCloseTo(1 - 0.6f * 0.6f, within(0.08f));
        assertThat(IntStream.range(0, 12).mapToObj(column -> alpha(cut, column, 18)))
                .anyMatch(alpha -> alpha > 0.05f && alpha < 0.95f);
    }

    @ParameterizedTest
    @CsvSource({"sequential,PATH", "vector,PATH", "sequential,WHITTED", "vector,WHITTED"})
    void isTheSameOnEveryEngine(String engine, Integrator integrator) {
        World world = world(integrator, 0.4, 20);
        FrameInput input = world.snapshot().withLightLayers(world.lightGroups()).withoutBackground();
        Frame expected = Pictures.linear(JvmEngines.PARALLEL, input);
        Frame frame = Pictures.linear(engine, input);

        assertThat(frame.radiance()).isEqualTo(expected.radiance());
        assertThat(frame.layers()).isEqualTo(expected.layers());
    }

    /** Guides and light layers know no background either, and come before alpha. */
    @ParameterizedTest
    @EnumSource(Integrator.class)
    void otherLayersHaveNoBackground(Integrator integrator) {
        World world = world(integrator, 0.4, 20);
        FrameInput input = world.snapshot();
        Frame cut = Pictures.linear(JvmEngines.PARALLEL, input.withoutBackground());
        FrameInput layeredInput = input.withLightLayers(world.lightGroups()).withoutBackground();
        Frame layered = Pictures.linear(JvmEngines.PARALLEL, layeredInput);

        int last = layered.firstOf(layered.layerCount() - 1);
        assertThat(Arrays.copyOfRange(layered.layers(), last, layered.layers().length))
                .isEqualTo(cut.layers());
        assertThat(layered.radiance()).isEqualTo(cut.radiance());
        for (int layer = 0; layer < layered.layerCount(); layer++) {
            assertThat(layered.layers()[layered.firstOf(layer)]).isZero();
        }
    }

    /** A black silhouette has no noise of its own; that of its edge shows over other backgrounds. */
    @Test
    void theNoiseOfAlphaCounts() {
        FrameInput black = new SceneBuilder()
                .camera(Camera.of(new Vector3(0, 0, -4), 0, 0, 40))
                .ground(Ground.of(1, -500, new Rgb(0, 0, 0), new Rgb(0, 0, 0), 0))
                .sphere(Sphere.of(new Vector3(0, 0, 0), 1, MATTE.withColor(new Rgb(0, 0, 0))))
                .sky(SKY)
                .ambient(0)
                .rendering(Rendering.DEFAULT.withSize(32, 32))
                .world()
                .snapshot()
                .withoutBackground();
        Frame frame = Frame.ofRadiance(32, 32, 1);
        try (Engine engine = Engines.open(JvmEngines.PARALLEL)) {
            ConvergingPicture.Convergence reached = ConvergingPicture.draw(engine, black, frame, 0.01, 256, _ -> {})
                    .reached();

            assertThat(reached.samples()).isGreaterThan(32);
            assertThat(reached.noise()).isGreaterThan(0);
        }
        assertThat(frame.radiance()).containsOnly(0);
        assertThat(AlphaChannel.of(frame).straight(frame.radiance())).containsOnly(0);
    }

    /** A matte ball, a ball of glass, and a blended box, whose sides the view passes twice. */
    private static World world(Integrator integrator, double opacity, double reflectivity) {
        Material pane = MATTE.withReflectivity(reflectivity).withAlpha(new Alpha(Alpha.Mode.BLEND, opacity, 0.5));
        Material glass = MATTE.withTransmission(1).withIor(1.5);
        Mesh square = Mesh.of(Shape.of(Shape.Kind.BOX, 1)).withMaterial(pane);
        return new SceneBuilder()
                .camera(Camera.of(new Vector3(0, 0, -8), 0, 0, 40))
                .ground(Ground.of(1, -500, new Rgb(0, 0, 0), new Rgb(0, 0, 0), 0))
                .sphere(Sphere.of(new Vector3(-2.4, 0, 0), 1, MATTE.withReflectivity(40)))
                .sphere(Sphere.of(new Vector3(0, 0, 0), 1, glass))
                .mesh(square.withPosition(new Vector3(2.2, 0, 0)))
                .sky(SKY)
                .rendering(Rendering.DEFAULT
                        .withSize(WIDTH, HEIGHT)
                        .withBounces(6)
                        .withIntegrator(integrator)
                        .withShadowSamples(2)
                        .withSamplesPerPixel(4))
                .world();
    }

    private static float alpha(Frame cut, int column, int row) {
        return cut.layers()[3 * (WIDTH * row + column)];
    }
}
