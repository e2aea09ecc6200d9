package dev.twister.engine;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class RowSpreadTest {
    @ParameterizedTest
    @ValueSource(ints = {1, 2, 3, 4, 6, 34, 55, 720, 1080, 2160, 16_384})
    void everyRowComesOnce(int height) {
        JvmEngines.RowSpread rows = new JvmEngines.RowSpread(height);
        assertThat(IntStream.range(0, height).map(rows::row).sorted())
                .containsExactlyElementsOf(IntStream.range(0, height).boxed().toList());
    }

    @Test
    void everyPartHasRowsFromEverywhere() {
        JvmEngines.RowSpread rows = new JvmEngines.RowSpread(720);
        for (int part = 0; part < 8; part++) {
            int[] inEachEighth = new int[8];
            IntStream.range(90 * part, 90 * part + 90).forEach(index -> inEachEighth[rows.row(index) / 90]++);
            assertThat(IntStream.of(inEachEighth)).allMatch(count -> count >= 10 && count <= 13);
        }
    }
}
