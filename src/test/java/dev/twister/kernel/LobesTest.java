package dev.twister.kernel;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import dev.twister.scene.Material;
import dev.twister.world.table.LookTable;
import java.util.HashMap;
import java.util.Map;
import java.util.Random;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;

/** Lobes of path tracing: chosen directions follow the density, and no lobe adds energy. */
class LobesTest {
    private static final int BODY = Layout.FIRST_SPHERE;
    private static final int TRIES = 100_000;

    /** Numbers of later bounces are hashed, so that they need no table of samples. */
    private static final int BOUNCE = 10;

    private final float[] frame = new float[Layout.DISC];
    private float[] looks = {};
    private final float[] path = new float[Layout.TRACED_PATH_LENGTH];

    /**
     * A surface: reflectivity, roughness, transmission, index, metallic as in {@code looks}, side, cosine of the ray.
     */
    record Surfaces(
            float reflectivity,
            float roughness,
            float transmission,
            float ior,
            float metallic,
            float inside,
            float cosine) {}

    static Stream<Arguments> surfaces() {
        return Stream.of(
                        new Surfaces(0, 0, 0, 0, 0, 0, 0.7f),
                        new Surfaces(128, 0.5f, 0, 0, 1, 0, 0.9f),
                        new Surfaces(128, 0.8f, 0, 0, 0.5f, 0, 0.2f),
                        new Surfaces(64, 0.4f, 0, 0, 0, 0, 0.6f),
                        new Surfaces(32, 0.6f, 0.5f, 1.5f, 0, 0, 0.5f),
                        new Surfaces(0, 0.5f, 1, 1.5f, 0, 0, 0.8f),
                        new Surfaces(0, 0.5f, 1, 1.5f, 0, 1, 0.8f),
                        new Surfaces(0, 0.7f, 1, 2.4f, 0, 1, 0.4f),
                        new Surfaces(0, 0.5f, 0, 1.5f, -1, 0, 0.6f),
                        new Surfaces(0, 0.5f, 0, 1.5f, -2, 0, 0.3f),
                        new Surfaces(0, 0.5f, 0.7f, 1.5f, -1.25f, 0, 0.6f),
                        new Surfaces(0, 1, 1, 4, -1, 1, 0.9f))
                .map(Arguments::of);
    }

    private final Map<Material, float[]> looksOfMaterials = new HashMap<>();

    /** Looks with the tables of an index of refraction and a roughness. */
    private float[] looks(float ior, float roughness) {
        Material white = Material.DEFAULT.withMetallic(0.5).withRoughness(roughness);
        return looksOfMaterials.computeIfAbsent(
                white.withIor(Math.max(1, ior)), material -> LobeSums.looks(new LookTable(), material));
    }

    @ParameterizedTest
    @MethodSource("surfaces")
    void chosenDirectionsFollowTheDensity(Surfaces surface) {
        start(surface, 0.8f);
        LobeSums sums = LobeSums.of(path, looks, Variant.MATERIALS, TRIES, new Random(20261126));
        double chosen = 0;
        double[] weight = new double[3];
        for (int i = 0; i < TRIES; i++) {
            choose(surface, 0.8f, i);
            chosen += path[Layout.SURFACE_DENSITY] > 0 ? 1 : 0;
            for (int channel = 0; channel < 3; channel++) {
                weight[channel] += path[Layout.THROUGHPUT + channel];
            }
        }
        assertThat(chosen / TRIES).isCloseTo(sums.density(), within(0.05));
        for (int channel = 0; channel < 3; channel++) {
            assertThat(weight[channel] / TRIES).isCloseTo(sums.scattered().get(channel), within(0.04));
        }
    }

    @ParameterizedTest
    @MethodSource("surfaces")
    void noSurfaceAddsEnergy(Surfaces surface) {
        double weight = 0;
        for (int i = 0; i < TRIES / 4; i++) {
            choose(surface, 1, i);
            weight += path[Layout.THROUGHPUT];
        }
        assertThat(weight / (TRIES / 4)).isLessThan(1.005);
    }

    @Test
    void smoothWhiteGlassKeepsAllLight() {
        Surfaces glass = new Surfaces(0, 0, 1, 1.5f, 0, 0, 0.5f);
        for (int i = 0; i < 1000; i++) {
            choose(glass, 1, i);
            assertThat(path[Layout.THROUGHPUT]).isCloseTo(1, within(1e-5f));
        }
    }

    @Test
    void densityIsTheSameInBothDirections() {
        Surfaces coated = new Surfaces(0, 0.5f, 0, 1.5f, -1.5f, 0, 0.6f);
        start(coated, 0.8f);
        Lobes.evaluate(path, 0.48f, 0.64f, 0.6f, looks, Variant.MATERIALS);
        float there = path[Layout.SCATTERED] / 0.6f;
        start(new Surfaces(0, 0.5f, 0, 1.5f, -1.5f, 0, 0.6f), 0.8f);
        path[Layout.DIRECTION] = -0.48f;
        path[Layout.DIRECTION + 1] = -0.64f;
        path[Layout.DIRECTION + 2] = -0.6f;
        Lobes.prepare(path, BODY, BOUNCE, frame, looks, Variant.MATERIALS);
        Lobes.evaluate(path, -0.8f, 0, 0.6f, looks, Variant.MATERIALS);
        assertThat(path[Layout.SCATTERED] / 0.6f).isCloseTo(there, within(1e-4f * there));
    }

    /** By Fresnel's equations white is white: of every roughness and mixture, from outside and from inside. */
    @ParameterizedTest
    @CsvSource({"1.1, 0.05", "1.1, 0.4", "1.1, 1", "1.5, 0.2", "1.5, 0.6", "1.5, 1", "2.4, 0.3", "2.4, 0.85"})
    void whiteStaysWhite(float ior, float roughness) {
        for (float metallic : new float[] {0, 0.5f, 1}) {
            for (float transmission : new float[] {0, 0.5f, 1}) {
                for (float cosine : new float[] {0.15f, 0.5f, 1}) {
                    for (int inside = 0; inside <= (transmission > 0 ? 1 : 0); inside++) {
                        requireWhite(new Surfaces(0, roughness, transmission, ior, -1 - metallic, inside, cosine));
                    }
                }
            }
        }
    }

    private void requireWhite(Surfaces surface) {
        int count = 8000;
        double sum = 0;
        double squares = 0;
        for (int i = 0; i < count; i++) {
            choose(surface, 1, i);
            double weight = path[Layout.THROUGHPUT];
            sum += weight;
            squares += weight * weight;
        }
        double mean = sum / count;
        double error = Math.sqrt(Math.max(0, squares / count - mean * mean) / count);
        assertThat(mean).as(surface.toString()).isCloseTo(1, within(0.005 + 3 * error));
    }

    private void choose(Surfaces surface, float albedo, int number) {
        start(surface, albedo);
        frame[Layout.FIRST_SAMPLE] = number;
        Lobes.choose(path, BOUNCE, frame, looks, Variant.MATERIALS);
    }

    /** A ray in the plane y = 0 that meets a surface with the normal (0, 0, 1). */
    private void start(Surfaces surface, float albedo) {
        looks = looks(surface.ior(), surface.roughness());
        path[Layout.METALLIC] = surface.metallic() < 0 ? -1 - surface.metallic() : surface.metallic();
        path[Layout.IS_FRESNEL] = surface.metallic() < 0 ? 1 : 0;
        path[Layout.PIXEL_SAMPLE] = frame[Layout.SAMPLES];
        path[Layout.NORMAL] = 0;
        path[Layout.NORMAL + 1] = 0;
        path[Layout.NORMAL + 2] = 1;
        path[Layout.DIRECTION] = (float) Math.sqrt(1 - surface.cosine() * surface.cosine());
        path[Layout.DIRECTION + 1] = 0;
        path[Layout.DIRECTION + 2] = -surface.cosine();
        path[Layout.REFLECTIVITY] = surface.reflectivity();
        path[Layout.ROUGHNESS] = surface.roughness();
        path[Layout.TRANSMISSION] = surface.transmission();
        path[Layout.IOR] = surface.ior();
        path[Layout.FROM_INSIDE] = surface.inside();
        for (int channel = 0; channel < 3; channel++) {
            path[Layout.ALBEDO + channel] = albedo < 1 ? albedo / (1 + channel * 0.5f) : albedo;
            path[Layout.THROUGHPUT + channel] = 1;
        }
        Lobes.prepare(path, BODY, BOUNCE, frame, looks, Variant.MATERIALS);
    }
}
