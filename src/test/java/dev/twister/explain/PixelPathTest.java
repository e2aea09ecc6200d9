package dev.twister.explain;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;
import static org.assertj.core.api.Assertions.withinPercentage;

import dev.twister.engine.JvmEngines;
import dev.twister.explain.PathStep.FoundLight;
import dev.twister.explain.PathStep.LightPart;
import dev.twister.explain.PathStep.LightSample;
import dev.twister.explain.PathStep.RayKind;
import dev.twister.explain.PathStep.Scattering;
import dev.twister.explain.PathStep.Scattering.LobeChoice;
import dev.twister.explain.PathStep.Scattering.LobeProbabilities;
import dev.twister.explain.PathStep.ShadedSurface;
import dev.twister.kernel.Layout;
import dev.twister.oracle.LitScene;
import dev.twister.oracle.Pictures;
import dev.twister.oracle.RandomLights;
import dev.twister.oracle.RandomMaterials;
import dev.twister.oracle.RandomMeshes;
import dev.twister.oracle.ShippedScenes;
import dev.twister.scene.Camera;
import dev.twister.scene.Ground;
import dev.twister.scene.Integrator;
import dev.twister.scene.Light;
import dev.twister.scene.Rendering;
import dev.twister.scene.Rgb;
import dev.twister.scene.Scene;
import dev.twister.scene.Sphere;
import dev.twister.scene.Vector3;
import dev.twister.scene.format.SceneReader;
import dev.twister.scene.light.Lights;
import dev.twister.sky.Skybox;
import dev.twister.world.FrameInput;
import dev.twister.world.SceneImages;
import dev.twister.world.SceneMeshes;
import dev.twister.world.StageOrView;
import dev.twister.world.World;
import java.nio.file.Path;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Compares paths with the kernel's pictures bit for bit, and with paths known in closed form. */
class PixelPathTest {
    private static final int COLUMNS = 6;
    private static final int ROWS = 3;

    static List<String> shipped() {
        return ShippedScenes.names();
    }

    @ParameterizedTest
    @MethodSource("shipped")
    void shippedScenesAddUp(String name) {
        LitScene scene = ShippedScenes.quick(name);
        Rendering settings = scene.scene().rendering();
        pathsAddUp(input(scene, settings.withSize(48, 27).withSamplesPerPixel(1)));
    }

    @ParameterizedTest
    @ValueSource(ints = {0, 1, 3, 6})
    void randomGlassAndRoughSurfacesAddUp(int bounces) {
        for (int seed = 0; seed < 8; seed++) {
            LitScene scene = RandomMaterials.scene(new Random(seed), bounces);
            pathsAddUp(input(scene, scene.scene().rendering()));
        }
    }

    @Test
    void severalLightsAddUp() {
        for (int seed = 0; seed < 8; seed++) {
            Random random = new Random(seed);
            LitScene scene = seed % 2 == 0 ? RandomMaterials.scene(random, 3) : RandomMeshes.scene(random, 3);
            LitScene lit = RandomLights.added(scene, random);
            pathsAddUp(input(lit, lit.scene().rendering()));
        }
    }

    /** Suns and spots, too. */
    @Test
    void otherLightsAddUp() {
        for (int seed = 0; seed < 8; seed++) {
            Random random = new Random(seed);
            LitScene scene = RandomMaterials.scene(random, 3);
            LitScene lit = seed % 2 == 0 ? RandomLights.ofSuns(scene, random) : RandomLights.ofSpots(scene, random);
            pathsAddUp(input(lit, lit.scene().rendering()));
            pathsAddUp(input(lit, lit.scene().rendering().withIntegrator(Integrator.PATH)));
        }
    }

    @ParameterizedTest
    @MethodSource("shipped")
    void tracedPathsOfShippedScenesAddUp(String name) {
        LitScene scene = ShippedScenes.quick(name);
        Rendering settings = scene.scene().rendering();
        pathsAddUp(input(
                scene,
                settings.withSize(48, 27)
                        .withIntegrator(Integrator.PATH)
                        .withBounces(12)
                        .withSamplesPerPixel(3)));
    }

    @ParameterizedTest
    @ValueSource(ints = {0, 1, 8})
    void tracedPathsOfRandomScenesAddUp(int bounces) {
        for (int seed = 0; seed < 8; seed++) {
            Random random = new Random(seed);
            LitScene scene =
                    seed % 2 == 0 ? RandomMaterials.scene(random, bounces) : RandomMeshes.scene(random, bounces);
            pathsAddUp(input(scene, scene.scene().rendering().withIntegrator(Integrator.PATH)));
        }
    }

    @Test
    void tracedPathsUnderSeveralLightsAddUp() {
        for (int seed = 0; seed < 6; seed++) {
            Random random = new Random(seed);
            LitScene scene = RandomLights.added(RandomMaterials.scene(random, 6), random);
            pathsAddUp(input(scene, scene.scene().rendering().withIntegrator(Integrator.PATH)));
        }
    }

    /** Also those of a single sample, which is a picture of its own. */
    @Test
    void aTracedSampleIsThatOfTheEngine() {
        LitScene scene = ShippedScenes.small("weekend");
        FrameInput input = input(scene, scene.scene().rendering().withSize(48, 27));
        float[] sample = Pictures.radiance(JvmEngines.SEQUENTIAL, input.withSamples(3, 1));
        for (int pixel = 0; pixel < 48 * 27; pixel += 19) {
            // An even number of samples begins with item 1 of the sequence.
            Rgb radiance = PixelPath.of(input, pixel % 48, pixel / 48, 2).radiance();
            assertThat(radiance).isEqualTo(new Rgb(sample[3 * pixel], sample[3 * pixel + 1], sample[3 * pixel + 2]));
        }
    }

    /** Clear coats, films, dispersion and light that passes, too. */
    @Test
    void tracedPathsOfFinishesAddUp() {
        Scene scene = SceneReader.read(Path.of("docs", "finishes.json"));
        SceneMeshes meshes = SceneMeshes.read(scene, _ -> {});
        LitScene lit = new LitScene(scene, SceneImages.read(scene, meshes, _ -> {}), meshes);
        FrameInput input = input(lit, scene.rendering().withSize(70, 80).withSamplesPerPixel(3));
        pathsAddUp(input);
        boolean coats = false;
        boolean passes = false;
        for (int pixel = 0; pixel < input.width() * input.height(); pixel += 3) {
            PixelPath path = PixelPath.of(input, pixel % input.width(), pixel / input.width(), 0);
            for (PathStep step : path.steps()) {
                step.scattering().ifPresent(PixelPathTest::lobesAreAll);
            }
            coats |= path.steps().stream()
                    .anyMatch(step -> step.scattering().isPresent()
                            && step.scattering().get().lobes().coat() > 0);
            passes |= path.steps().stream()
                    .anyMatch(step -> step.scattering().isPresent()
                            && step.scattering().get().lobes().through() > 0);
        }
        assertThat(coats && passes).isTrue();
    }

    private static void lobesAreAll(Scattering surface) {
        LobeProbabilities lobes = surface.lobes();
        assertThat(lobes.mirror() + lobes.matte() + lobes.glass() + lobes.coat() + lobes.through())
                .isCloseTo(1, within(1e-5));
    }

    @Test
    void tracedStepsAddWhatTheirNumbersSay() {
        LitScene scene = RandomMaterials.scene(new Random(4), 8);
        FrameInput input = input(
                scene, scene.scene().rendering().withIntegrator(Integrator.PATH).withClamp(0));
        int found = 0;
        for (int pixel = 0; pixel < input.width() * input.height(); pixel += 5) {
            PixelPath path = PixelPath.of(input, pixel % input.width(), pixel / input.width(), 0);
            assertThat(path.isTraced()).isTrue();
            for (PathStep step : path.steps()) {
                step.scattering().ifPresent(PixelPathTest::lobesAreAll);
                if (step.adds().green() > 0) {
                    FoundLight light = step.light().orElseThrow();
                    double green = step.throughput().green()
                            * light.weight()
                            * light.radiance().green();
                    assertThat(step.adds().green()).isCloseTo(green, withinPercentage(0.01));
                    found++;
                }
            }
        }
        assertThat(found).isGreaterThan(50);
    }

    /** A path goes on with what its surface says, unless Russian roulette ends it. */
    @Test
    void throughputsFollowFromTheChoices() {
        LitScene scene = ShippedScenes.small("weekend");
        FrameInput input = input(scene, scene.scene().rendering().withSize(48, 27));
        int followed = 0;
        for (int pixel = 0; pixel < 48 * 27; pixel += 7) {
            List<PathStep> steps =
                    PixelPath.of(input, pixel % 48, pixel / 48, 0).steps();
            for (PathStep step : steps) {
                if (step.parent() != PathStep.NO_PARENT && step.kind() != RayKind.EMITTER) {
                    PathStep parent = steps.get(step.parent());
                    LobeChoice next = parent.scattering().orElseThrow().next().orElseThrow();
                    double red = parent.throughput().red() * next.factor().red() / next.survival();
                    assertThat(next.goesOn()).isTrue();
                    assertThat(step.kind()).isEqualTo(next.kind());
                    assertThat(step.throughput().red()).isCloseTo(red, withinPercentage(0.01));
                    followed++;
                }
            }
        }
        assertThat(followed).isGreaterThan(100);
    }

    /** Glass, rough surfaces and meshes: the kernel's view of bounces counts all rays after the view rays. */
    @Test
    void stepsAreThoseThatTheKernelCounts() {
        for (int seed = 0; seed < 8; seed++) {
            Random random = new Random(seed);
            LitScene scene = seed % 2 == 0 ? RandomMaterials.scene(random, 6) : RandomMeshes.scene(random, 6);
            FrameInput input = input(scene, scene.scene().rendering().withSize(24, 16));
            float[] counts = Pictures.radiance(JvmEngines.SEQUENTIAL, input.showing(StageOrView.BOUNCES));
            for (int pixel = 0; pixel < input.width() * input.height(); pixel += 7) {
                int rays = 0;
                for (int sample = 0; sample < input.samplesPerPixel(); sample++) {
                    rays += PixelPath.of(input, pixel % input.width(), pixel / input.width(), sample)
                                    .steps()
                                    .size()
                            - 1;
                }
                assertThat(rays * (1f / input.samplesPerPixel()))
                        .as("pixel %d of seed %d", pixel, seed)
                        .isEqualTo(counts[3 * pixel]);
            }
        }
    }

    /** Sums all samples of some pixels in the kernel's order. */
    private static void pathsAddUp(FrameInput input) {
        float[] picture = Pictures.radiance(JvmEngines.SEQUENTIAL, input);
        for (int i = 0; i < COLUMNS * ROWS; i++) {
            int column = (2 * (i % COLUMNS) + 1) * input.width() / (2 * COLUMNS);
            int row = (2 * (i / COLUMNS) + 1) * input.height() / (2 * ROWS);
            float[] sum = new float[3];
            for (int sample = 0; sample < input.samplesPerPixel(); sample++) {
                PixelPath path = PixelPath.of(input, column, row, sample);
                path.steps().forEach(step -> add(sum, step.adds()));
                path.steps().forEach(step -> step.shading().ifPresent(PixelPathTest::shadowIsTheMeanOfItsRays));
                treeIsWhole(path.steps());
            }
            int at = 3 * (row * input.width() + column);
            float average = 1f / input.samplesPerPixel();
            assertThat(new float[] {sum[0] * average, sum[1] * average, sum[2] * average})
                    .as("pixel %d,%d", column, row)
                    .containsExactly(picture[at], picture[at + 1], picture[at + 2]);
        }
    }

    private static void add(float[] sum, Rgb adds) {
        sum[0] += (float) adds.red();
        sum[1] += (float) adds.green();
        sum[2] += (float) adds.blue();
    }

    /** The kernel counts by other methods, which may differ where a ray grazes a sphere. */
    private static void shadowIsTheMeanOfItsRays(ShadedSurface shading) {
        shading.lights().forEach(PixelPathTest::shadowIsTheMeanOfItsRays);
    }

    private static void shadowIsTheMeanOfItsRays(LightPart light) {
        List<LightSample> rays = light.shadowRays();
        // Without rays, a mesh face turned away from the light has visibility 0, everything else 1.
        double mean = rays.stream().mapToDouble(LightSample::light).average().orElse(light.visible() == 0 ? 0 : 1);
        double ray = rays.size() > 1 ? 1.0 / rays.size() : 0;
        assertThat(mean).isCloseTo(light.visible(), within(ray + 1e-5));
    }

    private static void treeIsWhole(List<PathStep> steps) {
        assertThat(steps.getFirst().kind()).isEqualTo(RayKind.VIEW);
        for (int i = 1; i < steps.size(); i++) {
            PathStep step = steps.get(i);
            PathStep parent = steps.get(step.parent());
            assertThat(step.parent()).isLessThan(i);
            assertThat(step.bounce()).isEqualTo(parent.bounce() + 1);
            assertThat(step.origin()).isEqualTo(point(parent));
            assertThat(step.kind()).isNotEqualTo(RayKind.VIEW);
        }
    }

    private static Vector3 point(PathStep step) {
        return step.shading()
                .map(ShadedSurface::point)
                .orElseGet(() -> step.scattering().orElseThrow().point());
    }

    /** A view ray into two suns' discs, and its mirror image in the ground. */
    @ParameterizedTest
    @CsvSource({"-90, 0", "90, 1"})
    void discsOfSunsAreStepsBeforeTheSky(double pitch, int bounces) {
        Light red = Light.sun(new Vector3(0, -1, 0), 20).withColor(new Rgb(1, 0, 0));
        Light green = Light.sun(new Vector3(0, -1, 0.01), 40).withColor(new Rgb(0, 1, 0));
        Light aside = Light.sun(new Vector3(1, -1, 0), 40);
        Scene scene = scene(128, bounces)
                .withCamera(Camera.of(new Vector3(5, 4, 5), 0, pitch, 60))
                .withSpheres(List.of())
                .withLights(new Lights(List.of(red, aside, green)));
        Rendering settings = scene.rendering().withIntegrator(Integrator.PATH).withClamp(5);
        FrameInput input = World.of(scene.withRendering(settings), SKY).snapshot();
        PixelPath path = PixelPath.of(input, 0, 0, 0);
        List<PathStep> steps = path.steps();
        int view = steps.size() - 3;

        assertThat(view).isEqualTo(bounces);
        assertThat(steps.subList(view, steps.size()))
                .extracting(step -> path.bodyName(step.body()))
                .containsExactly("light", "light 3", "sky");
        for (PathStep step : steps.subList(view, steps.size())) {
            assertThat(step.parent()).isEqualTo(view - 1);
            assertThat(step.kind()).isEqualTo(view == 0 ? RayKind.VIEW : RayKind.REFLECTED);
            assertThat(step.distance()).isZero();
        }
        assertThat(steps.get(view).light().orElseThrow().radiance().green()).isZero();
        assertThat(steps.get(view).adds().red()).isGreaterThan(1);
        assertThat(steps.get(view).adds().blue()).isZero();
        assertThat(steps.get(view + 1).adds().green()).isGreaterThan(1);
        assertThat(steps.get(view + 1).adds().red()).isZero();
        assertThat(steps.getLast().adds())
                .isEqualTo(steps.getLast().light().orElseThrow().radiance());
        assertThat(path.radiance()).isEqualTo(path.pixel());
    }

    /** The ray goes straight down onto a half mirror; the reflected ray hits the sky. */
    @Test
    void mirrorShowsTheSky() {
        List<PathStep> steps =
                PixelPath.of(one(64, 1, new Vector3(5, 4, 5)), 0, 0, 0).steps();

        assertThat(steps).hasSize(2);
        ShadedSurface shading = steps.getFirst().shading().orElseThrow();
        assertThat(steps.getFirst().body()).isEqualTo(Layout.PLANE);
        assertThat(steps.getFirst().distance()).isCloseTo(4, within(1e-6));
        assertThat(shading.mirror()).isEqualTo(0.5);
        assertThat(light(shading).visible()).isEqualTo(1);
        assertThat(light(shading).shadowRays()).hasSize(8).allMatch(ray -> ray.blocker() == Layout.NOTHING);
        assertThat(steps.getLast().kind()).isEqualTo(RayKind.REFLECTED);
        assertThat(steps.getLast().body()).isEqualTo(Layout.NOTHING);
        assertThat(steps.getLast().throughput().red()).isCloseTo(0.5 * shading.lit(), within(1e-6));
    }

    @ParameterizedTest
    @CsvSource({"0, 0, 0", "0.9, 1, 2", "5, 1, -1"})
    void shadowRaysNameWhatBlocksThem(double x, double light, int blocker) {
        ShadedSurface shading = PixelPath.of(one(0, 0, new Vector3(x, 1, 0)), 0, 0, 0)
                .steps()
                .getFirst()
                .shading()
                .orElseThrow();

        assertThat(light(shading).shadowRays()).hasSize(8);
        if (blocker == 2) {
            assertThat(light(shading).visible()).isStrictlyBetween(0.0, light);
            assertThat(light(shading).shadowRays()).anyMatch(ray -> ray.light() == 0 && ray.blocker() == blocker);
        }
        if (blocker == Layout.NOTHING) {
            assertThat(light(shading).visible()).isEqualTo(light);
        }
        if (blocker == 0) {
            assertThat(light(shading).visible()).isZero();
            assertThat(light(shading).shadowRays()).allMatch(ray -> ray.light() == 0 && ray.blocker() == 2);
        }
    }

    @Test
    void glassIsATreeOfRays() {
        Scene scene = scene(0, 2);
        Sphere glass = Sphere.of(new Vector3(5, 2, 5), 0.5, new Rgb(1, 1, 1), 0);
        Scene clear = scene.withCamera(above(new Vector3(5, 4, 5)))
                .withSpheres(List.of(glass.withMaterial(glass.material().withTransmission(1))));
        List<PathStep> steps =
                PixelPath.of(World.of(clear, SKY).snapshot(), 0, 0, 0).steps();

        assertThat(steps.getFirst().shading().orElseThrow().reflectance()).isCloseTo(0.04, within(1e-6));
        assertThat(steps)
                .extracting(PathStep::kind)
                .containsExactly(
                        RayKind.VIEW, RayKind.REFLECTED, RayKind.REFRACTED, RayKind.REFLECTED, RayKind.REFRACTED);
        assertThat(steps).extracting(PathStep::inside).containsExactly(false, false, true, true, false);
    }

    @Test
    void viewsAreExplainedAsThePicture() {
        FrameInput input = one(64, 1, new Vector3(5, 4, 5));
        assertThat(PixelPath.of(input.showing(StageOrView.DEPTH), 0, 0, 0)).isEqualTo(PixelPath.of(input, 0, 0, 0));
    }

    @Test
    void pixelsOutsideAreRefused() {
        FrameInput input = one(0, 0, new Vector3(0, 4, 0));
        assertThatThrownBy(() -> PixelPath.of(input, 1, 0, 0)).isInstanceOf(IndexOutOfBoundsException.class);
        assertThatThrownBy(() -> PixelPath.of(input, 0, -1, 0)).isInstanceOf(IndexOutOfBoundsException.class);
        assertThatThrownBy(() -> PixelPath.of(input, 0, 0, 1)).isInstanceOf(IndexOutOfBoundsException.class);
    }

    private static final Skybox SKY = new Skybox(1, 1, new float[] {0.25f, 0.5f, 0.75f});

    /** One pixel that looks straight down, with a sphere between the light and the plane's center. */
    private static FrameInput one(double groundReflectivity, int bounces, Vector3 eye) {
        return World.of(scene(groundReflectivity, bounces).withCamera(above(eye)), SKY)
                .snapshot();
    }

    private static Camera above(Vector3 eye) {
        return Camera.of(eye, 0, 90, 60);
    }

    private static Scene scene(double groundReflectivity, int bounces) {
        return Scene.under(Path.of("none.hdr"))
                .withLights(Lights.of(Light.of(new Vector3(0, 10, 0), 0.5, new Rgb(1, 1, 1))))
                .withGround(Ground.of(40, 0, new Rgb(0.5, 0.5, 0.5), new Rgb(0.5, 0.5, 0.5), groundReflectivity))
                .withSpheres(List.of(Sphere.of(new Vector3(0, 5, 0), 0.75, new Rgb(0.5, 0.5, 0.5), 0)))
                .withRendering(Rendering.DEFAULT
                        .withSize(1, 1)
                        .withBounces(bounces)
                        .withSamplesPerPixel(1)
                        .withShadowSamples(8));
    }

    private static FrameInput input(LitScene lit, Rendering settings) {
        return World.of(lit.scene().withRendering(settings), lit.images(), lit.meshes())
                .snapshot();
    }

    private static LightPart light(ShadedSurface shading) {
        return shading.onlyLight().orElseThrow();
    }
}
