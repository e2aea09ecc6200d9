package dev.twister.gui.model;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.scene.Scene;
import dev.twister.scene.Sphere;
import dev.twister.scene.Vector3;
import java.util.Collections;
import org.junit.jupiter.api.Test;

class BodyListTest {
    private final Scene scene = Scenes.scene();

    @Test
    void bodiesAreListedInTheirOrder() {
        assertThat(BodyList.of(scene, BodyNumber.NONE))
                .containsExactly(BodyNumber.NONE, BodyNumber.LIGHT, BodyNumber.PLANE, 2, 3);
        assertThat(BodyList.name(scene, 3)).isEqualTo("Sphere 2");
    }

    @Test
    void aCrowdIsNotListed() {
        Sphere sphere = scene.spheres().getFirst();
        Scene crowd = scene.withSpheres(Collections.nCopies(2000, sphere));

        assertThat(BodyList.of(crowd, 700)).containsExactly(BodyNumber.NONE, BodyNumber.LIGHT, BodyNumber.PLANE, 700);
    }

    @Test
    void aCopyStandsBesideItsOriginal() {
        Sphere sphere = scene.spheres().getFirst();

        Sphere copy = BodyEdits.beside(sphere);

        assertThat(copy.position()).isEqualTo(new Vector3(3.3000000000000003, 2, 0));
        assertThat(copy.withPosition(sphere.position())).isEqualTo(sphere);
    }
}
