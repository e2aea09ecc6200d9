package dev.twister.engine;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import dev.twister.engine.ConvergingPicture.Converged;
import dev.twister.engine.ConvergingPicture.Convergence;
import dev.twister.engine.vector.VectorEngines;
import dev.twister.image.Frame;
import dev.twister.kernel.Layout;
import dev.twister.kernel.Tone;
import dev.twister.oracle.LitScene;
import dev.twister.oracle.ShippedScenes;
import dev.twister.scene.Rendering;
import dev.twister.world.FrameInput;
import dev.twister.world.World;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class ConvergingPictureTest {
    private static final int MOST_SAMPLES = 512;

    private final FrameInput metals = input("metals");

    @ParameterizedTest
    @ValueSource(doubles = {0.02, 0.01})
    void theErrorIsBelowTheBound(double noise) {
        float[] expected = radiance(metals.withSamples(0, 4096));
        Frame frame = Frame.ofRadiance(metals.width(), metals.height());
        int samples = draw(metals, frame, noise);

        double sum = 0;
        for (int i = 0; i < expected.length; i++) {
            double error = shown(frame.radiance()[i]) - shown(expected[i]);
            sum += error * error;
        }
        assertThat(samples).isLessThan(MOST_SAMPLES);
        assertThat(Math.sqrt(sum / expected.length)).isLessThan(noise);
    }

    @Test
    void lessNoiseTakesMoreSamples() {
        Frame frame = Frame.ofPixels(metals.width(), metals.height());
        assertThat(draw(metals, frame, 0.01)).isGreaterThan(draw(metals, frame, 0.04));
    }

    @Test
    void whatIsNotReachedEndsAtTheLimit() {
        Frame frame = Frame.ofPixels(metals.width(), metals.height());
        assertThat(draw(metals, frame, 1e-9)).isEqualTo(MOST_SAMPLES);
    }

    @Test
    void aTileIsThatOfAsManySamples() {
        Frame frame = Frame.ofRadiance(metals.width(), metals.height());
        int[] samples = converged(metals, frame, 0.03).samplesOfTile();
        int least = Arrays.stream(samples).min().orElseThrow();
        float[] inOneGo = radiance(metals.withSamples(metals.firstSample(), least));

        assertThat(Arrays.stream(samples).max().orElseThrow()).isGreaterThan(least);
        for (int pixel = 0; pixel < metals.width() * metals.height(); pixel++) {
            int tile = pixel / metals.width() / 16 * metals.tilesAcross() + pixel % metals.width() / 16;
            if (samples[tile] == least) {
                assertThat(frame.radiance()[3 * pixel]).isCloseTo(inOneGo[3 * pixel], within(1e-4f));
            }
        }
    }

    @Test
    void tilesAreTheSameInEveryPart() {
        Frame whole = Frame.ofRadiance(metals.width(), metals.height());
        converged(metals, whole, 0.03);
        FrameInput part = metals.band(16, metals.height() - 16);
        Frame below = Frame.ofRadiance(part.width(), part.rows());
        converged(part, below, 0.03);

        assertThat(below.radiance()).isEqualTo(whole.rows(16, part.rows()).radiance());
    }

    @Test
    void anotherRangeHasOtherSamples() {
        Frame first = Frame.ofRadiance(metals.width(), metals.height());
        Frame second = Frame.ofRadiance(metals.width(), metals.height());
        converged(metals.withSamples(1, 64), first, 0.03);
        converged(metals.withSamples(65, 64), second, 0.03);

        assertThat(first.radiance()).isNotEqualTo(second.radiance());
    }

    @Test
    void withoutABoundAllTilesGetAllSamples() {
        Frame frame = Frame.ofRadiance(metals.width(), metals.height());

        assertThat(converged(metals, frame, 0).samplesOfTile()).containsOnly(MOST_SAMPLES);
    }

    @ParameterizedTest
    @ValueSource(strings = {JvmEngines.SEQUENTIAL, VectorEngines.VECTOR})
    void pathsConvergeAlikeOnEveryEngine(String engineId) {
        FrameInput traced = traced();
        Frame expected = Frame.ofPixels(traced.width(), traced.height());
        Frame frame = Frame.ofPixels(traced.width(), traced.height());
        List<Convergence> expectedPasses = new ArrayList<>();
        List<Convergence> passes = new ArrayList<>();
        draw(JvmEngines.PARALLEL, traced, expected, 0.05, expectedPasses);
        draw(engineId, traced, frame, 0.05, passes);

        assertThat(passes).isEqualTo(expectedPasses);
        assertThat(frame.argb()).isEqualTo(expected.argb());
    }

    @Test
    void passesEndOnceAllTilesAreBelowTheBound() {
        List<Convergence> passes = new ArrayList<>();
        FrameInput traced = traced();
        draw(JvmEngines.PARALLEL, traced, Frame.ofPixels(traced.width(), traced.height()), 0.05, passes);

        assertThat(passes.getLast().noise()).isLessThanOrEqualTo(0.05);
        assertThat(passes.getLast().part()).isEqualTo(1);
        assertThat(passes).extracting(Convergence::samples).isSorted().allMatch(samples -> samples % 2 == 0);
        assertThat(passes.subList(0, passes.size() - 1))
                .extracting(Convergence::part)
                .allMatch(part -> part > 0 && part < 1);
    }

    /** Without a clamp one sample can find more light than all the others. */
    @Test
    void moreSamplesAreNeededWithoutAClamp() {
        assertThat(leastSamples(traced())).isBetween(16, 31);
        assertThat(leastSamples(traced(0))).isGreaterThanOrEqualTo(32);
    }

    private static int leastSamples(FrameInput input) {
        Frame frame = Frame.ofPixels(input.width(), input.height());
        return Arrays.stream(converged(input, frame, 0.2).samplesOfTile()).min().orElseThrow();
    }

    private static FrameInput traced() {
        return traced(10);
    }

    private static FrameInput traced(double clamp) {
        LitScene small = ShippedScenes.small("weekend");
        World world = World.of(small.scene(), small.images());
        world.setSettings(small.scene().rendering().withSize(48, 27).withClamp(clamp));
        return world.snapshot();
    }

    private float shown(float radiance) {
        float[] frame = metals.view().frame();
        return Tone.shown(radiance, frame[Layout.EXPOSURE_SCALE], (int) frame[Layout.TONE_MAP], frame[Layout.SRGB]);
    }

    private static int draw(FrameInput input, Frame frame, double noise) {
        return draw(JvmEngines.PARALLEL, input, frame, noise, new ArrayList<>());
    }

    private static int draw(String engineId, FrameInput input, Frame frame, double noise, List<Convergence> passes) {
        try (Engine engine = Engines.open(engineId)) {
            return ConvergingPicture.draw(engine, input, frame, noise, MOST_SAMPLES, passes::add)
                    .reached()
                    .samples();
        }
    }

    private static Converged converged(FrameInput input, Frame frame, double noise) {
        try (Engine engine = Engines.open(JvmEngines.PARALLEL)) {
            return ConvergingPicture.draw(engine, input, frame, noise, MOST_SAMPLES, _ -> {});
        }
    }

    private static float[] radiance(FrameInput input) {
        Frame frame = Frame.ofRadiance(input.width(), input.height());
        try (Engine engine = Engines.open(JvmEngines.PARALLEL)) {
            engine.render(input, frame);
        }
        return frame.radiance();
    }

    @Test
    void passesOfAllSamplesThatASceneCanAskForAreItsPicture() {
        LitScene small = ShippedScenes.small("metals");
        World world = World.of(small.scene(), small.images());
        world.setSettings(small.scene()
                .rendering()
                .withSize(4, 3)
                .withShadowSamples(1)
                .withSamplesPerPixel(Rendering.MAX_SAMPLES_PER_PIXEL));
        FrameInput input = world.snapshot();
        Frame passes = Frame.ofRadiance(4, 3);
        int[] samples = new int[1];
        try (Engine engine = Engines.open("sequential")) {
            ConvergingPicture.draw(
                    engine, input, passes, 0, input.samplesPerPixel(), reached -> samples[0] = reached.samples());
        }

        assertThat(samples[0]).isEqualTo(65536);
        float[] whole = radiance(input);
        for (int i = 0; i < whole.length; i++) {
            assertThat(passes.radiance()[i]).isCloseTo(whole[i], within(1e-3f * Math.max(1, whole[i])));
        }
    }

    private static FrameInput input(String scene) {
        LitScene small = ShippedScenes.small(scene);
        World world = World.of(small.scene(), small.images());
        world.setSettings(small.scene().rendering().withSize(48, 27).withShadowSamples(8));
        return world.snapshot();
    }
}
