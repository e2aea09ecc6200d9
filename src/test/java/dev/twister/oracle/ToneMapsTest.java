package dev.twister.oracle;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import dev.twister.kernel.Tone;
import dev.twister.scene.Rendering;
import dev.twister.scene.ToneMap;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** The kernel supports every tone map that a scene can select. */
class ToneMapsTest {
    @SuppressWarnings("EnumOrdinal") // it is what engines are given
    @ParameterizedTest
    @EnumSource
    void kernelMapsAsTheOracleDoes(ToneMap toneMap) {
        OracleTone oracle = new OracleTone(Rendering.DEFAULT.withTone(0, toneMap, false));
        for (int step = 0; step < 400; step++) {
            float gray = step * 0.01f;
            int level = oracle.argb(new Color(gray, gray, gray)) & 0xFF;
            assertThat(Tone.quantized(gray, 1f, toneMap.ordinal(), 0f))
                    .as("radiance %s", gray)
                    .isCloseTo(level, within(1));
        }
    }
}
