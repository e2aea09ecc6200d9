package dev.twister.engine.tornado;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.engine.Engine;
import dev.twister.engine.EngineOffer;
import dev.twister.image.Frame;
import dev.twister.kernel.Layout;
import dev.twister.mesh.TriangleMesh;
import dev.twister.oracle.MeshShapes;
import dev.twister.scene.Camera;
import dev.twister.scene.Material;
import dev.twister.scene.Mesh;
import dev.twister.scene.Rendering;
import dev.twister.scene.Rgb;
import dev.twister.scene.Rotation;
import dev.twister.scene.Scene;
import dev.twister.scene.Sphere;
import dev.twister.scene.ToneMap;
import dev.twister.scene.Vector3;
import dev.twister.sky.Skybox;
import dev.twister.world.FrameInput;
import dev.twister.world.Positions;
import dev.twister.world.SceneImages;
import dev.twister.world.SceneMeshes;
import dev.twister.world.World;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Random;
import org.junit.jupiter.api.Named;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** State that the engine keeps between frames, and sizes that no work group divides. */
class TornadoEngineTest {
    /** Bytes by which the buffers of bodies and of looks are longer; more than the small arrays have. */
    private static final int ROOM = 4096;

    private final World world = SceneSamples.world(3, 6);

    private FrameInput input(int width, int height) {
        world.setSettings(Rendering.DEFAULT.withSize(width, height).withShadowSamples(16));
        return world.snapshot();
    }

    static List<Named<EngineOffer>> offers() {
        return Devices.namedOffers();
    }

    @ParameterizedTest(name = "on {0}")
    @MethodSource("offers")
    void oddSizesAreDrawnWhole(EngineOffer offer) {
        int[][] sizes = {{1, 1}, {17, 3}, {3, 17}, {1, 64}, {101, 57}, {257, 13}};
        try (Engine engine = offer.opener().get()) {
            for (int[] size : sizes) {
                Pictures.requireSequentials(engine, input(size[0], size[1]));
            }
        }
    }

    @ParameterizedTest(name = "on {0}")
    @MethodSource("offers")
    void linearFramesHoldTheRadiance(EngineOffer offer) {
        try (Engine engine = offer.opener().get()) {
            Pictures.requireSequentialsRadiance(engine, input(31, 19));
        }
    }

    @Test
    void bandsAreDrawnWithoutCompilingAgain() {
        try (TornadoEngine engine = Devices.openFirst()) {
            FrameInput whole = input(40, 30);
            Pictures.requireSequentials(engine, whole.band(0, 10));
            DevicePlan plan = engine.plan().orElseThrow();
            Pictures.requireSequentials(engine, whole.band(10, 10));
            Pictures.requireSequentials(engine, whole.band(20, 10));
            assertThat(engine.plan()).containsSame(plan);
        }
    }

    @Test
    void whatChangesFromFrameToFrameNeedsNoCompilation() {
        try (TornadoEngine engine = Devices.openFirst()) {
            Pictures.requireSequentials(engine, input(40, 30));
            DevicePlan plan = engine.plan().orElseThrow();
            world.setCamera(Camera.of(new Vector3(2, 1, -14), 10, 5, 70));
            Pictures.requireSequentials(engine, world.snapshot());
            Rendering settings = world.settings();
            world.setSettings(settings.withShadowSamples(Rendering.MAX_SHADOW_SAMPLES));
            Pictures.requireSequentials(engine, world.snapshot());
            world.setSettings(settings.withBounces(Rendering.MAX_BOUNCES));
            Pictures.requireSequentials(engine, world.snapshot());
            world.setSettings(
                    settings.withSamplesPerPixel(TornadoKernel.MOST_SAMPLES).withShadowSamples(1));
            Pictures.requireSequentials(engine, world.snapshot());
            world.setSettings(settings.withTone(1.5, ToneMap.REINHARD, true));
            Pictures.requireSequentials(engine, world.snapshot());
            assertThat(engine.plan()).containsSame(plan);
        }
    }

    @Test
    void moreSamplesThanTheBuffersHoldAreDrawnInPasses() {
        try (TornadoEngine engine = Devices.openFirst()) {
            input(17, 9);
            world.setSettings(
                    world.settings().withShadowSamples(1).withSamplesPerPixel(2 * TornadoKernel.MOST_SAMPLES + 6));
            FrameInput many = world.snapshot();
            Pictures.requireSequentials(engine, many);
            Pictures.requireSequentialsRadiance(engine, many);
        }
    }

    @Test
    void otherLooksOfAFewBodiesNeedNoCompilation() {
        try (TornadoEngine engine = Devices.openFirst()) {
            FrameInput input = input(40, 30);
            Pictures.requireSequentials(engine, input);
            DevicePlan plan = engine.plan().orElseThrow();
            World other = SceneSamples.world(4, 6);
            other.setSettings(world.settings());
            FrameInput looks = other.snapshot();
            Pictures.requireSequentials(engine, new FrameInput(input.view(), looks.bodies(), input.images()));
            assertThat(engine.plan()).containsSame(plan);
        }
    }

    @Test
    void theMostOfAFewSpheresFitTheirScratch() {
        for (int spheres = 0; spheres < 100; spheres++) {
            if (SceneSamples.world(5, spheres).snapshot().hasFewSpheres()) {
                assertThat(Layout.CANDIDATE_STRIDE * spheres).isLessThanOrEqualTo(TornadoKernel.FEW_SCRATCH);
            }
        }
    }

    @Test
    void spheresThatJoinAFewNeedNoCompilation() {
        World pour = SceneSamples.world(5, 40);
        pour.setSettings(Rendering.DEFAULT.withSize(40, 30));
        float[] positions = Positions.of(pour.snapshot());
        try (TornadoEngine engine = Devices.openFirst()) {
            pour.setBodyPositions(positions, 6);
            Pictures.requireSequentials(engine, pour.snapshot());
            DevicePlan plan = engine.plan().orElseThrow();
            pour.setBodyPositions(positions, 42);
            Pictures.requireSequentials(engine, pour.snapshot());
            assertThat(engine.plan()).containsSame(plan);
        }
    }

    @Test
    void linearAndOrdinaryFramesByTurnsNeedNoCompilation() {
        try (TornadoEngine engine = Devices.openFirst()) {
            FrameInput input = input(40, 30);
            Pictures.requireSequentials(engine, input);
            DevicePlan ordinary = engine.plan().orElseThrow();
            Pictures.requireSequentialsRadiance(engine, input);
            DevicePlan linear = engine.plan().orElseThrow();
            Pictures.requireSequentials(engine, input);
            assertThat(engine.plan()).containsSame(ordinary);
            Pictures.requireSequentialsRadiance(engine, input);
            assertThat(engine.plan()).containsSame(linear);
        }
    }

    @Test
    void otherSizesNeedNoCompilation() {
        try (TornadoEngine engine = Devices.openFirst()) {
            Pictures.requireSequentials(engine, input(40, 30));
            DevicePlan plan = engine.plan().orElseThrow();
            for (int[] size : new int[][] {{30, 40}, {127, 61}, {1, 1}, {40, 30}}) {
                Pictures.requireSequentials(engine, input(size[0], size[1]));
                assertThat(engine.plan()).containsSame(plan);
            }
        }
    }

    @Test
    void otherSizesOfLinearFramesNeedNoCompilation() {
        try (TornadoEngine engine = Devices.openFirst()) {
            Pictures.requireSequentialsRadiance(engine, input(40, 30));
            DevicePlan plan = engine.plan().orElseThrow();
            Pictures.requireSequentialsRadiance(engine, input(51, 47));
            assertThat(engine.plan()).containsSame(plan);
        }
    }

    @Test
    void picturesWithoutRoomInTheBuffersAreCompiledAnew() {
        try (TornadoEngine engine = Devices.openFirst()) {
            engine.render(input(1, 1), Frame.ofPixels(1, 1));
            DevicePlan plan = engine.plan().orElseThrow();
            FrameInput large = input(2048, 1025).withSamples(0, 1);
            Pictures.requireSequentials(engine, large);
            assertThat(engine.plan().orElseThrow()).isNotSameAs(plan);
        }
    }

    @Test
    void aFewMoreSpheresNeedNoCompilation() {
        try (TornadoEngine engine = Devices.openFirst()) {
            FrameInput input = input(40, 30);
            Pictures.requireSequentials(engine, input);
            DevicePlan plan = engine.plan().orElseThrow();
            for (int spheres : new int[] {7, 12, 0, 6}) {
                World other = SceneSamples.world(3, spheres);
                other.setSettings(world.settings());
                FrameInput more = other.snapshot();
                Pictures.requireSequentials(engine, new FrameInput(more.view(), more.bodies(), input.images()));
                assertThat(engine.plan()).containsSame(plan);
            }
        }
    }

    @Test
    void anotherSkyIsCopied() {
        try (TornadoEngine engine = Devices.openFirst()) {
            Pictures.requireSequentials(engine, input(30, 40));
            // Another world has its own sky.
            World other = SceneSamples.world(4, 6);
            other.setSettings(world.settings());
            Pictures.requireSequentials(engine, other.snapshot());
        }
    }

    @Test
    void movedMeshesNeedNoCompilation() {
        Scene scene = meshScene();
        SceneMeshes cube = meshes(scene, MeshShapes.cube());
        try (TornadoEngine engine = Devices.openFirst()) {
            Pictures.requireSequentials(engine, input(scene, cube));
            DevicePlan plan = engine.plan().orElseThrow();
            Mesh moved = scene.meshes()
                    .getFirst()
                    .withPosition(new Vector3(-1, 1, 1))
                    .withRotation(new Rotation(20, 10, 30))
                    .withScale(0.5);
            Pictures.requireSequentials(engine, input(scene.withMeshes(List.of(moved)), cube));
            assertThat(engine.plan()).containsSame(plan);
        }
    }

    /** Other meshes of the same size must be copied as well: only the array's identity differs. */
    @Test
    void otherMeshesAreCopiedAnew() {
        Scene scene = meshScene();
        try (TornadoEngine engine = Devices.openFirst()) {
            for (TriangleMesh shape : List.of(
                    MeshShapes.blob(new Random(1), 0), MeshShapes.blob(new Random(2), 0), MeshShapes.icosphere(2))) {
                Pictures.requireSequentials(engine, input(scene, meshes(scene, shape)));
            }
            SceneMeshes cube = meshes(scene, MeshShapes.cube());
            Pictures.requireSequentials(engine, input(scene.withMeshes(List.of()), SceneMeshes.NONE));
            Mesh mesh = scene.meshes().getFirst();
            Pictures.requireSequentials(
                    engine, input(scene.withMeshes(List.of(mesh, mesh.withPosition(new Vector3(2, 0, 1)))), cube));
        }
    }

    private Scene meshScene() {
        return Scene.under(Path.of("none"))
                .withCamera(Camera.of(new Vector3(0, 1, -6), 0, 8, 50))
                .withMeshes(List.of(Mesh.of(Path.of("shape")).withPosition(new Vector3(0.3, 0.5, 0))));
    }

    private static SceneMeshes meshes(Scene scene, TriangleMesh shape) {
        return SceneMeshes.of(scene, source -> MeshShapes.file(shape));
    }

    /** Inputs that share one sky. */
    private FrameInput input(Scene scene, SceneMeshes meshes) {
        World shown = World.of(scene, world.images(), meshes);
        shown.setSettings(
                Rendering.DEFAULT.withSize(40, 30).withShadowSamples(4).withBounces(2));
        FrameInput input = shown.snapshot();
        return new FrameInput(input.view(), input.bodies(), world.snapshot().images());
    }

    @Test
    void enginesOnOneDeviceDoNotDisturbEachOther() {
        FrameInput small = input(20, 10);
        FrameInput large = input(33, 21);
        try (Engine another = Devices.openFirst()) {
            try (Engine one = Devices.openFirst()) {
                Pictures.requireSequentials(one, small);
                Pictures.requireSequentials(another, large);
                Pictures.requireSequentials(one, small);
            }
            Pictures.requireSequentials(another, large);
        }
    }

    @Test
    void onlyWhatChangesIsCopiedAfterTheFirstFrame() {
        World vast = SceneSamples.world(3, 6, new Skybox(512, 256, new float[3 * 512 * 256]));
        vast.setSettings(Rendering.DEFAULT.withSize(320, 180));
        try (TornadoEngine engine = Devices.openFirst()) {
            Frame frame = Frame.ofPixels(320, 180);
            engine.render(vast.snapshot(), frame);
            engine.render(vast.snapshot(), frame);
            DevicePlan.Copied copied = engine.plan().orElseThrow().lastCopied();
            // The tables of samples and tiles and a few small arrays, which TornadoVM counts twice; neither the sky nor
            // the pixels.
            long tables = 4L
                    * (2 * Rendering.MAX_SHADOW_SAMPLES
                            + Layout.SAMPLE_STRIDE * TornadoKernel.MOST_SAMPLES
                            + Layout.MOST_TILES);
            assertThat(copied.bytesIn()).isBetween(1L, 2 * tables + 5 * ROOM);
            assertThat(copied.bytesOut()).isEqualTo(4L * 320 * 180);
            assertThat(frame.times().kernelNanos()).isPositive();
        }
    }

    @Test
    void movedCameraAndBodiesCopyNeitherMeshesNorImages() {
        Path file = Path.of("texture");
        Material textured = Material.DEFAULT.withTexture(file);
        Scene scene = meshScene()
                .withSpheres(List.of(Sphere.of(new Vector3(1, 1, 1), 0.5, new Rgb(1, 1, 1), 0)
                        .withMaterial(textured)));
        SceneImages images =
                new SceneImages(world.images().sky(), Map.of(file, new Skybox(256, 256, new float[3 * 256 * 256])));
        World shown = World.of(scene, images, meshes(scene, MeshShapes.icosphere(5)));
        shown.setSettings(Rendering.DEFAULT.withSize(40, 30));
        try (TornadoEngine engine = Devices.openFirst()) {
            Pictures.requireSequentials(engine, shown.snapshot());
            DevicePlan plan = engine.plan().orElseThrow();
            shown.setCamera(Camera.of(new Vector3(1, 1, -7), 5, 8, 50));
            Pictures.requireSequentials(engine, shown.snapshot());
            requireLittleCopied(plan, shown.snapshot());
            float[] positions = Positions.of(shown.snapshot());
            positions[3 * Layout.FIRST_SPHERE] += 0.5f;
            shown.setBodyPositions(positions, Layout.FIRST_SPHERE + 1);
            Pictures.requireSequentials(engine, shown.snapshot());
            requireLittleCopied(plan, shown.snapshot());
            assertThat(engine.plan()).containsSame(plan);
        }
    }

    /** At most the groups that change with the frame, which TornadoVM counts twice. */
    private static void requireLittleCopied(DevicePlan plan, FrameInput input) {
        long frame = Layout.DISC
                + 2L * Rendering.MAX_SHADOW_SAMPLES
                + Layout.SAMPLE_STRIDE * TornadoKernel.MOST_SAMPLES
                + Layout.MOST_TILES;
        long most = 2
                        * Float.BYTES
                        * (frame
                                + input.bodies().floats().length
                                + input.bodies().looks().length)
                + 5 * ROOM;
        assertThat(most).isLessThan((long) Float.BYTES * input.bodies().meshes().length);
        assertThat(most).isLessThan((long) Float.BYTES * input.images().length);
        assertThat(plan.lastCopied().bytesIn()).isBetween(1L, most);
    }

    /** Several engines in turn allocate more than the 4 GiB that TornadoVM allows one of them. */
    @Test
    void closingGivesTheDevicesMemoryBack() {
        World vast = SceneSamples.world(3, 1, new Skybox(8192, 2048, new float[3 * 8192 * 2048]));
        vast.setSettings(Rendering.DEFAULT.withSize(16, 9));
        FrameInput input = vast.snapshot();
        for (int round = 0; round < 24; round++) {
            TornadoEngine engine = Devices.openFirst();
            engine.render(input, Frame.ofPixels(16, 9));
            engine.close();
            engine.close();
        }
    }
}
