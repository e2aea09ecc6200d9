package dev.twister.oracle;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.engine.JvmEngines;
import dev.twister.kernel.Layout;
import dev.twister.scene.Camera;
import dev.twister.scene.Integrator;
import dev.twister.scene.Light;
import dev.twister.scene.Material;
import dev.twister.scene.Rendering;
import dev.twister.scene.Rgb;
import dev.twister.scene.Scene;
import dev.twister.scene.Sphere;
import dev.twister.scene.Vector3;
import dev.twister.scene.light.LightGroup;
import dev.twister.scene.light.Lights;
import dev.twister.scene.material.Emission;
import dev.twister.sky.Skybox;
import dev.twister.world.FrameInput;
import dev.twister.world.View;
import dev.twister.world.World;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Many emitters are chosen by a tree: the mean is that of a choice by power, the noise is less. */
class LightTreeTest {
    private static final int RUNS = 24;
    private static final int SAMPLES = 16;

    /** The mean of all pixels over some runs, its standard error, and the mean squared difference between runs. */
    private record Estimate(double mean, double error, double noise) {}

    @ParameterizedTest
    @ValueSource(doubles = {0, 1})
    void theMeanIsThatOfAChoiceByPower(double skyStrength) {
        FrameInput byTree = hall(60, skyStrength).world().snapshot();
        assertThat(byTree.view().frame()[Layout.LIGHT_TREE]).isPositive();
        Estimate tree = estimate(byTree);
        Estimate power = estimate(withoutTree(byTree));
        double error = Math.sqrt(tree.error() * tree.error() + power.error() * power.error());
        assertThat(Math.abs(tree.mean() - power.mean())).isLessThan(3 * error);
        assertThat(error).isLessThan(0.02 * tree.mean());
    }

    @Test
    void theNoiseOfManyLampsIsAThird() {
        FrameInput byTree = hall(1500, 0).world().snapshot();
        assertThat(estimate(byTree).noise() / estimate(withoutTree(byTree)).noise())
                .isLessThan(1 / 3.0);
    }

    @Test
    void fewEmittersHaveNoTree() {
        FrameInput input = hall(5, 1).world().snapshot();
        assertThat(input.view().frame()[Layout.LIGHT_TREE]).isZero();
    }

    @Test
    void theTreeFollowsSpheresThatMove() {
        LitScene hall = hall(60, 0);
        World world = hall.world();
        world.snapshot();
        List<Sphere> moved = hall.scene().spheres().stream()
                .map(sphere -> sphere.withPosition(sphere.position().plus(new Vector3(0, 1, 0))))
                .toList();
        Scene other = hall.scene().withSpheres(moved);
        world.show(other);
        assertThat(world.snapshot().bodies().looks())
                .isEqualTo(World.of(other, hall.images()).snapshot().bodies().looks());
    }

    private static Estimate estimate(FrameInput input) {
        double[] means = new double[RUNS];
        double[] sums = new double[3 * input.width() * input.height()];
        double[] squares = new double[sums.length];
        double mean = 0;
        for (int run = 0; run < RUNS; run++) {
            float[] radiance =
                    Pictures.radiance(JvmEngines.PARALLEL, input.withSamples(run * SAMPLES, SAMPLES));
            for (int i = 0; i < radiance.length; i++) {
                means[run] += radiance[i] / (double) radiance.length;
                sums[i] += radiance[i];
                squares[i] += (double) radiance[i] * radiance[i];
            }
            mean += means[run] / RUNS;
        }
        double spread = 0;
        for (double one : means) {
            spread += (one - mean) * (one - mean);
        }
        double noise = 0;
        for (int i = 0; i < sums.length; i++) {
            noise += squares[i] / RUNS - sums[i] / RUNS * (sums[i] / RUNS);
        }
        return new Estimate(mean, Math.sqrt(spread / (RUNS - 1) / RUNS), noise / sums.length);
    }

    private static FrameInput withoutTree(FrameInput input) {
        float[] frame = input.view().frame().clone();
        frame[Layout.LIGHT_TREE] = 0;
        return new FrameInput(new View(frame, input.view().stageOrView()), input.bodies(), input.images());
    }

    /** A floor from above, under lamps that are out of sight, half of them spheres that emit. */
    private static LitScene hall(int lamps, double skyStrength) {
        Random random = new Random(3);
        List<Light> lights = new ArrayList<>();
        List<Sphere> spheres = new ArrayList<>();
        double side = Math.sqrt(lamps);
        for (int i = 0; i < lamps; i++) {
            Vector3 place = new Vector3(
                    side * (random.nextDouble() - 0.5), 0.5 + 0.5 * random.nextDouble(), side * (random.nextDouble() - 0.5));
            if (i % 2 == 0) {
                lights.add(Light.of(place, 0.02, new Rgb(1, 1, 0.5)).withStrength(0.1));
            } else {
                spheres.add(Sphere.of(place, 0.02, emitting(new Rgb(100, 250, 250))));
            }
        }
        Scene scene = Scene.under(Path.of("none.hdr"));
        Rendering settings = scene.rendering().withSize(16, 12).withBounces(2).withClamp(0).withIntegrator(Integrator.PATH);
        return new LitScene(
                scene.withRendering(settings)
                        .withLights(new Lights(lights))
                        .withSpheres(spheres)
                        .withSky(scene.sky().withStrength(skyStrength))
                        .withGround(scene.ground().withSize(side))
                        .withCamera(Camera.of(new Vector3(0, 0.4, -0.1), 0, 88, 60)),
                new Skybox(1, 1, new float[] {0.2f, 0.3f, 0.4f}));
    }

    private static Material emitting(Rgb radiance) {
        return Material.DEFAULT
                .withColor(new Rgb(0, 0, 0))
                .withEmission(new Emission(radiance, 1, true, LightGroup.NONE));
    }
}
