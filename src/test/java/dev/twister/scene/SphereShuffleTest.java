package dev.twister.scene;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class SphereShuffleTest {
    @ParameterizedTest
    @CsvSource({"1, 0", "60, 1", "1500, 2"})
    void spheresLieOverThePlaneAndApart(int count, long seed) {
        Scene scene = SceneGenerator.spheres(count, 5, Path.of("sky.hdr"));
        Scene shuffled = SphereShuffle.of(scene, seed);

        assertThat(shuffled.withSpheres(List.of())).isEqualTo(scene.withSpheres(List.of()));
        assertThat(shuffled.spheres()).hasSize(count).isNotEqualTo(scene.spheres());
        double half = scene.plane().size() / 2;
        for (int i = 0; i < count; i++) {
            Sphere one = shuffled.spheres().get(i);
            assertThat(one.radius()).isEqualTo(scene.spheres().get(i).radius());
            assertThat(one.color()).isEqualTo(scene.spheres().get(i).color());
            assertThat(Math.abs(one.position().x()) + one.radius()).isLessThanOrEqualTo(half);
            assertThat(Math.abs(one.position().z()) + one.radius()).isLessThanOrEqualTo(half);
            assertThat(one.position().y() - one.radius())
                    .isGreaterThanOrEqualTo(scene.plane().height());
            assertThat(distance(one.position(), scene.light().position()))
                    .isGreaterThan(one.radius() + scene.light().radius());
            for (int j = 0; j < i; j++) {
                Sphere other = shuffled.spheres().get(j);
                assertThat(distance(one.position(), other.position())).isGreaterThan(one.radius() + other.radius());
            }
        }
        assertThat(SphereShuffle.of(scene, seed)).isEqualTo(shuffled);
        assertThat(SphereShuffle.of(scene, seed + 1)).isNotEqualTo(shuffled);
    }

    private static double distance(Vector3 one, Vector3 other) {
        double x = one.x() - other.x();
        double y = one.y() - other.y();
        double z = one.z() - other.z();
        return Math.sqrt(x * x + y * y + z * z);
    }
}
