package dev.twister.gui.edit;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.gui.property.PropertyNumbers;
import dev.twister.kernel.Layout;
import dev.twister.scene.Light;
import dev.twister.scene.Rgb;
import dev.twister.scene.Scene;
import dev.twister.scene.Sphere;
import dev.twister.scene.Vector3;
import dev.twister.scene.light.Lights;
import dev.twister.scene.property.SceneLimits;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;

class ThrownSpheresTest {
    private static Scene many(int count) {
        return Scenes.scene()
                .withSpheres(IntStream.range(0, count)
                        .mapToObj(index -> Sphere.of(
                                new Vector3(0, 0, 0), 0.1 + 0.01 * (index % 50), new Rgb(0.5, 0.5, 0.5), index % 100))
                        .toList());
    }

    @Test
    void noneIsInAnotherOrInThePlane() {
        assertAllAreClear(ThrownSpheres.of(many(300), 7));
    }

    @Test
    void aFewLargeOnesDoNotThrowTheSmallOnesBesideThePlane() {
        Scene mixed = withOneOf(4, many(2000));

        Scene thrown = ThrownSpheres.of(mixed, 7);

        assertAllAreClear(thrown);
        double half = thrown.ground().size() / 2;
        assertThat(thrown.spheres()).allSatisfy(sphere -> {
            assertThat(sphere.position().x()).isBetween(-half, half);
            assertThat(sphere.position().z()).isBetween(-half, half);
        });
    }

    @Test
    void spheresOfAllSizesAreClearOfALightOfAnySize() {
        Scene mixed = withOneOf(1, withOneOf(0.001, many(100)));
        for (double radius : new double[] {0.01, 0.5, 5}) {
            Light light = mixed.lights().first();
            assertAllAreClear(ThrownSpheres.of(mixed.withLights(Lights.of(light.withRadius(radius))), 7));
        }
    }

    @Test
    void noneIsWhereNoSceneCanHaveIt() {
        Scene huge = many(0).withSpheres(
                        Collections.nCopies(20, Sphere.of(new Vector3(0, 0, 0), 290_000, new Rgb(0.5, 0.5, 0.5), 0)));
        for (long seed = 0; seed < 20; seed++) {
            assertThat(ThrownSpheres.of(huge, seed).spheres()).allSatisfy(sphere -> {
                assertThat(SceneLimits.POSITION.contains(sphere.position().x())).isTrue();
                assertThat(SceneLimits.POSITION.contains(sphere.position().y())).isTrue();
                assertThat(SceneLimits.POSITION.contains(sphere.position().z())).isTrue();
            });
        }
    }

    private static Scene withOneOf(double radius, Scene scene) {
        List<Sphere> spheres = new ArrayList<>(scene.spheres());
        spheres.add(Sphere.of(new Vector3(0, 0, 0), radius, new Rgb(0.5, 0.5, 0.5), 0));
        return scene.withSpheres(spheres);
    }

    private static void assertAllAreClear(Scene thrown) {
        List<Sphere> spheres = thrown.spheres();
        Light light = thrown.lights().first();
        for (int i = 0; i < spheres.size(); i++) {
            Sphere sphere = spheres.get(i);
            assertThat(sphere.position().y())
                    .isGreaterThanOrEqualTo(thrown.ground().height() + sphere.radius());
            assertThat(distance(sphere.position(), light.position())).isGreaterThan(sphere.radius() + light.radius());
            for (int j = 0; j < i; j++) {
                assertThat(distance(sphere.position(), spheres.get(j).position()))
                        .isGreaterThan(sphere.radius() + spheres.get(j).radius());
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
            assertThat(is).isEqualTo(was.withPosition(is.position()));
        }
        assertThat(thrown.withSpheres(before.spheres())).isEqualTo(before);
    }

    @Test
    void aSceneThatWasEditedMeanwhileKeepsAllButThePlaces() {
        Scene before = many(20);
        Scene thrown = ThrownSpheres.of(before, 7);
        Scene colored = BodyMaterials.edited(before, Layout.FIRST_SPHERE, old -> old.withColor(new Rgb(0, 1, 0)));
        assertThat(ThrownSpheres.fit(thrown, colored)).isTrue();
        assertThat(ThrownSpheres.placed(thrown, colored))
                .isEqualTo(BodyMaterials.edited(thrown, Layout.FIRST_SPHERE, old -> old.withColor(new Rgb(0, 1, 0))));

        assertThat(ThrownSpheres.fit(thrown, many(21))).isFalse();
        Light light = before.lights().first();
        Light larger = light.withRadius(2 * light.radius());
        assertThat(ThrownSpheres.fit(thrown, before.withLights(Lights.of(larger))))
                .isFalse();
        assertThat(ThrownSpheres.fit(
                        thrown,
                        PropertyNumbers.ofBody(before, Layout.FIRST_SPHERE)
                                .getLast()
                                .write(before, 2)))
                .isFalse();
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
