package dev.twister.kernel;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import dev.twister.scene.Material;
import dev.twister.scene.Rgb;
import dev.twister.scene.material.Finish;
import dev.twister.world.table.LookTable;
import java.util.Arrays;
import java.util.Random;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;

/** Lobes of finishes: white stays white, chosen directions follow the density, and each lobe is reciprocal. */
class FinishTest {
    private static final int BODY = Layout.FIRST_SPHERE;
    private static final int VARIANT = Variant.MATERIALS | Variant.MAPS | Variant.PATH | Variant.FINISH;
    private static final int TRIES = 2000;

    /** Numbers of later bounces are hashed, so that they need no table of samples. */
    private static final int BOUNCE = 10;

    private static final Finish NONE = Finish.NONE;
    private static final Finish COATED = NONE.withClearcoat(NONE.clearcoat().withPart(1));
    private static final Finish CLOTH =
            NONE.withSheen(NONE.sheen().withColor(new Rgb(1, 1, 1)).withRoughness(0.6));
    private static final Finish BRUSHED = NONE.withAnisotropy(NONE.anisotropy().withStrength(0.7));
    private static final Finish FILM = NONE.withFilm(NONE.film().withPart(1));
    private static final Finish LEAF = NONE.withThrough(NONE.through().withPart(0.7));

    private final LookTable table = new LookTable();
    private final float[] frame = new float[Layout.DISC];
    private final float[] path = new float[Layout.FINISHED_PATH_LENGTH];
    private float[] looks = {};

    static Stream<Arguments> finishes() {
        return Stream.of(
                Arguments.of("smooth coat", COATED, 0.008),
                Arguments.of(
                        "rough coat", COATED.withClearcoat(COATED.clearcoat().withRoughness(0.4)), 0.008),
                Arguments.of(
                        "half a coat", COATED.withClearcoat(COATED.clearcoat().withPart(0.5)), 0.008),
                Arguments.of("sheen", CLOTH, 0.008),
                Arguments.of("smooth sheen", CLOTH.withSheen(CLOTH.sheen().withRoughness(0.3)), 0.008),
                Arguments.of("coated cloth", CLOTH.withClearcoat(COATED.clearcoat()), 0.008),
                Arguments.of("brushed", BRUSHED, 0.008),
                Arguments.of(
                        "most brushed",
                        BRUSHED.withAnisotropy(BRUSHED.anisotropy().withStrength(1)),
                        0.01),
                Arguments.of("film", FILM, 0.025),
                Arguments.of(
                        "black reflections", NONE.withSpecular(NONE.specular().withColor(new Rgb(0, 0, 0))), 0.008),
                Arguments.of(
                        "bright reflections", NONE.withSpecular(NONE.specular().withColor(new Rgb(4, 4, 4))), 0.008),
                Arguments.of("leaf", LEAF, 0.01));
    }

    @ParameterizedTest(name = "{0}")
    @MethodSource("finishes")
    void whiteStaysWhite(String name, Finish finish, double error) {
        for (double metallic : new double[] {0, 0.5, 1}) {
            for (double roughness : new double[] {0.2, 0.6, 1}) {
                look(Material.DEFAULT
                        .withMetallic(metallic)
                        .withRoughness(roughness)
                        .withFinish(finish));
                for (float cosine : new float[] {0.15f, 0.5f, 1}) {
                    requireWhite(name + " " + metallic + " " + roughness + " " + cosine, 0, cosine, error);
                }
            }
        }
    }

    @ParameterizedTest
    @CsvSource({"0, 0.5", "0.3, 0.5", "0.3, 0.9", "0.7, 0.2"})
    void dispersedLightIsNeitherLostNorAdded(double roughness, float cosine) {
        look(Material.DEFAULT.withTransmission(1).withRoughness(roughness).withFinish(NONE.withDispersion(5)));
        requireWhite("from outside", 0, cosine, 0.006);
    }

    private void requireWhite(String name, float inside, float cosine, double most) {
        double sum = 0;
        double squares = 0;
        for (int i = 0; i < TRIES; i++) {
            start(inside, cosine, 1);
            choose(i);
            double weight = (path[Layout.THROUGHPUT] + path[Layout.THROUGHPUT + 1] + path[Layout.THROUGHPUT + 2]) / 3;
            sum += weight;
            squares += weight * weight;
        }
        double mean = sum / TRIES;
        double error = Math.sqrt(Math.max(0, squares / TRIES - mean * mean) / TRIES);
        assertThat(mean).as(name).isCloseTo(1, within(most + 3 * error));
    }

    @ParameterizedTest(name = "{0}")
    @MethodSource("finishes")
    void chosenDirectionsFollowTheDensity(String name, Finish finish) {
        look(Material.DEFAULT.withMetallic(0.5).withRoughness(0.6).withFinish(finish));
        start(0, 0.6f, 0.7f);
        Lobes.prepare(path, BODY, BOUNCE, frame, looks, VARIANT);
        int tries = 30_000;
        LobeSums sums = LobeSums.of(path, looks, VARIANT, tries, new Random(20261128));
        double chosen = 0;
        double[] weight = new double[3];
        for (int i = 0; i < tries; i++) {
            start(0, 0.6f, 0.7f);
            choose(i);
            boolean spread = path[Layout.SURFACE_DENSITY] > 0;
            chosen += spread ? 1 : 0;
            for (int channel = 0; channel < 3; channel++) {
                weight[channel] += spread ? path[Layout.THROUGHPUT + channel] : 0;
            }
        }
        assertThat(chosen / tries).as("density").isCloseTo(sums.density(), within(0.03));
        for (int channel = 0; channel < 3; channel++) {
            assertThat(weight[channel] / tries).isCloseTo(sums.scattered().get(channel), within(0.02));
        }
    }

    /** Each lobe alone: what is below gets what is left in the direction of the ray's origin alone. */
    @Test
    void lobesAreReciprocal() {
        look(Material.DEFAULT
                .withRoughness(0.5)
                .withFinish(COATED.withClearcoat(COATED.clearcoat().withRoughness(0.5))));
        requireReciprocal("coat", 1, 0);
        look(Material.DEFAULT.withRoughness(0.5).withFinish(CLOTH));
        requireReciprocal("sheen", 0, 1);
        look(Material.DEFAULT.withRoughness(0.4).withMetallic(1).withFinish(BRUSHED));
        requireReciprocal("brushed metal", 0, 0);
        look(Material.DEFAULT.withRoughness(0.4).withMetallic(1).withFinish(FILM));
        requireReciprocal("film", 0, 0);
    }

    private void requireReciprocal(String name, float coat, float sheen) {
        float[] first = {0.48f, 0.36f, 0.8f};
        float[] second = {-0.64f, 0.6f, 0.48f};
        float there = only(first, second, coat, sheen) / second[2];
        float back = only(second, first, coat, sheen) / first[2];
        assertThat(there).as(name).isPositive().isCloseTo(back, within(1e-4f * back));
    }

    /** {@code f * |cos|} of one lobe; without coat and sheen, of the facets below. */
    private float only(float[] from, float[] to, float coat, float sheen) {
        start(0, 1, 0.7f);
        for (int axis = 0; axis < 3; axis++) {
            path[Layout.DIRECTION + axis] = -from[axis];
        }
        Lobes.prepare(path, BODY, BOUNCE, frame, looks, VARIANT);
        boolean below = coat + sheen == 0;
        path[Layout.PART_MIRROR] = below ? 1 : 0;
        path[Layout.PART_COAT] = 0;
        path[Layout.PART_MATTE] = 0;
        Arrays.fill(path, Layout.SCATTERED_AGAIN, Layout.SCATTERED_AGAIN + 3, 0);
        path[Layout.COVER_COAT] = coat;
        path[Layout.COVER_SHEEN] = sheen;
        path[Layout.SHEEN_ALBEDO] = sheen;
        Lobes.evaluate(path, to[0], to[1], to[2], looks, VARIANT);
        return path[Layout.SCATTERED + 1];
    }

    /** Facets of slopes with the deviations {@code alpha} across the grain and more along it. */
    @Test
    void brushedFacetsAreSpreadAlongTheGrain() {
        look(Material.DEFAULT.withRoughness(0.3).withMetallic(1).withFinish(BRUSHED));
        double alpha = 0.09;
        double along = alpha + (1 - alpha) * 0.49;
        start(0, 1, 1);
        Lobes.prepare(path, BODY, BOUNCE, frame, looks, VARIANT);
        for (double[] half : new double[][] {{0.3, 0, 1}, {0, 0.1, 1}, {0.2, 0.05, 1}}) {
            double length = Math.sqrt(half[0] * half[0] + half[1] * half[1] + 1);
            double cosine = 1 / length;
            double slopes = half[0] * half[0] / (along * along) + half[1] * half[1] / (alpha * alpha) + 1;
            double facets = 1 / (Math.PI * along * alpha * Math.pow(slopes * cosine * cosine, 2));
            double found = Grain.visibleDensity(
                    path,
                    (float) (half[0] / length),
                    (float) (half[1] / length),
                    (float) cosine,
                    (float) cosine,
                    1,
                    (float) alpha);
            assertThat(found).isCloseTo(facets, within(1e-4 * facets));
        }
    }

    @Test
    void aChannelIsRefractedByItsOwnIndex() {
        look(Material.DEFAULT.withTransmission(1).withRoughness(0).withFinish(NONE.withDispersion(4)));
        double[] sines = new double[3];
        double[] shares = new double[3];
        for (int i = 0; i < TRIES; i++) {
            start(0, 0.6f, 1);
            choose(i);
            for (int channel = 0; channel < 3; channel++) {
                if (path[Layout.THROUGHPUT + channel] > 0) {
                    shares[channel]++;
                    if (path[Layout.NEXT_DIRECTION + 2] < 0) {
                        sines[channel] = Math.hypot(path[Layout.NEXT_DIRECTION], path[Layout.NEXT_DIRECTION + 1]);
                    }
                }
            }
        }
        double half = 0.5 * 0.025 * 4;
        for (int channel = 0; channel < 3; channel++) {
            assertThat(0.8 / sines[channel]).isCloseTo(1.5 + half * (channel - 1), within(1e-5));
            assertThat(shares[channel] / TRIES).isCloseTo(1 / 3.0, within(0.02));
        }
    }

    @Test
    void aSmoothCoatMirrorsWhatTheFresnelEquationsSay() {
        look(Material.DEFAULT.withColor(new Rgb(0, 0, 0)).withRoughness(0.5).withFinish(COATED));
        double mirrored = 0;
        for (int i = 0; i < TRIES; i++) {
            start(0, 0.5f, 0);
            choose(i);
            if (path[Layout.SURFACE_DENSITY] == 0 && path[Layout.THROUGHPUT] > 0) {
                assertThat(path[Layout.NEXT_DIRECTION + 2]).isCloseTo(0.5f, within(1e-6f));
                mirrored += path[Layout.THROUGHPUT];
            }
        }
        assertThat(mirrored / TRIES).isCloseTo(Refraction.reflectance(0.5f, 1 / 1.5f), within(0.01));
    }

    /** Against the exact sum over all ways in the film, for each wavelength, seen by the CIE's observer. */
    @ParameterizedTest
    @CsvSource({"1.3, 120, 0.04", "1.3, 300, 0.04", "1.33, 400, 0.6", "1.8, 250, 0.04", "1.5, 500, 0.9"})
    void filmsHaveTheirColors(float ior, float thickness, float straight) {
        path[Layout.FINISH + Layout.FINISH_FILM_IOR] = ior;
        path[Layout.FINISH + Layout.FINISH_FILM_THICKNESS] = thickness;
        double[] exact = exact(ior, thickness, straight);
        for (int channel = 0; channel < 3; channel++) {
            float found = ThinFilm.reflectance(path, channel, 1, straight);
            assertThat(found)
                    .as("channel " + channel)
                    .isCloseTo((float) Math.clamp(exact[channel], 0, 1), within(0.05f));
        }
    }

    @Test
    void noFilmChangesNothing() {
        path[Layout.FINISH + Layout.FINISH_FILM_IOR] = 1.3f;
        path[Layout.FINISH + Layout.FINISH_FILM_THICKNESS] = 0;
        for (float cosine : new float[] {1, 0.5f, 0.1f}) {
            float schlick = 0.04f + 0.96f * (float) Math.pow(1 - cosine, 5);
            assertThat(ThinFilm.reflectance(path, 1, cosine, 0.04f)).isCloseTo(schlick, within(0.002f));
        }
    }

    private static double[] exact(double ior, double thickness, double straight) {
        double below = (1 + Math.sqrt(straight)) / (1 - Math.sqrt(straight));
        double outer = (1 - ior) / (1 + ior);
        double inner = (ior - below) / (ior + below);
        double[] xyz = new double[3];
        double white = 0;
        for (double length = 380; length <= 780; length += 2) {
            double phase = 4 * Math.PI * ior * thickness / length;
            double crossed = 2 * outer * inner * Math.cos(phase);
            double reflected =
                    (outer * outer + inner * inner + crossed) / (1 + outer * outer * inner * inner + crossed);
            double x = 1.056 * bell(length, 599.8, 37.9, 31)
                    + 0.362 * bell(length, 442, 16, 26.7)
                    - 0.065 * bell(length, 501.1, 20.4, 26.2);
            double y = 0.821 * bell(length, 568.8, 46.9, 40.5) + 0.286 * bell(length, 530.9, 16.3, 31.1);
            double z = 1.217 * bell(length, 437, 11.8, 36) + 0.681 * bell(length, 459, 26, 13.8);
            xyz[0] += reflected * x;
            xyz[1] += reflected * y;
            xyz[2] += reflected * z;
            white += y;
        }
        // What does not interfere is white, as Belcour and Barla have it.
        double mean = mean(outer, inner);
        double x = xyz[0] / white - mean;
        double y = xyz[1] / white - mean;
        double z = xyz[2] / white - mean;
        return new double[] {
            mean + 3.2404542 * x - 1.5371385 * y - 0.4985314 * z,
            mean - 0.9692660 * x + 1.8760108 * y + 0.0415560 * z,
            mean + 0.0556434 * x - 0.2040259 * y + 1.0572252 * z
        };
    }

    /** The reflectance of a film much thicker than any wavelength. */
    private static double mean(double outer, double inner) {
        double first = outer * outer;
        double second = inner * inner;
        return first + (1 - first) * (1 - first) * second / (1 - first * second);
    }

    /** A piece of the CIE's color matching functions (Wyman, Sloan and Shirley 2013). */
    private static double bell(double length, double place, double below, double above) {
        double t = (length - place) / (length < place ? below : above);
        return Math.exp(-t * t / 2);
    }

    private void look(Material material) {
        looks = LobeSums.looks(table, material);
    }

    private void choose(int number) {
        frame[Layout.FIRST_SAMPLE] = number;
        Lobes.prepare(path, BODY, BOUNCE, frame, looks, VARIANT);
        Lobes.choose(path, BOUNCE, frame, looks, VARIANT);
    }

    /** A ray that meets the body where its normal is (0, 0, 1), with the grain along x. */
    private void start(float inside, float cosine, float albedo) {
        Arrays.fill(path, 0);
        SurfaceLook.find(path, BODY, frame, looks, new float[0], VARIANT);
        int row = (int) looks[Layout.LOOK_STRIDE * BODY + Layout.LOOK_FINISH];
        System.arraycopy(looks, row, path, Layout.FINISH, Layout.FINISH_LENGTH);
        path[Layout.PIXEL_SAMPLE] = frame[Layout.SAMPLES];
        path[Layout.NORMAL + 2] = 1;
        path[Layout.COAT_NORMAL + 2] = 1;
        path[Layout.GRAIN] = 1;
        float level = (float) Math.sqrt(1 - cosine * cosine);
        path[Layout.DIRECTION] = 0.8f * level;
        path[Layout.DIRECTION + 1] = 0.6f * level;
        path[Layout.DIRECTION + 2] = -cosine;
        path[Layout.FROM_INSIDE] = inside;
        for (int channel = 0; channel < 3; channel++) {
            path[Layout.ALBEDO + channel] = albedo;
            path[Layout.THROUGHPUT + channel] = 1;
        }
    }
}
