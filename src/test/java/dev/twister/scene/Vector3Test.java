package dev.twister.scene;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.scene.property.Range;
import org.junit.jupiter.api.Test;

class Vector3Test {
    private static final Vector3 ONE = new Vector3(1, -2, 3);
    private static final Vector3 OTHER = new Vector3(0.5, 4, -1);

    @Test
    void addsSubtractsAndScales() {
        assertThat(ONE.plus(OTHER)).isEqualTo(new Vector3(1.5, 2, 2));
        assertThat(ONE.minus(OTHER)).isEqualTo(new Vector3(0.5, -6, 4));
        assertThat(ONE.times(-2)).isEqualTo(new Vector3(-2, 4, -6));
    }

    @Test
    void dotProductIsTheSumOfTheProducts() {
        assertThat(ONE.dot(OTHER)).isEqualTo(-10.5);
    }

    @Test
    void crossProductIsRightHanded() {
        assertThat(new Vector3(1, 0, 0).cross(new Vector3(0, 1, 0))).isEqualTo(new Vector3(0, 0, 1));
        assertThat(ONE.cross(OTHER)).isEqualTo(new Vector3(-10, 2.5, 5));
    }

    @Test
    void lengthIsEuclidean() {
        assertThat(new Vector3(2, -3, 6).length()).isEqualTo(7);
        assertThat(new Vector3(0, -4, 3).normalized()).isEqualTo(new Vector3(0, -0.8, 0.6));
    }

    @Test
    void mapsEachCoordinate() {
        assertThat(ONE.map(Math::abs)).isEqualTo(new Vector3(1, 2, 3));
        assertThat(ONE.map(OTHER, Math::min)).isEqualTo(new Vector3(0.5, -2, -1));
        assertThat(new Range(-1, 1).clamp(ONE)).isEqualTo(new Vector3(1, -1, 1));
    }
}
