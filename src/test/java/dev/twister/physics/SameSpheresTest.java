package dev.twister.physics;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.scene.Sphere;
import java.util.List;
import org.junit.jupiter.api.Test;

class SameSpheresTest {
    private static final Sphere A = at(1);
    private static final Sphere B = at(2);
    private static final Sphere C = at(3);
    private static final Sphere D = at(4);
    private static final Sphere NEW = at(5);

    private static Sphere at(double x) {
        return Motion.sphere(x, 1, 0, 0.5);
    }

    @Test
    void oneThatIsPutElsewhereKeepsItsNumber() {
        assertThat(SameSpheres.of(List.of(A, B, C), List.of(A, NEW, C))).containsExactly(0, 1, 2);
        assertThat(SameSpheres.byPlace(List.of(A, B, C), List.of(A, NEW, C))).containsExactly(0, SameSpheres.NONE, 2);
    }

    @Test
    void allThatArePutElsewhereKeepTheirNumbers() {
        assertThat(SameSpheres.of(List.of(A, B), List.of(C, D))).containsExactly(0, 1);
    }

    @Test
    void oneDeletedAndOneInsertedLeaveTheOthersThemselves() {
        assertThat(SameSpheres.of(List.of(A, B, C, D), List.of(A, C, D, NEW)))
                .containsExactly(0, 2, 3, SameSpheres.NONE);
    }

    @Test
    void twoDeletedAreTheOnlyOnesThatAreMissed() {
        assertThat(SameSpheres.of(List.of(A, B, C, D), List.of(B, D))).containsExactly(1, 3);
    }

    @Test
    void ofEqualPlacesEachIsOneSphere() {
        assertThat(SameSpheres.of(List.of(A, B, B, C), List.of(B, B, C, NEW)))
                .containsExactly(1, 2, 3, SameSpheres.NONE);
    }

    @Test
    void whereThereWereNoneNoneIsTheSame() {
        assertThat(SameSpheres.of(List.of(), List.of(A))).containsExactly(SameSpheres.NONE);
        assertThat(SameSpheres.of(List.of(A), List.of())).isEmpty();
    }
}
