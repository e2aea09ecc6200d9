package dev.twister.engine.vector.frame;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.scene.Scene;
import dev.twister.scene.format.SceneReader;
import dev.twister.sky.Skybox;
import dev.twister.sky.SkyboxReader;
import dev.twister.world.World;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

final class PaddedSkyTest {
    private static final Scene SCENE = SceneReader.read(Path.of("scenes/teaching.json"));

    /** The lowest bit that a half float holds, and the one below it. */
    @ParameterizedTest
    @ValueSource(ints = {0x10000, 0x8000})
    void holdsEveryTexelAndItsBorderWithoutLoss(int lowestBit) {
        Skybox shipped = SkyboxReader.read(SCENE.sky().file());
        float[] radiance = shipped.radiance().clone();
        int last = radiance.length - 1;
        radiance[last] = Float.intBitsToFloat(Float.floatToRawIntBits(1f) | lowestBit);
        Skybox sky = new Skybox(shipped.width(), shipped.height(), radiance);

        PaddedSky padded = new PaddedSky();
        padded.take(World.of(SCENE, sky).snapshot());

        assertThat(padded.halved).isEqualTo(lowestBit == 0x10000);
        for (int row = -1; row <= sky.height(); row++) {
            for (int column = -1; column <= sky.width(); column++) {
                int texel = Math.clamp(row, 0, sky.height() - 1) * sky.width() + Math.floorMod(column, sky.width());
                for (int channel = 0; channel < 3; channel++) {
                    float held = padded.value(3 * ((row + 1) * padded.stride() + column + 1) + channel);
                    if (held != radiance[3 * texel + channel]) {
                        assertThat(held)
                                .as("row %d, column %d, channel %d", row, column, channel)
                                .isEqualTo(radiance[3 * texel + channel]);
                    }
                }
            }
        }
    }

    /** The shipped sky is a Radiance picture, in which the three channels of a texel share an exponent. */
    @Test
    void sharesTheExponentsOfARadiancePicture() {
        Skybox sky = SkyboxReader.read(SCENE.sky().file());

        PaddedSky padded = new PaddedSky();
        padded.take(World.of(SCENE, sky).snapshot());

        assertThat(padded.isShared()).isTrue();
        float[] numbers = new float[sky.radiance().length];
        for (int at = 0; at < numbers.length; at++) {
            int row = at / 3 / sky.width();
            int column = at / 3 % sky.width();
            int texel = padded.shared[(row + 1) * padded.stride() + column + 1];
            numbers[at] = unpacked(texel, at % 3);
        }
        assertThat(numbers).isEqualTo(sky.radiance());
        assertThat(padded.shared[0]).isEqualTo(padded.shared[sky.width()]);
    }

    private static float unpacked(int texel, int channel) {
        return (texel >>> (8 * channel) & 255) * Float.intBitsToFloat(texel >>> 24 << 23);
    }

    /** Eight bits from the leading bit of the largest channel on, none below the smallest float's exponent. */
    @ParameterizedTest
    @CsvSource({
        "0, 0, 0, true",
        "255, 1, 0, true",
        "256, 2, 510, true",
        "256, 1, 0, false",
        "257, 0, 0, false",
        "1, 0.0078125, 0, true",
        "1, 0.00390625, 0, false",
        "1e-36, 0, 0, false",
        "-1, 0, 0, false",
        "1, -1, 1, false",
        "3.3895314e38, 0, 1.3292280e36, true",
    })
    void sharesWhatLosesNothing(float red, float green, float blue, boolean shared) {
        PaddedSky padded = new PaddedSky();
        padded.take(World.of(SCENE, new Skybox(1, 1, new float[] {red, green, blue}))
                .snapshot());

        assertThat(padded.isShared()).isEqualTo(shared);
        if (shared) {
            int texel = padded.shared[padded.stride() + 1];
            assertThat(new float[] {unpacked(texel, 0), unpacked(texel, 1), unpacked(texel, 2)})
                    .containsExactly(red, green, blue);
        }
    }

    @Test
    void takesAnotherSkyOfAnotherKind() {
        Skybox shipped = SkyboxReader.read(SCENE.sky().file());
        PaddedSky padded = new PaddedSky();
        padded.take(World.of(SCENE, new Skybox(1, 1, new float[] {0.1f, 0.2f, 0.3f}))
                .snapshot());
        assertThat(padded.halved).isFalse();
        assertThat(padded.value(3 * (padded.stride() + 1) + 2)).isEqualTo(0.3f);
        padded.take(World.of(SCENE, shipped).snapshot());
        assertThat(padded.value(3 * (padded.stride() + 1))).isEqualTo(shipped.radiance()[0]);
    }
}
