package dev.twister.engine.vector;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import dev.twister.engine.Engine;
import dev.twister.engine.Engines;
import dev.twister.image.Frame;
import dev.twister.oracle.Crowds;
import dev.twister.oracle.LitScene;
import dev.twister.oracle.PictureDifference;
import dev.twister.oracle.RandomScenes;
import dev.twister.scene.Camera;
import dev.twister.scene.Ground;
import dev.twister.scene.Light;
import dev.twister.scene.Rendering;
import dev.twister.scene.Rgb;
import dev.twister.scene.Scene;
import dev.twister.scene.Shading;
import dev.twister.scene.Sphere;
import dev.twister.scene.ToneMap;
import dev.twister.scene.Vector3;
import dev.twister.scene.format.SceneReader;
import dev.twister.scene.generate.SceneGenerator;
import dev.twister.scene.light.Lights;
import dev.twister.sky.Skybox;
import dev.twister.sky.SkyboxReader;
import dev.twister.world.FrameInput;
import dev.twister.world.World;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import java.util.function.Supplier;
import java.util.stream.Stream;
import jdk.incubator.vector.FloatVector;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.FieldSource;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Compares the engine with {@code sequential}, at every vector width. */
final class VectorEngineTest {

    /** Transparent, so no rendered pixel equals it and unwritten pixels show. */
    private static final int POISON = 0x00BADBAD;

    @ParameterizedTest
    @MethodSource("widthsAndScenes")
    void drawsTheShippedScenes(int bits, String scene) {
        World world = shipped(scene);
        world.setSettings(world.settings().withSize(403, 227));
        assertSame(bits, world.snapshot());
    }

    static Stream<Arguments> widthsAndScenes() {
        return WidthLoader.WIDTHS.stream().flatMap(bits -> scenes().map(scene -> Arguments.of(bits, scene)));
    }

    static Stream<String> scenes() {
        return Stream.of("benchmark", "teaching", "mirrors", "spheres-100", "spheres-10000");
    }

    @Tag("slow")
    @ParameterizedTest
    @MethodSource("scenes")
    void drawsWithoutFusedMultiplyAdd(String scene) {
        World world = shipped(scene);
        world.setSettings(world.settings().withSize(403, 227));
        try (Engine vector = WidthLoader.openWithoutFusing(2)) {
            assertSame(vector, world.snapshot());
        }
    }

    /**
     * Tiny spheres that mirror each other: a ray that differs from the kernel's in the last bit may hit another sphere,
     * which changed about one pixel in 700. Rays must therefore equal the kernel's bit for bit.
     */
    @Test
    void drawsWhatTinySpheresMirror() {
        Path sky = Path.of("skyboxes", "day.hdr");
        Scene scene = SceneGenerator.spheres(50_000, 7, sky);
        World world = World.of(scene, SkyboxReader.read(sky));
        world.setSettings(
                world.settings().withSize(480, 270).withShadowSamples(1).withBounces(3));
        try (Engine vector = WidthLoader.open(FloatVector.SPECIES_PREFERRED.vectorBitSize(), 2)) {
            assertSame(vector, world.snapshot());
        }
    }

    /** The bound applies to all pictures together: one alone may be too small to allow a single differing pixel. */
    @ParameterizedTest
    @FieldSource("dev.twister.engine.vector.WidthLoader#WIDTHS")
    void drawsRandomScenes(int bits) {
        Random random = new Random(20261121);
        try (Engine sequential = Engines.open("sequential");
                Engine vector = WidthLoader.open(bits, 2)) {
            assertSameTogether(vector, sequential, asMany(bits, 400), PictureDifference.PIXELS_AN_ODD_ONE, () -> {
                LitScene scene = RandomScenes.scene(random, random.nextInt(6));
                return World.of(scene.scene(), scene.sky()).snapshot();
            });
        }
    }

    /**
     * Traverses the hierarchy however few the spheres, with leaves of one to three; pixels equal the brute-force ones
     * bit for bit.
     */
    @ParameterizedTest
    @FieldSource("dev.twister.engine.vector.WidthLoader#WIDTHS")
    void hierarchyDrawsRandomScenesAsThePlainLoopDoes(int bits) {
        try (Engine plain = WidthLoader.openForCrowds(bits, 2, Integer.MAX_VALUE);
                Engine vector = WidthLoader.openForCrowds(bits, 2, 0)) {
            assertSameOnRandomScenes(plain, vector, asMany(bits, 300));
        }
    }

    /** Returns a lower count for vectors wider than the CPU's, as those are boxed. */
    private static int asMany(int bits, int usual) {
        return bits > FloatVector.SPECIES_PREFERRED.vectorBitSize() ? usual / 4 : usual;
    }

    /** Without fusing, the rounding of products moves the sides of boxes. */
    @Tag("slow")
    @Test
    void hierarchyDrawsRandomScenesWithoutFusingToo() {
        try (Engine plain = WidthLoader.openWithoutFusing(2, Integer.MAX_VALUE);
                Engine vector = WidthLoader.openWithoutFusing(2, 0)) {
            assertSameOnRandomScenes(plain, vector, 100);
        }
    }

    private static void assertSameOnRandomScenes(Engine plain, Engine vector, int scenes) {
        Random random = new Random(20261121);
        assertSameTogether(vector, plain, scenes, 20 * PictureDifference.PIXELS_AN_ODD_ONE, () -> {
            LitScene scene = RandomScenes.scene(random, random.nextInt(6));
            FrameInput whole = World.of(scene.scene(), scene.sky()).snapshot();
            return whole.withLeavesOf(1 + random.nextInt(3));
        });
    }

    private static void assertSameTogether(
            Engine actual, Engine expected, int pictures, int pixelsAnOddOne, Supplier<FrameInput> inputs) {
        int pixels = 0;
        int differing = 0;
        for (int count = 0; count < pictures; count++) {
            FrameInput input = inputs.get();
            PictureDifference difference = PictureDifference.between(pixels(actual, input), pixels(expected, input));
            pixels += difference.pixels();
            differing += difference.differing().length;
        }
        assertThat((long) differing * pixelsAnOddOne)
                .as("%d of %d pixels differ", differing, pixels)
                .isLessThanOrEqualTo(pixels);
    }

    /** Many more spheres than lanes, and shadows of packets that are computed point by point. */
    @ParameterizedTest
    @FieldSource("dev.twister.engine.vector.WidthLoader#WIDTHS")
    void hierarchyDrawsACrowdAsThePlainLoopDoes(int bits) {
        FrameInput input = Crowds.world(asMany(bits, 3000), 160, 90).snapshot();
        try (Engine plain = WidthLoader.openForCrowds(bits, 2, Integer.MAX_VALUE);
                Engine vector = WidthLoader.openForCrowds(bits, 2, 0)) {
            PictureDifference difference = PictureDifference.between(pixels(vector, input), pixels(plain, input));
            assertThat(difference.isWithinBound()).as(difference.toString()).isTrue();
        }
    }

    /** Squared distances are ten million times the squared radius, which cancels out of the difference in floats. */
    @ParameterizedTest
    @FieldSource("dev.twister.engine.vector.WidthLoader#WIDTHS")
    void drawsTheShadowsOfTinySpheresUnderAWideLight(int bits) {
        Skybox gray = new Skybox(1, 1, new float[] {0.5f, 0.5f, 0.5f});
        for (double radius : new double[] {3e-4, 1e-2}) {
            FrameInput input = World.of(underAWideLight(radius), gray).snapshot();
            for (int crowd : new int[] {0, Integer.MAX_VALUE}) {
                try (Engine vector = WidthLoader.openForCrowds(bits, 2, crowd)) {
                    assertSame(vector, input);
                }
            }
        }
    }

    /** Seen from straight above: separate spots of the light's samples under a sphere far off the light's axis. */
    private static Scene underAWideLight(double radius) {
        Rgb white = new Rgb(1, 1, 1);
        return Scene.under(Path.of("none.hdr"))
                .withCamera(Camera.of(new Vector3(5, 40 * radius, 3), 0, 90, 60))
                .withLights(Lights.of(Light.of(new Vector3(0, 30, 0), 10, white)))
                .withGround(Ground.of(60, 0, white, white, 0))
                .withSpheres(List.of(Sphere.of(new Vector3(9.280179716, 15.594533048, -3.854969045), radius, white, 0)))
                .withShading(new Shading(0.05))
                .withRendering(
                        Rendering.DEFAULT.withSize(96, 96).withShadowSamples(4).withBounces(0));
    }

    @ParameterizedTest
    @MethodSource("widthsAndSizes")
    void fillsPicturesOfAnySize(int bits, int width, int height) {
        World world = shipped("teaching");
        world.setSettings(world.settings().withSize(width, height).withShadowSamples(5));
        assertSame(bits, world.snapshot());
    }

    static Stream<Arguments> widthsAndSizes() {
        return WidthLoader.WIDTHS.stream()
                .flatMap(bits -> Stream.of(
                        Arguments.of(bits, 1, 1),
                        Arguments.of(bits, 1, 67),
                        Arguments.of(bits, 131, 1),
                        Arguments.of(bits, 17, 16),
                        Arguments.of(bits, 16, 33)));
    }

    /**
     * The shipped skies are Radiance pictures, whose values fit into half floats and share exponents. Values of 0.7 do
     * not fit, and blue channels far below the others do not share an exponent.
     */
    @ParameterizedTest
    @CsvSource({
        "128,0.7,1",
        "256,0.7,1",
        "512,0.7,1",
        "128,1,0.00006103515625",
        "256,1,0.00006103515625",
        "512,1,0.00006103515625",
    })
    void drawsASkyThatNeedsMoreBits(int bits, float all, float blue) {
        Scene scene = SceneReader.read(Path.of("scenes", "mirrors.json"));
        Skybox shipped = SkyboxReader.read(scene.sky().file());
        float[] radiance = shipped.radiance().clone();
        for (int i = 0; i < radiance.length; i++) {
            radiance[i] *= i % 3 == 2 ? all * blue : all;
        }
        World world = World.of(scene, new Skybox(shipped.width(), shipped.height(), radiance));
        world.setSettings(world.settings().withSize(203, 127).withBounces(2));
        assertSame(bits, world.snapshot());
    }

    /**
     * Pixels as small as those of a large picture: tiles of sky or ground alone, and a sky by polynomials. The bound
     * applies to all pictures together, as for random scenes.
     */
    @ParameterizedTest
    @FieldSource("dev.twister.engine.vector.WidthLoader#WIDTHS")
    void drawsNarrowViews(int bits) {
        Random random = new Random(20261123);
        try (Engine sequential = Engines.open("sequential");
                Engine vector = WidthLoader.open(bits, 2)) {
            assertSameTogether(
                    vector,
                    sequential,
                    asMany(bits, 160),
                    PictureDifference.PIXELS_AN_ODD_ONE,
                    () -> narrowView(
                            shipped(List.of("benchmark", "teaching", "mirrors").get(random.nextInt(3))), random));
        }
    }

    private static FrameInput narrowView(World world, Random random) {
        world.setCamera(world.camera()
                .withYawDegrees(360 * random.nextDouble())
                .withPitchDegrees(60 * random.nextDouble() - 30)
                .withFieldOfViewDegrees(2 + 16 * random.nextDouble()));
        world.setSettings(world.settings()
                .withSize(80 + random.nextInt(30), 60 + random.nextInt(30))
                .withShadowSamples(4)
                .withBounces(random.nextInt(4))
                .withSamplesPerPixel(1 + random.nextInt(2)));
        return world.snapshot();
    }

    @ParameterizedTest
    @FieldSource("dev.twister.engine.vector.WidthLoader#WIDTHS")
    void drawsBands(int bits) {
        World world = shipped("teaching");
        world.setSettings(world.settings().withSize(150, 90));
        assertSame(bits, world.snapshot().band(37, 22));
    }

    @ParameterizedTest
    @FieldSource("dev.twister.engine.vector.WidthLoader#WIDTHS")
    void drawsWithEveryToneMapAndSeveralSamples(int bits) {
        World world = shipped("mirrors");
        Rendering settings =
                world.settings().withSize(97, 61).withSamplesPerPixel(3).withBounces(3);
        for (ToneMap toneMap : ToneMap.values()) {
            for (boolean srgb : new boolean[] {false, true}) {
                world.setSettings(settings.withTone(0.7, toneMap, srgb));
                assertSame(bits, world.snapshot());
            }
        }
    }

    @ParameterizedTest
    @FieldSource("dev.twister.engine.vector.WidthLoader#WIDTHS")
    void keepsLinearRadiance(int bits) {
        World world = shipped("benchmark");
        world.setSettings(world.settings().withSize(131, 77).withSamplesPerPixel(2));
        FrameInput input = world.snapshot();
        float[] expected;
        float[] actual;
        try (Engine sequential = Engines.open("sequential");
                Engine vector = WidthLoader.open(bits, 2)) {
            expected = radiance(sequential, input);
            actual = radiance(vector, input);
        }
        int differing = 0;
        for (int i = 0; i < expected.length; i++) {
            assertThat(actual[i]).isNotNaN();
            differing += Math.abs(actual[i] - expected[i]) > 1e-3f * (1 + expected[i]) ? 1 : 0;
        }
        assertThat((double) differing / expected.length)
                .isCloseTo(0, within(1.0 / PictureDifference.PIXELS_AN_ODD_ONE));
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 2, 3, 7})
    void drawsTheSameOnAnyNumberOfThreads(int threads) {
        World world = shipped("teaching");
        world.setSettings(world.settings().withSize(200, 120));
        FrameInput input = world.snapshot();
        try (Engine one = VectorEngines.open(1);
                Engine several = VectorEngines.open(threads)) {
            assertThat(pixels(several, input)).isEqualTo(pixels(one, input));
        }
    }

    @Test
    void takesNewScenesBetweenFrames() {
        try (Engine vector = VectorEngines.open(2)) {
            for (String scene : List.of("spheres-100", "benchmark", "mirrors")) {
                World world = shipped(scene);
                world.setSettings(world.settings().withSize(120, 80).withBounces(2));
                FrameInput input = world.snapshot();
                try (Engine sequential = Engines.open("sequential")) {
                    assertThat(PictureDifference.between(pixels(vector, input), pixels(sequential, input))
                                    .isWithinBound())
                            .isTrue();
                }
            }
        }
    }

    private static void assertSame(int bits, FrameInput input) {
        try (Engine vector = WidthLoader.open(bits, 2)) {
            assertThat(vector.device()).endsWith(bits / 32 + " lanes");
            assertSame(vector, input);
        }
    }

    private static void assertSame(Engine vector, FrameInput input) {
        try (Engine sequential = Engines.open("sequential")) {
            PictureDifference difference = PictureDifference.between(pixels(vector, input), pixels(sequential, input));
            assertThat(difference.isWithinBound()).as(difference.toString()).isTrue();
        }
    }

    private static int[] pixels(Engine engine, FrameInput input) {
        Frame frame = Frame.ofPixels(input.width(), input.rows());
        Arrays.fill(frame.argb(), POISON);
        engine.render(input, frame);
        return frame.argb();
    }

    private static float[] radiance(Engine engine, FrameInput input) {
        Frame frame = Frame.ofRadiance(input.width(), input.rows());
        Arrays.fill(frame.radiance(), Float.NaN);
        engine.render(input, frame);
        return frame.radiance();
    }

    private static World shipped(String name) {
        Scene scene = SceneReader.read(Path.of("scenes", name + ".json"));
        return World.of(scene, SkyboxReader.read(scene.sky().file()));
    }
}
