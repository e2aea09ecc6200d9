package dev.twister.engine.vector;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.engine.Engine;
import dev.twister.engine.EngineOffer;
import dev.twister.engine.Engines;
import dev.twister.engine.JvmEngines;
import dev.twister.image.Frame;
import dev.twister.oracle.MeshShapes;
import dev.twister.oracle.PictureDifference;
import dev.twister.oracle.RandomScenes;
import dev.twister.scene.Ground;
import dev.twister.scene.Scene;
import dev.twister.scene.format.WholeRangeScenes;
import dev.twister.sky.Skybox;
import dev.twister.world.FrameInput;
import dev.twister.world.SceneImages;
import dev.twister.world.SceneMeshes;
import dev.twister.world.World;
import java.time.LocalDate;
import java.time.ZoneOffset;
import java.time.temporal.IsoFields;
import java.util.Arrays;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.function.Supplier;
import jdk.incubator.vector.FloatVector;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledIfSystemProperty;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * Random scenes over the whole ranges of the scene file; {@code -Dtwister.ranges=6000} sets their number. The seed
 * changes each week and is printed; {@code -Dtwister.ranges.seed} repeats it.
 */
@EnabledIfSystemProperty(named = "twister.ranges", matches = "\\d+")
final class WholeRangesTest {
    private static final int SCENES = Integer.getInteger("twister.ranges", 0);
    private static final long SEED = Long.getLong("twister.ranges.seed", thisWeek());

    /** Divisor of the count where each scene is slow: on devices, which compile it anew, and with boxed vectors. */
    private static final int FEWER = 400;

    /**
     * Bound for devices, which render few scenes: in about one scene in a thousand, rounding decides hundreds of
     * pixels, as where the camera touches the surface of a planet.
     */
    private static final int DEVICE_PIXELS_AN_ODD_ONE = 200;

    /** One scene in this many has meshes, which are cubes. */
    private static final int SCENES_A_MESH = 16;

    /** One scene in this many may exceed the bound of a single picture. */
    private static final int SCENES_AN_ODD_ONE = 200;

    /** Why the pictures of a scene differ, found by leaving something out of the scene. */
    private enum Cause {
        ONE_PIXEL("one pixel of a picture of less than " + PictureDifference.PIXELS_AN_ODD_ONE),
        PATTERN("checks or a texture of 1 m on the plane, far below a pixel"),
        BRIGHTNESS("an exposure or a sky that makes rounding visible"),
        OTHER("rounding elsewhere");

        private final String text;

        Cause(String text) {
            this.text = text;
        }
    }

    /** A scene with its pictures in memory. */
    private record Setup(Scene scene, Skybox sky, Skybox texture) {
        static Setup of(int number) {
            Random random = new Random(SEED + ((long) number << 32));
            Scene scene = WholeRangeScenes.next(random);
            Skybox sky = RandomScenes.scene(random, 0).sky();
            boolean hasMeshes = number % SCENES_A_MESH == 0;
            return new Setup(hasMeshes ? scene : scene.withMeshes(List.of()), sky, randomTexture(random));
        }

        Setup with(Scene changed) {
            return new Setup(changed, sky, texture);
        }

        FrameInput input() {
            SceneMeshes meshes = SceneMeshes.of(scene, _ -> MeshShapes.file(MeshShapes.cube()));
            return World.of(scene, new SceneImages(sky, Map.of(WholeRangeScenes.PICTURE, texture)), meshes)
                    .snapshot();
        }
    }

    private static long thisWeek() {
        LocalDate today = LocalDate.now(ZoneOffset.UTC);
        return 100L * today.get(IsoFields.WEEK_BASED_YEAR) + today.get(IsoFields.WEEK_OF_WEEK_BASED_YEAR);
    }

    @ParameterizedTest
    @ValueSource(ints = {128, 256, 512})
    void vectorDrawsWhatSequentialDraws(int bits) {
        boolean wider = bits > FloatVector.SPECIES_PREFERRED.vectorBitSize();
        assertSame(
                () -> WidthLoader.open(bits, 2),
                wider ? SCENES / FEWER : SCENES,
                wider ? DEVICE_PIXELS_AN_ODD_ONE : PictureDifference.PIXELS_AN_ODD_ONE);
    }

    @Test
    void devicesDrawWhatSequentialDraws() {
        Engines.offers().stream()
                .filter(offer -> offer.id().startsWith("tornado:"))
                .filter(EngineOffer::works)
                .forEach(offer -> assertSame(offer.opener(), SCENES / FEWER, DEVICE_PIXELS_AN_ODD_ONE));
    }

    private static void assertSame(Supplier<? extends Engine> opener, int scenes, int pixelsAnOddOne) {
        long pixels = 0;
        long differing = 0;
        Map<Cause, Integer> exceeding = new EnumMap<>(Cause.class);
        try (Engine engine = opener.get();
                Engine sequential = Engines.open(JvmEngines.SEQUENTIAL)) {
            System.out.println(scenes + " scenes of seed " + SEED + " on " + engine.device());
            for (int number = 0; number < scenes; number++) {
                Setup setup = Setup.of(number);
                FrameInput input = setup.input();
                String which = "scene " + number + " of seed " + SEED;
                requireFinite(which, sequential, input);
                requireFinite(which, engine, input);
                PictureDifference difference = difference(engine, sequential, setup);
                pixels += difference.pixels();
                differing += difference.differing().length;
                if (!difference.isWithinBound()) {
                    Cause cause = cause(engine, sequential, setup, difference);
                    exceeding.merge(cause, 1, Integer::sum);
                    System.out.println(which + ": " + difference + "; " + cause.text);
                }
            }
        }
        int all = exceeding.values().stream().mapToInt(Integer::intValue).sum();
        exceeding.forEach((cause, count) -> System.out.println(count + " by " + cause.text));
        System.out.println(all + " of " + scenes + " scenes exceed the bound of a picture");
        assertThat(all).as("scenes that exceed the bound").isLessThanOrEqualTo(1 + scenes / SCENES_AN_ODD_ONE);
        assertThat(differing * pixelsAnOddOne)
                .as("%d of %d pixels differ, seed %d", differing, pixels, SEED)
                .isLessThanOrEqualTo(pixels);
    }

    private static PictureDifference difference(Engine engine, Engine sequential, Setup setup) {
        FrameInput input = setup.input();
        return PictureDifference.between(argb(engine, input), argb(sequential, input));
    }

    private static Cause cause(Engine engine, Engine sequential, Setup setup, PictureDifference difference) {
        if (difference.differing().length == 1) {
            return Cause.ONE_PIXEL;
        }
        Scene scene = setup.scene();
        Ground plane = scene.ground();
        Scene plain = scene.withGround(plane.withOddColor(plane.evenColor())
                .withMaterial(plane.material().withoutTexture()));
        Scene dim = scene.withRendering(scene.rendering().withExposure(0))
                .withSky(scene.sky().withStrength(1));
        if (difference(engine, sequential, setup.with(plain)).isWithinBound()) {
            return Cause.PATTERN;
        }
        return difference(engine, sequential, setup.with(dim)).isWithinBound() ? Cause.BRIGHTNESS : Cause.OTHER;
    }

    private static Skybox randomTexture(Random random) {
        int width = 1 + random.nextInt(9);
        int height = 1 + random.nextInt(9);
        float[] colors = new float[3 * width * height];
        for (int i = 0; i < colors.length; i++) {
            colors[i] = random.nextFloat();
        }
        return new Skybox(width, height, colors);
    }

    private static void requireFinite(String which, Engine engine, FrameInput input) {
        Frame frame = Frame.ofRadiance(input.width(), input.rows());
        Arrays.fill(frame.radiance(), Float.NaN);
        engine.render(input, frame);
        for (float channel : frame.radiance()) {
            if (!(channel >= 0 && channel <= Float.MAX_VALUE)) {
                throw new AssertionError(which + ": radiance " + channel + " on " + engine.id());
            }
        }
    }

    private static int[] argb(Engine engine, FrameInput input) {
        Frame frame = Frame.ofPixels(input.width(), input.rows());
        engine.render(input, frame);
        return frame.argb();
    }
}
