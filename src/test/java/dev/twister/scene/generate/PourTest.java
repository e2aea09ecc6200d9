package dev.twister.scene.generate;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.scene.Scene;
import dev.twister.scene.Sphere;
import dev.twister.scene.Vector3;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class PourTest {
    @Test
    void spheresStartInTheSpout() {
        Pour pour = pour(500, 1, 1.5);
        assertThat(pour.spheres()).hasSize(500).allSatisfy(sphere -> {
            assertThat(Math.hypot(sphere.position().x() - 3, sphere.position().z() - 5))
                    .isLessThanOrEqualTo(0.75);
            assertThat(sphere.position().y()).isEqualTo(4);
            assertThat(sphere.radius()).isBetween(0.05, 0.1);
            assertThat(sphere.reflectivity()).isEqualTo(20);
        });
    }

    @Test
    void seedsDecide() {
        assertThat(pour(50, 1, 1).spheres()).isEqualTo(pour(50, 1, 1).spheres());
        assertThat(pour(50, 1, 1).spheres()).isNotEqualTo(pour(50, 2, 1).spheres());
    }

    @ParameterizedTest
    @CsvSource({"0.01, 1", "0.5, 1", "1, 3", "2, 4"})
    void spheresAtTheHighestRateDoNotTouch(double width, int seed) {
        Pour pour = pour(600, seed, width);
        List<Sphere> spheres = pour.spheres();
        double interval = 1 / pour.maxRate();
        // Gravity only separates the spheres further, so the spout's speed alone is enough.
        for (int late = 1; late < spheres.size(); late++) {
            for (int early = 0; early < late; early++) {
                Vector3 one = spheres.get(early).position();
                Vector3 other = spheres.get(late).position();
                double fallen = (late - early) * interval * pour.speed();
                double across = Math.hypot(one.x() - other.x(), one.z() - other.z());
                assertThat(Math.hypot(across, fallen))
                        .isGreaterThanOrEqualTo(
                                (spheres.get(early).radius() + spheres.get(late).radius()) * (1 - 1e-9));
            }
        }
    }

    @Test
    void poursAreAfterThePlacedSpheres() {
        Scene placed = SceneGenerator.spheres(3, 1, Path.of("sky.hdr"));
        Pour pour = pour(4, 1, 1);
        List<Sphere> all = placed.withPour(pour).allSpheres();
        assertThat(all).hasSize(7).startsWith(placed.spheres().toArray(Sphere[]::new));
        assertThat(all).endsWith(pour.spheres().toArray(Sphere[]::new));
        assertThat(placed.allSpheres()).isEqualTo(placed.spheres());
    }

    private static Pour pour(int count, int seed, double width) {
        return Pour.DEFAULT
                .withCount(count)
                .withRate(1)
                .withPosition(new Vector3(3, 4, 5))
                .withWidth(width)
                .withSpeed(2)
                .withRadii(0.05, 0.1)
                .withReflectivity(20)
                .withSeed(seed);
    }
}
