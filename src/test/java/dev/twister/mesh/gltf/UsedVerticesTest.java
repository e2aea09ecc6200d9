package dev.twister.mesh.gltf;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class UsedVerticesTest {
    @ParameterizedTest
    @ValueSource(ints = {10, 1_000_000})
    void numbersTheVerticesInAscendingOrder(int listed) {
        UsedVertices used = new UsedVertices();
        used.set(new int[] {1, 2, 4, 8, 4, 2}, listed);

        used.set(new int[] {7, 3, 9, 3, 7, 0}, listed);

        assertThat(used.vertices()).containsExactly(0, 3, 7, 9);
        assertThat(Arrays.stream(used.vertices()).map(used::number)).containsExactly(0, 1, 2, 3);
    }
}
