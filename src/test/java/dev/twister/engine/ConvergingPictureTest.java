package dev.twister.engine;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.engine.ConvergingPicture.Convergence;
import dev.twister.engine.vector.VectorEngines;
import dev.twister.image.Frame;
import dev.twister.kernel.Layout;
import dev.twister.kernel.Tone;
import dev.twister.oracle.LitScene;
import dev.twister.oracle.PictureDifference;
import dev.twister.oracle.Pictures;
import dev.twister.oracle.ShippedScenes;
import dev.twister.world.FrameInput;
import dev.twister.world.World;
import java.util.ArrayList;
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
    void thePictureIsThatOfAsManySamples() {
        Frame frame = Frame.ofPixels(metals.width(), metals.height());
        int samples = draw(metals, frame, 0.04);

        int[] inOneGo = Pictures.argb(JvmEngines.PARALLEL, metals.withSamples(0, samples));
        assertThat(PictureDifference.between(frame.argb(), inOneGo)).matches(PictureDifference::isWithinBound);
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
    void passesEndWithTheFirstBelowTheBound() {
        List<Convergence> passes = new ArrayList<>();
        FrameInput traced = traced();
        draw(JvmEngines.PARALLEL, traced, Frame.ofPixels(traced.width(), traced.height()), 0.05, passes);

        assertThat(passes.getLast().noise()).isLessThanOrEqualTo(0.05);
        assertThat(passes.subList(0, passes.size() - 1)).allMatch(pass -> pass.noise() > 0.05);
        assertThat(passes).extracting(Convergence::samples).isSorted().allMatch(samples -> samples % 2 == 0);
    }

    @Test
    void expectedSamplesGrowWithTheSquareOfTheNoise() {
        assertThat(new Convergence(16, 0.02).expectedSamples(0.01, 1000)).isEqualTo(64);
        assertThat(new Convergence(16, 0.005).expectedSamples(0.01, 1000)).isEqualTo(16);
        assertThat(new Convergence(16, 0.02).expectedSamples(0.01, 40)).isEqualTo(40);
        assertThat(new Convergence(16, 0.02).expectedSamples(0, 1000)).isEqualTo(1000);
    }

    private static FrameInput traced() {
        LitScene small = ShippedScenes.small("weekend");
        World world = World.of(small.scene(), small.images());
        world.setSettings(small.scene().rendering().withSize(48, 27));
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
                    .samples();
        }
    }

    private static float[] radiance(FrameInput input) {
        Frame frame = Frame.ofRadiance(input.width(), input.height());
        try (Engine engine = Engines.open(JvmEngines.PARALLEL)) {
            engine.render(input, frame);
        }
        return frame.radiance();
    }

    private static FrameInput input(String scene) {
        LitScene small = ShippedScenes.small(scene);
        World world = World.of(small.scene(), small.images());
        world.setSettings(small.scene().rendering().withSize(48, 27).withShadows(8));
        return world.snapshot();
    }
}
