package dev.twister.kernel;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.engine.JvmEngines;
import dev.twister.oracle.Crowds;
import dev.twister.oracle.LitScene;
import dev.twister.oracle.Pictures;
import dev.twister.oracle.RandomScenes;
import dev.twister.scene.Camera;
import dev.twister.scene.Light;
import dev.twister.scene.Plane;
import dev.twister.scene.RenderSettings;
import dev.twister.scene.Rgb;
import dev.twister.scene.Scene;
import dev.twister.scene.Sphere;
import dev.twister.scene.Vector3;
import dev.twister.world.FrameInput;
import dev.twister.world.World;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import net.jqwik.api.ShrinkingMode;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Strips on the JVM: the same sums as the kernel's pixel by pixel, so that not a bit may differ. */
class StripKernelTest {
    private static final int NOT_DRAWN = 0x00BADBAD;

    @Provide
    Arbitrary<LitScene> scenes() {
        return RandomScenes.upToBounces(8);
    }

    @Property(seed = "20261122", tries = 150, shrinking = ShrinkingMode.OFF)
    void stripsDrawWhatTheKernelDrawsBitForBit(@ForAll("scenes") LitScene random) {
        requireSequentials(World.of(random.scene(), random.sky()).snapshot());
    }

    @Property(seed = "20261122", tries = 50, shrinking = ShrinkingMode.OFF)
    void stripsFindTheKernelsRadianceBitForBit(@ForAll("scenes") LitScene random) {
        FrameInput input = World.of(random.scene(), random.sky()).snapshot();
        float[] radiance = new float[3 * input.width() * input.rows()];
        Arrays.fill(radiance, Float.NaN);
        draw(input, PixelKernel.FEW_SPHERES, PixelKernel.LINEAR, new int[1], radiance);
        assertThat(radiance).isEqualTo(Pictures.radiance(JvmEngines.SEQUENTIAL, random.scene(), random.sky()));
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 2, 31, 32, 33, 63, 64, 65, 101})
    void rowsOfAnyWidthAreDrawnWhole(int width) {
        requireSequentials(Crowds.world(12, width, 20).snapshot());
    }

    @Test
    void bandsAreDrawnInTheirPlace() {
        requireSequentials(Crowds.world(12, 70, 40).snapshot().band(13, 9));
    }

    @Test
    void crowdsAreDrawnThroughTheHierarchy() {
        requireSequentials(Crowds.world(3000, 100, 60).snapshot());
    }

    /** A plane under a cloud of spheres that all lie in the light's wide cone. */
    @Test
    void pointsOfMoreCandidatesThanAreRememberedAreShaded() {
        Random random = new Random(3);
        List<Sphere> cloud = new ArrayList<>();
        for (int i = 0; i < 4 * Layout.MOST_CANDIDATES; i++) {
            Vector3 place =
                    new Vector3(6 * random.nextDouble() - 3, 4 + random.nextDouble(), 6 * random.nextDouble() - 3);
            cloud.add(Sphere.of(place, 0.05, new Rgb(1, 1, 1), 0));
        }
        Scene scene = Scene.under(Path.of("none.hdr"))
                .withCamera(Camera.of(new Vector3(0, 2, -6), 0, 20, 60))
                .withLight(Light.of(new Vector3(0, 9, 0), 3, new Rgb(1, 1, 1)))
                .withPlane(Plane.of(20, 0, new Rgb(1, 1, 1), new Rgb(0.5, 0.5, 0.5), 0))
                .withSpheres(cloud)
                .withAmbient(0.1)
                .withSettings(
                        RenderSettings.DEFAULT.withSize(48, 24).withShadows(50).withBounces(0));
        requireSequentials(World.of(scene, RandomScenes.scene(random, 1).sky()).snapshot());
    }

    @Test
    void theMostShadowSamplesOfASceneFit() {
        assertThat(Layout.MOST_SHADOW_SAMPLES).isEqualTo(RenderSettings.MAX_SHADOW_SAMPLES);
        World world = Crowds.world(12, 40, 20);
        world.setSettings(world.settings().withShadows(RenderSettings.MAX_SHADOW_SAMPLES));
        requireSequentials(world.snapshot());
    }

    /** They would add nothing, but be traced for nothing. */
    @Test
    void lanesWhosePathHasEndedMeetNothing() {
        float[] positions = {0, 9, 0, 0, 0, 0, 0, 4, 0};
        float[] sizes = {1, 20, 1};
        float[] lanes = new float[Strip.FLOATS];
        int[] marks = new int[Strip.MARKS];
        for (int lane = 0; lane < 2; lane++) {
            lanes[Strip.ORIGIN_Y + lane] = 2;
            lanes[Strip.DIRECTION_Y + lane] = 1;
        }
        marks[Strip.LEAVING] = Layout.NOTHING;
        marks[Strip.LEAVING + 1] = Strip.FINISHED;

        StripHits.ofAllBodies(2, positions, sizes, sizes.length, lanes, marks);

        assertThat(marks[Strip.HIT]).isEqualTo(Layout.FIRST_SPHERE);
        assertThat(marks[Strip.HIT + 1]).isEqualTo(Strip.FINISHED);
    }

    private static void requireSequentials(FrameInput input) {
        int[] expected = Pictures.argb(JvmEngines.SEQUENTIAL, input);
        for (int shortcuts : new int[] {PixelKernel.FEW_SPHERES, PixelKernel.SHORTCUTS}) {
            int[] argb = new int[input.width() * input.rows()];
            Arrays.fill(argb, NOT_DRAWN);
            draw(input, shortcuts, PixelKernel.ARGB, argb, new float[1]);
            assertThat(argb).as("with shortcuts %d", shortcuts).isEqualTo(expected);
        }
    }

    private static void draw(FrameInput input, int shortcuts, int output, int[] argb, float[] radiance) {
        float[] lanes = new float[Strip.FLOATS];
        int[] marks = new int[Strip.MARKS];
        float[] scratch = new float[Layout.SCRATCH_LENGTH];
        Arrays.fill(lanes, Float.NaN);
        Arrays.fill(marks, Integer.MIN_VALUE);
        for (int row = 0; row < input.rows(); row++) {
            for (int strip = 0; strip < Strip.inRow(input.width()); strip++) {
                StripKernel.draw(
                        strip * Strip.LANES,
                        row,
                        argb,
                        radiance,
                        input.dimensions(),
                        input.camera(),
                        input.rayTracingProperties(),
                        input.bodyPositions(),
                        input.bodySizes(),
                        input.bodyColors(),
                        input.bodyReflectivities(),
                        input.skybox(),
                        input.skyboxDimensions(),
                        input.shadowDisc(),
                        input.pixelOffsets(),
                        input.hierarchy(),
                        lanes,
                        marks,
                        scratch,
                        shortcuts,
                        output);
            }
        }
    }
}
