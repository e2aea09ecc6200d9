package dev.twister.engine.vector;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.engine.Engine;
import dev.twister.engine.JvmEngines;
import dev.twister.image.Frame;
import dev.twister.mesh.MeshFile;
import dev.twister.mesh.TriangleMesh;
import dev.twister.oracle.LitScene;
import dev.twister.oracle.MeshShapes;
import dev.twister.oracle.PictureDifference;
import dev.twister.oracle.Pictures;
import dev.twister.oracle.RandomMeshes;
import dev.twister.scene.Camera;
import dev.twister.scene.Geometry;
import dev.twister.scene.Ground;
import dev.twister.scene.Integrator;
import dev.twister.scene.Light;
import dev.twister.scene.Material;
import dev.twister.scene.Mesh;
import dev.twister.scene.Rendering;
import dev.twister.scene.Rgb;
import dev.twister.scene.Rotation;
import dev.twister.scene.Scene;
import dev.twister.scene.Vector3;
import dev.twister.scene.format.SceneReader;
import dev.twister.scene.light.Lights;
import dev.twister.sky.Skybox;
import dev.twister.world.FrameInput;
import dev.twister.world.SceneImages;
import dev.twister.world.SceneMeshes;
import dev.twister.world.World;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Scenes with meshes must render in lanes as in the scalar kernel. */
class MeshesInLanesTest {
    private static final int SCENES = 40;
    private static final Rgb WHITE = new Rgb(1, 1, 1);
    private static final Skybox SKY =
            new Skybox(2, 2, new float[] {0.2f, 0.4f, 0.9f, 0.9f, 0.5f, 0.2f, 0.3f, 0.3f, 0.3f, 0.1f, 0.2f, 0.1f});
    private static final int ALWAYS_WALK = 0;
    private static final int NEVER_WALK = Integer.MAX_VALUE;

    static Stream<Object[]> widthsAndWays() {
        return WidthLoader.WIDTHS.stream()
                .flatMap(bits -> Stream.of(ALWAYS_WALK, NEVER_WALK).map(crowd -> new Object[] {bits, crowd}));
    }

    @ParameterizedTest(name = "{0} bits, crowds from {1} on")
    @MethodSource("widthsAndWays")
    void randomMeshesAreTheKernels(int bits, int crowd) {
        assertSame(WidthLoader.openForCrowds(bits, 2, crowd), SCENES);
    }

    @ParameterizedTest(name = "{0} bits, crowds from {1} on")
    @MethodSource("widthsAndWays")
    void declinedMeshesAreTheKernels(int bits, int crowd) {
        assertSame(WidthLoader.openDeclining(bits, 2, crowd, body -> body % 2 == 1), SCENES / 4);
    }

    @ParameterizedTest(name = "{0} bits, crowds from {1} on")
    @MethodSource("widthsAndWays")
    void tracedPathsAmongMeshesAreTheKernels(int bits, int crowd) {
        assertSame(WidthLoader.openForCrowds(bits, 2, crowd), SCENES / 2, Integrator.PATH);
    }

    private static void assertSame(Engine opened, int scenes) {
        assertSame(opened, scenes, Integrator.WHITTED);
    }

    private static void assertSame(Engine opened, int scenes, Integrator integrator) {
        int pixels = 0;
        int differing = 0;
        try (Engine engine = opened) {
            for (int seed = 0; seed < scenes; seed++) {
                LitScene scene = RandomMeshes.scene(new Random(seed), 3);
                World world = scene.world();
                world.setSettings(world.settings().withIntegrator(integrator));
                PictureDifference difference = difference(engine, world.snapshot());
                pixels += difference.pixels();
                differing += difference.differing().length;
            }
        }
        assertThat(differing).isLessThanOrEqualTo(pixels / PictureDifference.PIXELS_AN_ODD_ONE);
    }

    static Stream<Object[]> widthsAndShadowSamples() {
        return WidthLoader.WIDTHS.stream()
                .flatMap(bits -> Stream.of(1, 9).map(samples -> new Object[] {bits, samples}));
    }

    @ParameterizedTest(name = "{1} shadow samples at {0} bits")
    @MethodSource("widthsAndShadowSamples")
    void shippedMeshesAreTheKernels(int bits, int shadowSamples) {
        for (int crowd : new int[] {ALWAYS_WALK, NEVER_WALK}) {
            try (Engine engine = WidthLoader.openForCrowds(bits, 2, crowd)) {
                for (String name : List.of("knot", "gallery", "pour-on-mesh")) {
                    Scene scene = SceneReader.read(Path.of("scenes", name + ".json"));
                    SceneMeshes meshes = SceneMeshes.read(scene, _ -> {});
                    World world = World.of(scene, SceneImages.read(scene, meshes, _ -> {}), meshes);
                    world.setSettings(world.settings()
                            .withSize(151, 87)
                            .withShadowSamples(shadowSamples)
                            .withBounces(3));
                    assertThat(difference(engine, world.snapshot())).as(name).matches(PictureDifference::isWithinBound);
                }
            }
        }
    }

    /** Nothing goes to the scalar kernel: no sphere, glass or texture, and the plane casts no shadow. */
    @ParameterizedTest(name = "{0} bits, crowds from {1} on")
    @MethodSource("widthsAndWays")
    void opaqueMeshesAloneAreTheKernels(int bits, int crowd) {
        int pixels = 0;
        int differing = 0;
        try (Engine engine = WidthLoader.openForCrowds(bits, 2, crowd)) {
            for (int seed = 0; seed < SCENES / 2; seed++) {
                PictureDifference difference =
                        difference(engine, opaque(new Random(seed)).world().snapshot());
                pixels += difference.pixels();
                differing += difference.differing().length;
            }
        }
        assertThat(differing).isLessThanOrEqualTo(pixels / PictureDifference.PIXELS_AN_ODD_ONE);
    }

    /** Two faces in one plane, cut into triangles along different diagonals, above a plane that mirrors them. */
    @ParameterizedTest(name = "{0} bits, crowds from {1} on")
    @MethodSource("widthsAndWays")
    void facesInOnePlaneAreTheKernels(int bits, int crowd) {
        Mesh face = Mesh.of(Path.of("face"))
                .withPosition(new Vector3(0, 1.5, 0))
                .withRotation(new Rotation(20, 35, 10))
                .withMaterial(Material.DEFAULT.withColor(new Rgb(1, 0, 0)));
        Mesh same = face.withGeometry(new Geometry.OfFile(Path.of("same")))
                .withMaterial(Material.DEFAULT.withColor(new Rgb(0, 0, 1)));
        Scene scene = opaque(new Random(1))
                .scene()
                .withGround(Ground.of(30, 0, WHITE, WHITE, 40))
                .withMeshes(List.of(face, same))
                .withRendering(
                        Rendering.DEFAULT.withSize(151, 87).withShadowSamples(1).withBounces(2));
        TriangleMesh square = MeshShapes.square();
        TriangleMesh other =
                new TriangleMesh(square.positions(), new float[0], new float[0], new int[] {0, 2, 3, 0, 3, 1});
        SceneMeshes meshes = SceneMeshes.of(
                scene, source -> MeshShapes.file(source.geometry().equals(face.geometry()) ? square : other));
        FrameInput input =
                new LitScene(scene, SceneImages.of(SKY), meshes).world().snapshot();
        try (Engine engine = WidthLoader.openForCrowds(bits, 2, crowd)) {
            assertThat(difference(engine, input)).matches(PictureDifference::isWithinBound);
        }
    }

    private static LitScene opaque(Random random) {
        List<Mesh> placed = new ArrayList<>();
        for (int i = 0; i <= random.nextInt(4); i++) {
            placed.add(Mesh.of(Path.of("shape.obj"))
                    .withPosition(
                            new Vector3(4 * random.nextDouble() - 2, 1 + random.nextDouble(), random.nextDouble()))
                    .withScale(0.3 + random.nextDouble())
                    .withMaterial(Material.DEFAULT
                            .withColor(new Rgb(random.nextDouble(), 0.6, 0.4))
                            .withReflectivity(128 * random.nextDouble())
                            .withMetallic(random.nextBoolean() ? 0 : random.nextDouble())));
        }
        Scene scene = Scene.under(Path.of("none.hdr"))
                .withCamera(Camera.of(new Vector3(0.3, 2.2, -6), 3, 10, 45))
                .withLights(
                        Lights.of(Light.of(new Vector3(-3, 7, -4 * random.nextDouble()), random.nextDouble(), WHITE)))
                .withGround(Ground.of(30, 0, WHITE, new Rgb(0.3, 0.3, 0.3), 30 * random.nextDouble()))
                .withMeshes(placed)
                .withRendering(Rendering.DEFAULT
                        .withSize(87, 53)
                        .withShadowSamples(1 + 8 * random.nextInt(3))
                        .withBounces(random.nextInt(4)));
        MeshFile file = MeshShapes.file(MeshShapes.blob(random, 1 + random.nextInt(3)));
        return new LitScene(scene, SceneImages.of(SKY), SceneMeshes.of(scene, _ -> file));
    }

    private static PictureDifference difference(Engine engine, FrameInput input) {
        Frame frame = Frame.ofPixels(input.width(), input.height());
        engine.render(input, frame);
        return PictureDifference.between(frame.argb(), Pictures.argb(JvmEngines.SEQUENTIAL, input));
    }
}
