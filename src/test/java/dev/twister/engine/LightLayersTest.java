package dev.twister.engine;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import dev.twister.image.Frame;
import dev.twister.kernel.Guides;
import dev.twister.oracle.LitScene;
import dev.twister.oracle.ShippedScenes;
import dev.twister.scene.Integrator;
import dev.twister.scene.Light;
import dev.twister.scene.Scene;
import dev.twister.scene.light.Lights;
import dev.twister.world.FrameInput;
import dev.twister.world.LightGroups;
import dev.twister.world.World;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The light of each group of lights, whose sum is the picture. */
class LightLayersTest {
    @ParameterizedTest
    @CsvSource({
        "cornell,PATH",
        "glass,PATH",
        "maps,PATH",
        "lamps,PATH",
        "cornell,WHITTED",
        "glass,WHITTED",
        "metals,WHITTED",
        "maps,WHITTED",
        "lamps,WHITTED"
    })
    void sumUpToThePicture(String scene, Integrator integrator) {
        World world = world(scene, integrator);
        FrameInput input = world.snapshot();
        Frame plain = render(JvmEngines.PARALLEL, input);
        Frame layered = render(JvmEngines.PARALLEL, input.withLightLayers(world.lightGroups()));

        assertThat(layered.radiance()).isEqualTo(plain.radiance());
        for (int i = 0; i < plain.radiance().length; i++) {
            float sum = 0;
            for (int layer = Guides.LAYERS; layer < layered.layerCount(); layer++) {
                sum += layered.layers()[layered.firstOf(layer) + i];
            }
            assertThat(sum).isCloseTo(plain.radiance()[i], within(1e-5f * (1 + plain.radiance()[i])));
        }
    }

    @ParameterizedTest
    @CsvSource({"sequential,PATH", "vector,PATH", "sequential,WHITTED", "vector,WHITTED"})
    void areTheSameOnEveryEngine(String engine, Integrator integrator) {
        World world = world("lamps", integrator);
        FrameInput input = world.snapshot().withLightLayers(world.lightGroups());

        assertThat(render(engine, input).layers())
                .isEqualTo(render(JvmEngines.PARALLEL, input).layers());
    }

    @Test
    void haveTheLightOfTheirGroupAlone() {
        LitScene lamps = ShippedScenes.small("lamps");
        World world = lamps.world();
        Scene scene = grouped(small(lamps.scene(), Integrator.PATH));
        world.show(scene);
        LightGroups groups = world.lightGroups();
        Frame layered = render(JvmEngines.PARALLEL, world.snapshot().withLightLayers(groups));
        world.show(scene.withLights(darkBut("odd", scene.lights()))
                .withSky(scene.sky().withStrength(0)));
        Frame alone = render(JvmEngines.PARALLEL, world.snapshot().withSamples(0, 256));

        int layer = Guides.LAYERS + groups.names().indexOf("odd");
        assertThat(mean(layered.layers(), layered.firstOf(layer), alone.radiance().length))
                .isCloseTo(mean(alone.radiance(), 0, alone.radiance().length), within(0.02));
    }

    @Test
    void namesAreThoseOfTheSceneAndTheUsualOnes() {
        LitScene lamps = ShippedScenes.small("lamps");
        World world = lamps.world();
        world.show(grouped(small(lamps.scene(), Integrator.WHITTED)));

        assertThat(world.lightGroups().names()).containsExactly("sky", "ambient", "lights", "odd");
    }

    @Test
    void withoutASkyThereIsNoneOfIt() {
        World world = world("cornell", Integrator.PATH);

        assertThat(world.lightGroups().names()).doesNotContain("sky").contains("emitters");
    }

    private static Scene grouped(Scene scene) {
        List<Light> lights = new ArrayList<>();
        for (int index = 0; index < scene.lights().count(); index++) {
            lights.add(
                    index % 2 == 0
                            ? scene.lights().get(index)
                            : scene.lights().get(index).withGroup("odd"));
        }
        return scene.withLights(new Lights(lights));
    }

    private static Lights darkBut(String group, Lights lights) {
        return new Lights(lights.list().stream()
                .map(light -> light.group().equals(group) ? light : light.withStrength(0.0))
                .toList());
    }

    private static double mean(float[] values, int first, int count) {
        double sum = 0;
        for (int i = first; i < first + count; i++) {
            sum += values[i];
        }
        return sum / count;
    }

    private static World world(String name, Integrator integrator) {
        LitScene small = ShippedScenes.small(name);
        World world = small.world();
        world.show(small(small.scene(), integrator));
        return world;
    }

    private static Scene small(Scene scene, Integrator integrator) {
        return scene.withRendering(scene.rendering()
                .withSize(48, 27)
                .withIntegrator(integrator)
                .withShadowSamples(4)
                .withSamplesPerPixel(8));
    }

    private static Frame render(String engineId, FrameInput input) {
        Frame frame = Frame.ofRadiance(input.width(), input.rows(), input.layers());
        try (Engine engine = Engines.open(engineId)) {
            engine.render(input, frame);
        }
        return frame;
    }
}
