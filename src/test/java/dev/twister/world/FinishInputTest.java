package dev.twister.world;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.kernel.Layout;
import dev.twister.kernel.Variant;
import dev.twister.scene.Integrator;
import dev.twister.scene.Material;
import dev.twister.scene.Rgb;
import dev.twister.scene.Scene;
import dev.twister.scene.Sphere;
import dev.twister.scene.material.Finish;
import dev.twister.scene.material.ImageMap;
import dev.twister.scene.material.Reflectance;
import dev.twister.sky.Skybox;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;

/** Finishes of materials as the kernel reads them. */
class FinishInputTest {
    private static final Path FILE = Path.of("map.png");
    private static final Optional<ImageMap> MAP = Optional.of(ImageMap.of(FILE));
    private static final Finish FINISH = new Finish(
            new Finish.Clearcoat(0.01, 0.02, MAP, MAP, MAP.map(map -> map.withScale(0.5))),
            new Finish.Sheen(new Rgb(0.03, 0.04, 0.05), 0.06, MAP, MAP),
            new Finish.Anisotropy(0.07, 0.08, MAP),
            new Finish.Specular(new Rgb(0.09, 0.1, 0.11), MAP, MAP),
            new Finish.Film(0.12, 1.13, 14, 15, MAP, MAP),
            0.16,
            new Finish.Through(0.17, new Rgb(0.18, 0.19, 0.2), MAP, MAP));

    private static final Finish COATED =
            Finish.NONE.withClearcoat(Finish.NONE.clearcoat().withPart(1));

    @Test
    void aRowHasTheNumbersAndTheMaps() {
        float[] looks = input(Integrator.PATH, Material.DEFAULT.withFinish(FINISH))
                .bodies()
                .looks();
        int row = row(looks, 0);

        assertThat(row).isPositive();
        float[] expected = {
            0.01f,
            0.02f,
            0.03f,
            0.04f,
            0.05f,
            0.06f,
            0.07f,
            (float) Math.cos(0.08),
            (float) Math.sin(0.08),
            0.09f,
            0.1f,
            0.11f,
            0.12f,
            1.13f,
            15,
            0.16f,
            0.17f,
            0.18f,
            0.19f,
            0.2f,
            14
        };
        for (int number = 0; number < expected.length; number++) {
            assertThat(looks[row + number]).as("number " + number).isEqualTo(expected[number]);
        }
        assertThat(looks[row + Layout.FINISH_COAT_NORMAL_SCALE]).isEqualTo(0.5f);
        for (int map = Layout.FINISH_MAPS_COAT; map < Layout.FINISH_STRIDE; map += Layout.MAP_STRIDE) {
            assertThat(looks[row + map + Layout.MAP_WIDTH]).as("map " + map).isEqualTo(2);
            assertThat(looks[row + map + Layout.MAP_HEIGHT]).as("map " + map).isEqualTo(1);
        }
        int sheen = Layout.ALIGNMENT * (int) looks[row + Layout.FINISH_MAPS_SHEEN + Layout.MAP_START];
        int coat = Layout.ALIGNMENT * (int) looks[row + Layout.FINISH_MAPS_COAT + Layout.MAP_START];
        float[] images =
                input(Integrator.PATH, Material.DEFAULT.withFinish(FINISH)).images();
        assertThat(images[sheen]).isEqualTo(0.5f);
        // The number that an sRGB image stores for a linear half.
        assertThat(images[coat]).isBetween(0.735f, 0.736f);
    }

    @Test
    void bodiesWithTheSameFinishShareARow() {
        Material coated = Material.DEFAULT.withFinish(COATED);
        float[] looks = input(Integrator.PATH, coated, coated.withColor(new Rgb(1, 0, 0)), Material.DEFAULT)
                .bodies()
                .looks();

        assertThat(row(looks, 0)).isPositive().isEqualTo(row(looks, 1));
        assertThat(row(looks, 2)).isZero();
    }

    @Test
    void aSmoothMaterialWithAFinishGoesByFresnel() {
        Material coated = Material.DEFAULT.withFinish(COATED);
        assertThat(coated.isByFresnel()).isTrue();
        assertThat(coated.withReflectance(Reflectance.CONSTANT).isByFresnel()).isFalse();

        float[] looks = input(
                        Integrator.PATH,
                        coated,
                        coated.withReflectivity(5),
                        coated.withReflectance(Reflectance.CONSTANT),
                        coated.withUnlit(true))
                .bodies()
                .looks();
        assertThat(looks[Layout.LOOK_STRIDE * Layout.FIRST_SPHERE + Layout.LOOK_FRESNEL])
                .isEqualTo(1);
        assertThat(row(looks, 0)).isPositive();
        for (int sphere = 1; sphere < 4; sphere++) {
            assertThat(row(looks, sphere)).as("sphere " + sphere).isZero();
        }
    }

    @Test
    void numbersWithoutEffectAreNoFinish() {
        Finish rough = Finish.NONE
                .withClearcoat(Finish.NONE.clearcoat().withRoughness(1).withMap(MAP))
                .withFilm(Finish.NONE.film().withIor(2))
                .withAnisotropy(Finish.NONE.anisotropy().withRotation(1));
        assertThat(rough.isNone()).isTrue();
        assertThat(Material.DEFAULT.withFinish(rough).isByFresnel()).isFalse();
    }

    @Test
    void theKernelHasItInPathTracingAlone() {
        Material coated = Material.DEFAULT.withFinish(COATED);
        int finished = Variant.FINISH | Variant.MAPS;
        assertThat(input(Integrator.PATH, coated).variant(true) & finished).isEqualTo(finished);
        assertThat(input(Integrator.PATH, Material.DEFAULT).variant(true) & finished)
                .isZero();
        assertThat(input(Integrator.WHITTED, coated).variant(true) & finished).isZero();
    }

    @Test
    void whatLetsDiffuseLightThroughIsASheetUnlessItIsGlass() {
        Material leaf = Material.DEFAULT.withFinish(
                Finish.NONE.withThrough(Finish.NONE.through().withPart(0.5)));
        float[] looks = input(Integrator.PATH, leaf, leaf.withTransmission(0.5), leaf.withReflectivity(9))
                .bodies()
                .looks();
        int sheet = Layout.LOOK_STRIDE * Layout.FIRST_SPHERE + Layout.LOOK_SHEET;
        assertThat(looks[sheet]).isEqualTo(Layout.SHEET_OF_BODY);
        assertThat(looks[sheet + Layout.LOOK_STRIDE]).isZero();
        assertThat(looks[sheet + 2 * Layout.LOOK_STRIDE]).isZero();
    }

    private static int row(float[] looks, int sphere) {
        return (int) looks[Layout.LOOK_STRIDE * (Layout.FIRST_SPHERE + sphere) + Layout.LOOK_FINISH];
    }

    private static FrameInput input(Integrator integrator, Material... materials) {
        Scene plain = Worlds.scene();
        Sphere first = plain.spheres().getFirst();
        Scene scene = plain.withSpheres(
                        List.of(materials).stream().map(first::withMaterial).toList())
                .withRendering(plain.rendering().withIntegrator(integrator));
        Skybox image = new Skybox(2, 1, new float[] {0.5f, 0.5f, 0.5f, 0.25f, 0.5f, 1});
        return World.of(scene, new SceneImages(Worlds.SKY, Map.of(FILE, image))).snapshot();
    }
}
