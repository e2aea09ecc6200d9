package dev.twister.engine.vector;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.engine.Engine;
import dev.twister.engine.Engines;
import dev.twister.engine.JvmEngines;
import dev.twister.image.Frame;
import dev.twister.kernel.Views;
import dev.twister.scene.Camera;
import dev.twister.scene.Integrator;
import dev.twister.scene.Light;
import dev.twister.scene.Scene;
import dev.twister.scene.Vector3;
import dev.twister.scene.format.SceneReader;
import dev.twister.scene.light.Lights;
import dev.twister.scene.select.VisibleBodies;
import dev.twister.world.FrameInput;
import dev.twister.world.SceneImages;
import dev.twister.world.SceneMeshes;
import dev.twister.world.World;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Paths in lanes are those of the scalar kernel, in every bit. */
final class PathsInLanesTest {
    private static final int CROWD = 250;

    static Stream<Object[]> widthsAndScenes() {
        return WidthLoader.WIDTHS.stream()
                .flatMap(bits -> Stream.of("weekend", "cornell").map(scene -> new Object[] {bits, scene}));
    }

    @ParameterizedTest(name = "{1} at {0} bits")
    @MethodSource("widthsAndScenes")
    void shippedScenesAreTheSame(int bits, String scene) {
        FrameInput input = shipped(scene, 39, 27, 2);
        try (Engine vector = WidthLoader.openForCrowds(bits, 2, CROWD)) {
            assertSame(vector, input);
        }
    }

    /** Several lights, maps, masks and blended layers, unlit bodies, rough glass, metals and the lens. */
    @Tag("slow")
    @ParameterizedTest
    @ValueSource(
            strings = {
                "atrium",
                "bokeh",
                "gallery",
                "glass",
                "knot",
                "lamps",
                "maps",
                "metals",
                "planets",
                "spheres-10000"
            })
    void otherScenesAreTheSame(String scene) {
        try (Engine vector = VectorEngines.open(2, CROWD)) {
            assertSame(vector, shipped(scene, 71, 43, 3));
        }
    }

    @ParameterizedTest
    @EnumSource(Camera.Projection.class)
    void projectionsAreTheSame(Camera.Projection projection) {
        World world = world("weekend", 29, 23, 2);
        world.setCamera(world.scene().camera().withProjection(projection).withAperture(0.1));
        try (Engine vector = VectorEngines.open(2, CROWD)) {
            assertSame(vector, world.snapshot());
        }
    }

    /** A sharp sun, a wide one and a spot, beside the sky. */
    @Test
    void sunsAndSpotsAreTheSame() {
        World world = world("weekend", 39, 27, 4);
        world.show(world.scene()
                .withLights(new Lights(List.of(
                        Light.sun(new Vector3(-1, -1, 1), 0),
                        Light.sun(new Vector3(1, -1, 0.5), 30),
                        Light.spot(new Vector3(0, 6, 0), 0.3, new Vector3(0.2, -1, 0), 70)
                                .withStrength(40),
                        Light.spot(new Vector3(2, 1.5, -1), 0.8, new Vector3(-1, 0.1, 0.3), 90)
                                .withStrength(2)))));
        try (Engine vector = VectorEngines.open(2, CROWD)) {
            assertSame(vector, world.snapshot());
        }
        try (Engine packets = VectorEngines.open(2)) {
            assertSame(packets, world.snapshot());
        }
    }

    /** As it is before made lanes are warm. */
    @ParameterizedTest
    @ValueSource(strings = {"weekend", "cornell", "maps"})
    void packetsWithTheKernelAreTheSame(String scene) {
        try (Engine vector = VectorEngines.open(2)) {
            assertSame(vector, shipped(scene, 39, 27, 2));
        }
    }

    /** Guides of denoising, and a range of the samples. */
    @Test
    void guidesAreTheSame() {
        assertLayersAreSame(shipped("lamps", 23, 17, 4).withGuides());
    }

    @ParameterizedTest
    @ValueSource(strings = {"lamps", "maps"})
    void lightLayersAreTheSame(String name) {
        World world = world(name, 23, 17, 4);
        assertLayersAreSame(world.snapshot().withLightLayers(world.lightGroups()));
    }

    /** Without background; masked and blended meshes among them. */
    @ParameterizedTest
    @ValueSource(strings = {"lamps", "maps"})
    void alphaIsTheSame(String name) {
        World world = world(name, 23, 17, 4);
        assertLayersAreSame(world.snapshot().withoutBackground());
        assertLayersAreSame(
                world.snapshot().withLightLayers(world.lightGroups()).withoutBackground());
    }

    private static void assertLayersAreSame(FrameInput input) {
        try (Engine vector = VectorEngines.open(2, CROWD)) {
            assertSame(vector, input.withSamples(1, 3));
        }
    }

    private static void assertSame(Engine vector, FrameInput input) {
        assertThat(vector.declines(input)).isFalse();
        Frame lanes = drawn(vector, input);
        try (Engine sequential = Engines.open(JvmEngines.SEQUENTIAL)) {
            Frame kernel = drawn(sequential, input);
            assertThat(lanes.radiance()).isEqualTo(kernel.radiance());
            assertThat(lanes.layers()).isEqualTo(kernel.layers());
        }
    }

    private static Frame drawn(Engine engine, FrameInput input) {
        Frame frame = input.stageOrView() == Views.FULL
                ? Frame.ofRadiance(input.width(), input.rows())
                : Frame.ofRadiance(input.width(), input.rows(), input.layers());
        engine.render(input, frame);
        return frame;
    }

    private static FrameInput shipped(String name, int width, int height, int samples) {
        return world(name, width, height, samples).snapshot();
    }

    private static World world(String name, int width, int height, int samples) {
        Scene scene = VisibleBodies.of(SceneReader.read(Path.of("scenes", name + ".json")));
        SceneMeshes meshes = SceneMeshes.read(scene, _ -> {});
        World world = World.of(scene, SceneImages.read(scene, meshes, _ -> {}), meshes);
        world.setSettings(world.settings()
                .withIntegrator(Integrator.PATH)
                .withSize(width, height)
                .withSamplesPerPixel(samples));
        return world;
    }
}
