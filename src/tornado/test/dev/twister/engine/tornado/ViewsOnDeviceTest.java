package dev.twister.engine.tornado;

import dev.twister.engine.Engine;
import dev.twister.engine.EngineOffer;
import dev.twister.scene.Camera;
import dev.twister.scene.Integrator;
import dev.twister.scene.Rendering;
import dev.twister.scene.Scene;
import dev.twister.scene.format.SceneReader;
import dev.twister.world.SceneImages;
import dev.twister.world.SceneMeshes;
import dev.twister.world.StageOrView;
import dev.twister.world.World;
import java.nio.file.Path;
import java.util.stream.Stream;
import org.junit.jupiter.api.Named;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Compares every stage and view on every device with {@code sequential}'s: few spheres, a hierarchy, and meshes. */
class ViewsOnDeviceTest {
    private static final int FEW = 5;
    private static final int MANY = 60;

    static Stream<Object[]> picturesOnDevices() {
        return Devices.namedOffers().stream()
                .flatMap(offer -> Stream.of(StageOrView.values()).map(picture -> new Object[] {picture, offer}));
    }

    @ParameterizedTest(name = "{0} on {1}")
    @MethodSource("picturesOnDevices")
    void isSequentials(StageOrView picture, EngineOffer offer) {
        for (int spheres : new int[] {FEW, MANY}) {
            World world = SceneSamples.world(11, spheres);
            world.setSettings(small(Rendering.DEFAULT));
            try (Engine engine = offer.opener().get()) {
                Pictures.requireSequentialsRadiance(engine, world.snapshot().showing(picture));
            }
        }
    }

    static Stream<Named<EngineOffer>> devices() {
        return Devices.namedOffers().stream();
    }

    @ParameterizedTest(name = "{0}")
    @MethodSource("devices")
    void guidesAndLightLayersAreSequentials(EngineOffer offer) {
        for (String name : new String[] {"cornell", "glass", "benchmark", "lamps"}) {
            Scene scene = SceneReader.read(Path.of("scenes", name + ".json"));
            SceneMeshes meshes = SceneMeshes.read(scene, _ -> {});
            World world = World.of(scene, SceneImages.read(scene, meshes, _ -> {}), meshes);
            world.setSettings(scene.rendering()
                    .withSize(80, 45)
                    .withShadowSamples(4)
                    .withBounces(3)
                    .withSamplesPerPixel(2));
            try (Engine engine = offer.opener().get()) {
                Pictures.requireSequentialsRadiance(engine, world.snapshot().withGuides());
                Pictures.requireSequentialsRadiance(engine, world.snapshot().withLightLayers(world.lightGroups()));
            }
        }
    }

    /** Of masked and blended meshes, by both integrators. */
    @ParameterizedTest(name = "{0}")
    @MethodSource("devices")
    void alphaIsSequentials(EngineOffer offer) {
        Scene scene = SceneReader.read(Path.of("scenes/maps.json"));
        SceneMeshes meshes = SceneMeshes.read(scene, _ -> {});
        World world = World.of(scene, SceneImages.read(scene, meshes, _ -> {}), meshes);
        for (Integrator integrator : Integrator.values()) {
            world.setSettings(small(scene.rendering()).withIntegrator(integrator));
            try (Engine engine = offer.opener().get()) {
                Pictures.requireSequentialsRadiance(engine, world.snapshot().withoutBackground());
            }
        }
    }

    @ParameterizedTest(name = "{0}")
    @MethodSource("devices")
    void finishesAreSequentials(EngineOffer offer) {
        Scene scene = SceneReader.read(Path.of("docs/finishes.json"));
        SceneMeshes meshes = SceneMeshes.read(scene, _ -> {});
        World world = World.of(scene, SceneImages.read(scene, meshes, _ -> {}), meshes);
        world.setSettings(small(scene.rendering()));
        try (Engine engine = offer.opener().get()) {
            Pictures.requireSequentialsRadiance(engine, world.snapshot());
        }
    }

    static Stream<Object[]> projectionsOnDevices() {
        return Devices.namedOffers().stream()
                .flatMap(offer ->
                        Stream.of(Camera.Projection.values()).map(projection -> new Object[] {projection, offer}));
    }

    @ParameterizedTest(name = "{0} on {1}")
    @MethodSource("projectionsOnDevices")
    void projectionIsSequentials(Camera.Projection projection, EngineOffer offer) {
        World world = SceneSamples.world(11, FEW);
        world.setCamera(world.scene().camera().withProjection(projection).withAperture(0.1));
        world.setSettings(small(Rendering.DEFAULT));
        try (Engine engine = offer.opener().get()) {
            Pictures.requireSequentialsRadiance(engine, world.snapshot());
        }
    }

    static Stream<Object[]> picturesOfMeshesOnDevices() {
        return Devices.namedOffers().stream()
                .flatMap(offer ->
                        Stream.of(StageOrView.SHADOW, StageOrView.TESTS).map(picture -> new Object[] {picture, offer}));
    }

    @ParameterizedTest(name = "{0} of meshes on {1}")
    @MethodSource("picturesOfMeshesOnDevices")
    void ofMeshesIsSequentials(StageOrView picture, EngineOffer offer) {
        Scene scene = SceneReader.read(Path.of("scenes/gallery.json"));
        SceneMeshes meshes = SceneMeshes.read(scene, _ -> {});
        World world = World.of(scene, SceneImages.read(scene, meshes, _ -> {}), meshes);
        world.setSettings(small(scene.rendering()));
        try (Engine engine = offer.opener().get()) {
            Pictures.requireSequentialsRadiance(engine, world.snapshot().showing(picture));
        }
    }

    private static Rendering small(Rendering settings) {
        return settings.withSize(80, 45).withShadowSamples(9).withBounces(2).withSamplesPerPixel(2);
    }
}
