package dev.twister.gui.drawing;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import dev.twister.engine.Engine;
import dev.twister.engine.Engines;
import dev.twister.engine.JvmEngines;
import dev.twister.gui.edit.BodyMaterials;
import dev.twister.gui.edit.Scenes;
import dev.twister.image.Frame;
import dev.twister.kernel.Layout;
import dev.twister.oracle.Pictures;
import dev.twister.scene.Scene;
import dev.twister.scene.ToneMap;
import dev.twister.world.FrameInput;
import java.nio.IntBuffer;
import java.util.Arrays;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

class RefinedPictureTest {
    private static final int PIXELS = Scenes.WIDTH * Scenes.HEIGHT;
    private final FrameInput input = Scenes.input(Scenes.scene());

    private static RefinedPicture after(FrameInput input, int limit, int... passes) {
        RefinedPicture picture = new RefinedPicture(Scenes.WIDTH, Scenes.HEIGHT, limit, false);
        Frame linear = Frame.ofRadiance(Scenes.WIDTH, Scenes.HEIGHT);
        try (Engine engine = Engines.open(JvmEngines.PARALLEL)) {
            for (int samples : passes) {
                engine.render(picture.next(input, samples), linear);
                picture.add(linear, samples);
            }
        }
        return picture;
    }

    private static int[] shown(RefinedPicture picture, FrameInput input) {
        int[] argb = new int[PIXELS];
        picture.show(input, IntBuffer.wrap(argb));
        return argb;
    }

    private static int largestDifference(int[] one, int[] other) {
        int largest = 0;
        for (int i = 0; i < one.length; i++) {
            for (int shift = 0; shift < 32; shift += 8) {
                largest = Math.max(largest, Math.abs(((one[i] >> shift) & 255) - ((other[i] >> shift) & 255)));
            }
        }
        return largest;
    }

    @ParameterizedTest
    @EnumSource
    void passesComeToThePictureDrawnInOneGo(ToneMap toneMap) {
        var scene = Scenes.scene();
        var toned = scene.withRendering(
                scene.rendering().withSamplesPerPixel(13).withTone(0.7, toneMap, toneMap != ToneMap.CLAMP));
        FrameInput whole = Scenes.input(toned);
        int[] inOneGo = Pictures.argb(JvmEngines.PARALLEL, whole);
        assertThat(largestDifference(shown(after(whole, 100, 1, 2, 4, 6), whole), inOneGo))
                .isLessThanOrEqualTo(1);
        assertThat(shown(after(whole, 100, 13), whole)).isEqualTo(inOneGo);
    }

    @Test
    void radianceIsTheAverage() {
        RefinedPicture picture = after(input, 100, 3, 5);
        Frame inOneGo = Frame.ofRadiance(Scenes.WIDTH, Scenes.HEIGHT);
        try (Engine engine = Engines.open(JvmEngines.PARALLEL)) {
            engine.render(input.withSamples(0, 8), inOneGo);
        }
        float[] radiance = picture.radiance();
        for (int i = 0; i < radiance.length; i++) {
            assertThat(radiance[i]).isCloseTo(inOneGo.radiance()[i], within(1e-5f));
        }
    }

    /** Each pass has samples of its own for the lens and for rough surfaces, so that noise becomes less. */
    @Test
    void passesThroughALensOnRoughSurfacesConvergeOnThePictureOfManySamples() {
        Scene scene = Scenes.scene();
        Scene rough = BodyMaterials.edited(
                scene.withCamera(scene.camera().withAperture(0.2).withFocusDistance(8)),
                Layout.PLANE,
                old -> old.withReflectivity(100).withRoughness(0.6));
        FrameInput noisy = Scenes.input(rough);
        float[] many = after(noisy, 1024, 1024).radiance();

        double few = error(after(noisy, 1024, 1, 1, 1, 1).radiance(), many);
        double more = error(after(noisy, 1024, 16, 16, 16, 16).radiance(), many);

        assertThat(more).isLessThan(few / 3);
    }

    private static double error(float[] radiance, float[] expected) {
        double squares = 0;
        for (int i = 0; i < radiance.length; i++) {
            squares += Math.pow(radiance[i] - expected[i], 2);
        }
        return Math.sqrt(squares / radiance.length);
    }

    @Test
    void oneSampleMoreMakesAnotherPicture() {
        assertThat(shown(after(input, 100, 1, 1), input)).isNotEqualTo(shown(after(input, 100, 1), input));
    }

    @Test
    void startsAnew() {
        RefinedPicture picture = after(input, 100, 2, 2);
        assertThat(picture.samples()).isEqualTo(4);
        picture.reset();
        assertThat(picture.samples()).isZero();
        assertThat(picture.radiance()).containsOnly(0f);
        Frame white = Frame.ofRadiance(Scenes.WIDTH, Scenes.HEIGHT);
        Arrays.fill(white.radiance(), 1f);
        picture.add(white, 1);
        assertThat(shown(picture, input)).containsOnly(0xFFFFFFFF);
    }

    @Test
    void stopsAtItsLimit() {
        RefinedPicture picture = after(input, 5, 4);
        assertThat(picture.isDone()).isFalse();
        assertThat(picture.samplesOfNextPass(4)).isEqualTo(1);
        assertThat(after(input, 5, 4, 1).isDone()).isTrue();
        assertThat(after(input, 5, 4, 1).samplesOfNextPass(4)).isZero();
    }

    @Test
    void theNoiseOfTwoHalvesIsTheErrorOfTheirMean() {
        RefinedPicture picture = new RefinedPicture(Scenes.WIDTH, Scenes.HEIGHT, 100, true);
        assertThat(picture.noise(linearInput())).isEmpty();
        addConstant(picture, 0.5f, 1);
        assertThat(picture.noise(linearInput())).isEmpty();
        addConstant(picture, 0.3f, 1);

        // Half the difference.
        assertThat(picture.noise(linearInput()).getAsDouble()).isCloseTo(0.1, within(1e-6));
        assertThat(picture.radiance()[0]).isCloseTo(0.4f, within(1e-6f));
        picture.reset();
        assertThat(picture.noise(linearInput())).isEmpty();
    }

    @Test
    void theNoiseOfAPictureWithoutAnEstimateIsUnknown() {
        assertThat(after(input, 100, 1, 1).noise(input)).isEmpty();
    }

    private FrameInput linearInput() {
        Scene scene = Scenes.scene();
        return Scenes.input(scene.withRendering(scene.rendering().withTone(0, ToneMap.CLAMP, false)));
    }

    private static void addConstant(RefinedPicture picture, float radiance, int samples) {
        Frame pass = Frame.ofRadiance(Scenes.WIDTH, Scenes.HEIGHT);
        Arrays.fill(pass.radiance(), radiance);
        picture.add(pass, samples);
    }

    @Test
    void refusesOtherFrames() {
        RefinedPicture picture = new RefinedPicture(Scenes.WIDTH, Scenes.HEIGHT, 4, false);
        assertThatThrownBy(() -> picture.add(Frame.ofPixels(Scenes.WIDTH, Scenes.HEIGHT), 1))
                .isInstanceOf(IllegalArgumentException.class);
        assertThatThrownBy(() -> picture.add(Frame.ofRadiance(Scenes.WIDTH, 5), 1))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("96 x 64");
        assertThatThrownBy(() -> picture.show(input, IntBuffer.allocate(PIXELS)))
                .isInstanceOf(IllegalStateException.class);
    }
}
