package dev.twister.gui.model;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.scene.Rgb;
import dev.twister.scene.Scene;
import dev.twister.scene.Sphere;
import dev.twister.scene.Vector3;
import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;

class ThrownSpheresTest {
    private static Scene many(int count) {
        return Scenes.scene()
                .withSpheres(IntStream.range(0, count)
                        .mapToObj(index -> new Sphere(
                                new Vector3(0, 0, 0), 0.1 + 0.01 * (index % 50), new Rgb(0.5, 0.5, 0.5), index % 100))
                        .toList());
    }

    @Test
    void noneIsInAnotherOrInThePlane() {
        Scene thrown = ThrownSpheres.of(many(300), 7);
        List<Sphere> spheres = thrown.spheres();
        for (int i = 0; i < spheres.size(); i++) {
            assertThat(spheres.get(i).position().y())
                    .isGreaterThanOrEqualTo(
                            thrown.plane().height() + spheres.get(i).radius());
            for (int j = 0; j < i; j++) {
                assertThat(distance(spheres.get(i).position(), spheres.get(j).position()))
                        .isGreaterThan(spheres.get(i).radius() + spheres.get(j).radius());
            }
        }
    }

    private static double distance(Vector3 a, Vector3 b) {
        return Math.sqrt(Math.pow(a.x() - b.x(), 2) + Math.pow(a.y() - b.y(), 2) + Math.pow(a.z() - b.z(), 2));
    }

    @Test
    void onlyThePlacesChange() {
        Scene before = many(20);
        Scene thrown = ThrownSpheres.of(before, 7);
        for (int i = 0; i < 20; i++) {
            Sphere was = before.spheres().get(i);
            Sphere is = thrown.spheres().get(i);
            assertThat(is).isEqualTo(new Sphere(is.position(), was.radius(), was.color(), was.reflectivity()));
        }
        assertThat(thrown.withSpheres(before.spheres())).isEqualTo(before);
    }

    @Test
    void aSeedGivesItsPlaces() {
        assertThat(ThrownSpheres.of(many(20), 7)).isEqualTo(ThrownSpheres.of(many(20), 7));
        assertThat(ThrownSpheres.of(many(20), 7)).isNotEqualTo(ThrownSpheres.of(many(20), 8));
    }

    @Test
    void noSpheresAreNoProblem() {
        assertThat(ThrownSpheres.of(many(0), 7)).isEqualTo(many(0));
    }
}
