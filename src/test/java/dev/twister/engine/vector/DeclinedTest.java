package dev.twister.engine.vector;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.engine.Engine;
import dev.twister.engine.Engines;
import dev.twister.engine.JvmEngines;
import dev.twister.engine.vector.frame.Drawing;
import dev.twister.image.Frame;
import dev.twister.kernel.Layout;
import dev.twister.oracle.LitScene;
import dev.twister.oracle.PictureDifference;
import dev.twister.oracle.RandomLights;
import dev.twister.oracle.RandomScenes;
import dev.twister.scene.Camera;
import dev.twister.scene.Integrator;
import dev.twister.scene.Rgb;
import dev.twister.scene.Scene;
import dev.twister.scene.Sphere;
import dev.twister.scene.Vector3;
import dev.twister.scene.format.SceneReader;
import dev.twister.scene.light.Lights;
import dev.twister.sky.SkyboxReader;
import dev.twister.world.FrameInput;
import dev.twister.world.SceneImages;
import dev.twister.world.SceneMeshes;
import dev.twister.world.View;
import dev.twister.world.World;
import java.nio.file.Path;
import java.util.List;
import java.util.Random;
import java.util.function.IntFunction;
import java.util.function.IntPredicate;
import java.util.function.Supplier;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.FieldSource;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

/** The scalar kernel renders what the lanes decline, so the picture stays the same. */
final class DeclinedTest {
    private static final int ALWAYS_WALK = 0;
    private static final int NEVER_WALK = Integer.MAX_VALUE;

    private record Kind(String name, IntPredicate bodies) {
        @Override
        public String toString() {
            return name;
        }
    }

    private static final List<Kind> KINDS = List.of(
            new Kind("the light", body -> body == Layout.LIGHT),
            new Kind("the plane", body -> body == Layout.PLANE),
            new Kind("one sphere", body -> body == Layout.FIRST_SPHERE + 1),
            new Kind("every other sphere", body -> body >= Layout.FIRST_SPHERE && body % 2 == 0),
            new Kind("all spheres", body -> body >= Layout.FIRST_SPHERE),
            new Kind("all bodies", _ -> true));

    static Stream<Object[]> widthsAndKinds() {
        return WidthLoader.WIDTHS.stream().flatMap(bits -> KINDS.stream().map(kind -> new Object[] {bits, kind}));
    }

    @ParameterizedTest(name = "{1} at {0} bits")
    @MethodSource("widthsAndKinds")
    void shippedScenesAreTheSame(int bits, Object kind) {
        for (int crowd : new int[] {ALWAYS_WALK, NEVER_WALK}) {
            try (Engine declining = WidthLoader.openDeclining(bits, 2, crowd, ((Kind) kind).bodies());
                    Engine sequential = Engines.open(JvmEngines.SEQUENTIAL)) {
                for (String scene : List.of("benchmark", "teaching", "mirrors", "spheres-100")) {
                    FrameInput input = shipped(scene);
                    PictureDifference difference =
                            PictureDifference.between(pixels(declining, input), pixels(sequential, input));
                    assertThat(difference).as(scene).matches(PictureDifference::isWithinBound);
                }
            }
        }
    }

    @ParameterizedTest(name = "{1} at {0} bits")
    @MethodSource("widthsAndKinds")
    void randomScenesAreTheSame(int bits, Object kind) {
        Random random = new Random(20261125);
        assertSame(
                crowd -> WidthLoader.openDeclining(bits, 2, crowd, ((Kind) kind).bodies()),
                () -> RandomScenes.scene(random, random.nextInt(4)));
    }

    /** Compares 20 scenes with the hierarchy and 20 without. */
    private static void assertSame(IntFunction<Engine> opener, Supplier<LitScene> scenes) {
        int pixels = 0;
        int different = 0;
        for (int crowd : new int[] {ALWAYS_WALK, NEVER_WALK}) {
            try (Engine vector = opener.apply(crowd);
                    Engine sequential = Engines.open(JvmEngines.SEQUENTIAL)) {
                for (int count = 0; count < 20; count++) {
                    LitScene scene = scenes.get();
                    FrameInput input = World.of(scene.scene(), scene.images(), scene.meshes())
                            .snapshot();
                    PictureDifference difference =
                            PictureDifference.between(pixels(vector, input), pixels(sequential, input));
                    pixels += difference.pixels();
                    different += difference.differing().length;
                }
            }
        }
        assertThat(different).isLessThanOrEqualTo(pixels / PictureDifference.PIXELS_AN_ODD_ONE);
    }

    /** A light below the plane lights no sphere above it; one that the plane cuts lights it partially. */
    @ParameterizedTest
    @CsvSource({"128, -3, 1", "256, -3, 1", "512, -3, 1", "512, 0.3, 1", "512, 4, 0.1"})
    void planeBetweenTheLightAndASphereBlocks(int bits, double lightHeight, double sphereHeight) {
        Scene scene = SceneReader.read(Path.of("scenes", "teaching.json"));
        Scene lit = scene.withGround(scene.ground().withHeight(0))
                .withLights(Lights.of(scene.lights()
                        .first()
                        .withPosition(new Vector3(0.5, lightHeight, -1))
                        .withRadius(0.4)))
                .withCamera(scene.camera().withPosition(new Vector3(0, 1.5, -8)))
                .withSpheres(List.of(
                        Sphere.of(new Vector3(0, sphereHeight, 0), 1, new Rgb(0.8, 0.7, 0.6), 20),
                        Sphere.of(new Vector3(2.5, sphereHeight, 1), 1, new Rgb(0.4, 0.7, 0.6), 90)))
                .withRendering(scene.rendering()
                        .withSize(151, 87)
                        .withShadowSamples(40)
                        .withBounces(2));
        FrameInput input = World.of(lit, SkyboxReader.read(lit.sky().file())).snapshot();
        for (int crowd : new int[] {ALWAYS_WALK, NEVER_WALK}) {
            try (Engine vector = WidthLoader.openForCrowds(bits, 2, crowd);
                    Engine sequential = Engines.open(JvmEngines.SEQUENTIAL)) {
                assertThat(PictureDifference.between(pixels(vector, input), pixels(sequential, input)))
                        .matches(PictureDifference::isWithinBound);
            }
        }
    }

    @Test
    void toneMapThatLanesDoNotKnowDeclinesTheFrame() {
        FrameInput known = shipped("teaching");
        float[] frame = known.view().frame().clone();
        frame[Layout.TONE_MAP] = 99;
        FrameInput unknown =
                new FrameInput(new View(frame, known.view().stageOrView()), known.bodies(), known.images());
        Drawing drawing = new Drawing();
        drawing.take(known, Frame.ofPixels(known.width(), known.rows()), false);
        assertThat(drawing.declined.isFrame()).isFalse();
        drawing.take(unknown, Frame.ofPixels(known.width(), known.rows()), false);
        assertThat(drawing.declined.isFrame()).isTrue();
        try (Engine vector = VectorEngines.open(2);
                Engine sequential = Engines.open(JvmEngines.SEQUENTIAL)) {
            assertThat(pixels(vector, unknown)).isEqualTo(pixels(sequential, unknown));
        }
    }

    @ParameterizedTest
    @FieldSource("dev.twister.engine.vector.WidthLoader#WIDTHS")
    void severalLightsAreTheSame(int bits) {
        Random random = new Random(20261127);
        assertSame(
                crowd -> WidthLoader.openForCrowds(bits, 2, crowd),
                () -> RandomLights.added(RandomScenes.scene(random, random.nextInt(4)), random));
    }

    /** More lights than lanes, among all materials; some stand on the ground, which hides a part of them. */
    @ParameterizedTest
    @ValueSource(strings = {"bokeh", "gallery", "glass", "metals", "mirrors", "spheres-100", "lamps"})
    void shippedSceneWithManyLightsIsTheSame(String name) {
        Scene scene = SceneReader.read(Path.of("scenes", name + ".json"));
        Lights lamps = SceneReader.read(Path.of("scenes", "lamps.json")).lights();
        SceneMeshes meshes = SceneMeshes.read(scene, _ -> {});
        Scene lit = scene.withLights(lamps)
                .withRendering(scene.rendering()
                        .withSize(131, 77)
                        .withIntegrator(Integrator.WHITTED)
                        .withSamplesPerPixel(1)
                        .withShadowSamples(9)
                        .withBounces(2));
        FrameInput input =
                World.of(lit, SceneImages.read(lit, meshes, _ -> {}), meshes).snapshot();
        Drawing drawing = new Drawing();
        drawing.take(input, Frame.ofPixels(input.width(), input.rows()), false);
        assertThat(drawing.declined.isFrame()).isFalse();
        try (Engine vector = VectorEngines.open(2);
                Engine parallel = Engines.open(JvmEngines.PARALLEL)) {
            assertThat(PictureDifference.between(pixels(vector, input), pixels(parallel, input)))
                    .matches(PictureDifference::isWithinBound);
        }
    }

    /** Textured, glass and metallic meshes, glass and metallic spheres and the lens. */
    @ParameterizedTest
    @ValueSource(strings = {"bokeh", "gallery", "glass", "knot", "metals"})
    void shippedSceneIsDrawnWithoutTheKernel(String name) {
        Scene scene = SceneReader.read(Path.of("scenes", name + ".json"));
        SceneMeshes meshes = SceneMeshes.read(scene, _ -> {});
        FrameInput input = World.of(scene, SceneImages.read(scene, meshes, _ -> {}), meshes)
                .snapshot();
        Drawing drawing = new Drawing();
        drawing.take(input, Frame.ofPixels(input.width(), input.rows()), false);
        assertThat(drawing.declined.isFrame() || drawing.declined.isAnyBody()).isFalse();
    }

    /** Rounding alone would decide per pixel whether the sphere is in front of the camera or around it. */
    @ParameterizedTest
    @FieldSource("dev.twister.engine.vector.WidthLoader#WIDTHS")
    void sphereThatTheCameraIsOnIsTheSame(int bits) {
        Random random = new Random(20261125);
        Scene scene = SceneReader.read(Path.of("scenes", "teaching.json"));
        try (Engine fewSpheres = WidthLoader.openForCrowds(bits, 2, NEVER_WALK);
                Engine crowd = WidthLoader.openForCrowds(bits, 2, ALWAYS_WALK);
                Engine sequential = Engines.open(JvmEngines.SEQUENTIAL)) {
            for (int i = 0; i < 10; i++) {
                Vector3 camera = new Vector3(random.nextDouble(), 1 + random.nextDouble(), random.nextDouble() - 8);
                double x = random.nextDouble();
                double y = random.nextDouble();
                double radius = Math.sqrt(x * x + y * y + 1);
                Sphere sphere = Sphere.of(
                        new Vector3(camera.x() + x, camera.y() + y, camera.z() + 1), radius, new Rgb(1, 0, 0), 5);
                Scene seen = scene.withCamera(Camera.of(camera, 0, 0, 90))
                        .withSpheres(List.of(sphere))
                        .withRendering(scene.rendering().withSize(60, 40).withBounces(1));
                FrameInput input =
                        World.of(seen, SkyboxReader.read(seen.sky().file())).snapshot();
                int[] expected = pixels(sequential, input);
                assertThat(PictureDifference.between(pixels(fewSpheres, input), expected))
                        .matches(PictureDifference::isWithinBound);
                assertThat(PictureDifference.between(pixels(crowd, input), expected))
                        .matches(PictureDifference::isWithinBound);
            }
        }
    }

    private static FrameInput shipped(String name) {
        Scene scene = SceneReader.read(Path.of("scenes", name + ".json"));
        World world = World.of(scene, SkyboxReader.read(scene.sky().file()));
        world.setSettings(
                world.settings().withSize(151, 87).withShadowSamples(9).withBounces(2));
        return world.snapshot();
    }

    private static int[] pixels(Engine engine, FrameInput input) {
        Frame frame = Frame.ofPixels(input.width(), input.rows());
        engine.render(input, frame);
        return frame.argb();
    }
}
