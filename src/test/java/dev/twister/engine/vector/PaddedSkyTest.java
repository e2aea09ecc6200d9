package dev.twister.engine.vector;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.scene.Scene;
import dev.twister.scene.SceneReader;
import dev.twister.sky.Skybox;
import dev.twister.sky.SkyboxReader;
import dev.twister.world.World;
import java.nio.file.Path;
import jdk.incubator.vector.FloatVector;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

final class PaddedSkyTest {
    private static final Scene SCENE = SceneReader.read(Path.of("scenes/teaching.json"));

    /** The lowest bit that a half has, and the one below it. */
    @ParameterizedTest
    @ValueSource(ints = {0x10000, 0x8000})
    void holdsEveryTexelAndItsBorderWithoutLoss(int lowestBit) {
        Skybox shipped = SkyboxReader.read(SCENE.skybox());
        float[] radiance = shipped.radiance().clone();
        int last = radiance.length - 1;
        radiance[last] = Float.intBitsToFloat(Float.floatToRawIntBits(1f) | lowestBit);
        Skybox sky = new Skybox(shipped.width(), shipped.height(), radiance);

        PaddedSky padded = new PaddedSky();
        padded.take(World.of(SCENE, sky).snapshot());

        boolean wide = FloatVector.SPECIES_PREFERRED.vectorBitSize() >= 256;
        assertThat(padded.halved).isEqualTo(wide && lowestBit == 0x10000);
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

    @Test
    void takesAnotherSkyOfAnotherKind() {
        Skybox shipped = SkyboxReader.read(SCENE.skybox());
        PaddedSky padded = new PaddedSky();
        padded.take(World.of(SCENE, new Skybox(1, 1, new float[] {0.1f, 0.2f, 0.3f}))
                .snapshot());
        assertThat(padded.halved).isFalse();
        assertThat(padded.value(3 * (padded.stride() + 1) + 2)).isEqualTo(0.3f);
        padded.take(World.of(SCENE, shipped).snapshot());
        assertThat(padded.value(3 * (padded.stride() + 1))).isEqualTo(shipped.radiance()[0]);
    }
}
