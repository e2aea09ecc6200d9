package dev.twister.oracle;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.engine.JvmEngines;
import dev.twister.scene.Camera;
import dev.twister.scene.Rendering;
import dev.twister.scene.Scene;
import dev.twister.world.FrameInput;
import dev.twister.world.StageOrView;
import dev.twister.world.World;
import java.util.List;
import java.util.Random;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.MethodSource;

/** Compares linear frames of every stage and view that has an equation with the oracle. */
class StagesAndViewsTest {
    private static final double BOUND = 1 / 255.0;

    /** Small pictures have a higher share of edges, where body numbers jump by more than colors. */
    private static final int PIXELS_AN_ODD_ONE = 1000;

    /** Where mirrors reflect mirrors, each reflected edge changes a count, too. */
    private static final int PIXELS_AN_ODD_COUNT = 250;

    /** Plain bodies, and materials of all kinds. */
    private static final List<String> SCENES = List.of("benchmark", "glass");

    /** Mirrors of mirrors, a crowd, and a lens. */
    private static final List<String> MORE_SCENES = List.of("mirrors", "spheres-100", "bokeh");

    private static final List<StageOrView> WITHOUT_EQUATION = List.of(StageOrView.TESTS);

    static Stream<Object[]> picturesOfScenes() {
        return picturesOf(SCENES);
    }

    static Stream<Object[]> picturesOfMoreScenes() {
        return picturesOf(MORE_SCENES);
    }

    private static Stream<Object[]> picturesOf(List<String> scenes) {
        return scenes.stream()
                .filter(ShippedScenes.names()::contains)
                .flatMap(scene -> Stream.of(StageOrView.values())
                        .filter(picture -> !WITHOUT_EQUATION.contains(picture))
                        .map(picture -> new Object[] {scene, picture}));
    }

    @ParameterizedTest(name = "{1} of {0}")
    @MethodSource("picturesOfScenes")
    void isTheOracles(String name, StageOrView picture) {
        requireOracles(ShippedScenes.small(name), picture);
    }

    @Tag("slow")
    @ParameterizedTest(name = "{1} of {0}")
    @MethodSource("picturesOfMoreScenes")
    void ofMoreScenesIsTheOracles(String name, StageOrView picture) {
        requireOracles(ShippedScenes.small(name), picture);
    }

    @ParameterizedTest
    @EnumSource(
            value = StageOrView.class,
            names = {"DIFFUSE", "HIGHLIGHTS", "SOFT_SHADOWS", "ALBEDO", "NORMAL", "BODY", "SHADOW", "BOUNCES"})
    void ofSeveralLightsIsTheOracles(StageOrView picture) {
        requireOracles(RandomLights.added(ShippedScenes.small("benchmark"), new Random(20261126)), picture);
    }

    @ParameterizedTest
    @EnumSource(Camera.Projection.class)
    void projectionIsTheOracles(Camera.Projection projection) {
        LitScene shipped = ShippedScenes.small("bokeh");
        Camera camera = shipped.scene().camera().withProjection(projection);
        Scene seen = shipped.scene().withCamera(camera.withViewHeight(6));

        requireOracles(new LitScene(seen, shipped.images()), StageOrView.BEAUTY);
        requireOracles(new LitScene(seen, shipped.images()), StageOrView.NORMAL);
    }

    private static void requireOracles(LitScene shipped, StageOrView picture) {
        Rendering settings = shipped.scene().rendering();
        Scene scene = shipped.scene()
                .withRendering(settings.withSize(160, 90)
                        .withShadowSamples(Math.min(settings.shadowSamples(), 16))
                        .withSamplesPerPixel(2));
        FrameInput input =
                World.of(scene, shipped.images(), shipped.meshes()).snapshot().showing(picture);
        float[] actual = Pictures.radiance(JvmEngines.SEQUENTIAL, input);
        Oracle oracle = new Oracle(new LitScene(sceneOf(picture, scene), shipped.images()));
        int odd = 0;
        for (int pixel = 0; pixel < 160 * 90; pixel++) {
            Color expected = value(oracle, picture, pixel % 160, pixel / 160);
            odd += isClose(actual[3 * pixel], expected.red())
                            && isClose(actual[3 * pixel + 1], expected.green())
                            && isClose(actual[3 * pixel + 2], expected.blue())
                    ? 0
                    : 1;
        }
        int pixelsAnOddOne = picture == StageOrView.BOUNCES ? PIXELS_AN_ODD_COUNT : PIXELS_AN_ODD_ONE;
        assertThat(odd * pixelsAnOddOne).isLessThanOrEqualTo(160 * 90);
    }

    /** A stage equals the picture of a reduced scene. */
    private static Scene sceneOf(StageOrView picture, Scene scene) {
        Rendering settings = scene.rendering();
        return switch (picture) {
            case HARD_SHADOWS -> scene.withRendering(settings.withBounces(0).withShadowSamples(1));
            case SOFT_SHADOWS -> scene.withRendering(settings.withBounces(0));
            default -> scene;
        };
    }

    private static Color value(Oracle oracle, StageOrView picture, int column, int row) {
        return switch (picture) {
            case HARD_SHADOWS, SOFT_SHADOWS, BEAUTY -> Color.of(oracle.radiance(column, row));
            default -> oracle.value(column, row, picture);
        };
    }

    private static boolean isClose(float actual, double expected) {
        return Math.abs(actual - expected) <= BOUND * Math.max(1, Math.abs(expected));
    }
}
