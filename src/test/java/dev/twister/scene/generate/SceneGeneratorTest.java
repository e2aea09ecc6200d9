package dev.twister.scene.generate;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import dev.twister.scene.Scene;
import dev.twister.scene.SceneException;
import dev.twister.scene.Sphere;
import java.nio.file.Path;
import java.util.Comparator;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class SceneGeneratorTest {
    private static final Path SKYBOX = Path.of("skyboxes", "day.hdr");

    @ParameterizedTest
    @CsvSource({"1, 0", "2, 1", "3, 2", "100, 3", "1000, -5", "1001, 6", "10000, 7", "50000, 8"})
    void spheresLieOnOrOverThePlaneAndApart(int count, long seed) {
        Scene scene = SceneGenerator.spheres(count, seed, SKYBOX);

        assertThat(scene.spheres()).hasSize(count);
        double half = scene.ground().size() / 2;
        assertThat(scene.spheres()).allSatisfy(sphere -> {
            assertThat(sphere.position().y() - sphere.radius())
                    .isGreaterThanOrEqualTo(scene.ground().height());
            assertThat(Math.hypot(sphere.position().x(), sphere.position().z()) + sphere.radius())
                    .isLessThan(half);
        });
        assertThat(overlaps(scene.spheres())).isZero();
    }

    @Test
    void seedsDecide() {
        assertThat(SceneGenerator.spheres(50, 1, SKYBOX)).isEqualTo(SceneGenerator.spheres(50, 1, SKYBOX));
        assertThat(SceneGenerator.spheres(50, 1, SKYBOX)).isNotEqualTo(SceneGenerator.spheres(50, 2, SKYBOX));
        assertThat(SceneGenerator.spheres(5000, 1, SKYBOX)).isNotEqualTo(SceneGenerator.spheres(5000, 2, SKYBOX));
    }

    @Test
    void refusesACountOutOfRange() {
        assertThatThrownBy(() -> SceneGenerator.spheres(0, 1, SKYBOX))
                .isInstanceOf(SceneException.class)
                .hasMessage("the number of spheres is 0, but must be from 1 to 500000");
        assertThatThrownBy(() -> SceneGenerator.spheres(500_001, 1, SKYBOX)).isInstanceOf(SceneException.class);
    }

    // In x order, a sphere can touch only those that start before its end.
    private static int overlaps(List<Sphere> spheres) {
        List<Sphere> sorted = spheres.stream()
                .sorted(Comparator.comparingDouble(SceneGeneratorTest::start))
                .toList();
        int overlaps = 0;
        for (int i = 0; i < sorted.size(); i++) {
            Sphere one = sorted.get(i);
            double end = one.position().x() + one.radius();
            for (int j = i + 1; j < sorted.size() && start(sorted.get(j)) <= end; j++) {
                overlaps += distance(one, sorted.get(j))
                                <= one.radius() + sorted.get(j).radius()
                        ? 1
                        : 0;
            }
        }
        return overlaps;
    }

    private static double start(Sphere sphere) {
        return sphere.position().x() - sphere.radius();
    }

    private static double distance(Sphere one, Sphere other) {
        double x = one.position().x() - other.position().x();
        double y = one.position().y() - other.position().y();
        double z = one.position().z() - other.position().z();
        return Math.sqrt(x * x + y * y + z * z);
    }
}
