package dev.twister.gui;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.kernel.Layout;
import dev.twister.scene.Rgb;
import dev.twister.scene.Sphere;
import dev.twister.scene.Vector3;
import java.util.List;
import org.junit.jupiter.api.Test;

class PictureBodiesTest {
    private static final Sphere LEFT = sphere(-1);
    private static final Sphere RIGHT = sphere(1);
    private static final int FIRST = Layout.FIRST_SPHERE;

    @Test
    void aSphereKeepsItsNumberWhereNoneCameOrWent() {
        PictureBodies bodies = new PictureBodies(List.of(LEFT, RIGHT), List.of(LEFT, sphere(5)), false);
        assertThat(bodies.inScene(FIRST + 1)).isEqualTo(FIRST + 1);
        assertThat(bodies.inPicture(FIRST + 1)).isEqualTo(FIRST + 1);
    }

    @Test
    void afterADeletionEachIsTheSameSphere() {
        PictureBodies bodies = new PictureBodies(List.of(LEFT, RIGHT), List.of(RIGHT), true);
        assertThat(bodies.inScene(FIRST + 1)).isEqualTo(FIRST);
        assertThat(bodies.inPicture(FIRST)).isEqualTo(FIRST + 1);
        assertThat(bodies.inScene(FIRST)).isEqualTo(Layout.NOTHING);
    }

    @Test
    void whereAsManyCameAsWentEachIsTheSameSphereOrNone() {
        PictureBodies bodies = new PictureBodies(List.of(LEFT, RIGHT), List.of(RIGHT, sphere(5)), true);
        assertThat(bodies.inScene(FIRST)).isEqualTo(Layout.NOTHING);
        assertThat(bodies.inScene(FIRST + 1)).isEqualTo(FIRST);
        assertThat(bodies.inPicture(FIRST)).isEqualTo(FIRST + 1);
        assertThat(bodies.inPicture(FIRST + 1)).isEqualTo(Layout.NOTHING);
        PictureBodies replaced = new PictureBodies(List.of(LEFT, RIGHT), List.of(LEFT, sphere(5)), true);
        assertThat(replaced.inScene(FIRST)).isEqualTo(FIRST);
        assertThat(replaced.inScene(FIRST + 1)).isEqualTo(Layout.NOTHING);
    }

    @Test
    void whatIsNoSphereStaysWhatItIs() {
        PictureBodies bodies = new PictureBodies(List.of(LEFT, RIGHT), List.of(RIGHT), true);
        assertThat(bodies.inScene(Layout.LIGHT)).isEqualTo(Layout.LIGHT);
        assertThat(bodies.inScene(Layout.NOTHING)).isEqualTo(Layout.NOTHING);
    }

    @Test
    void whatWasPouredIsNoneOfTheScenes() {
        PictureBodies bodies = new PictureBodies(List.of(LEFT), List.of(LEFT, RIGHT), true);
        assertThat(bodies.inScene(FIRST + 5)).isEqualTo(Layout.NOTHING);
    }

    private static Sphere sphere(double x) {
        return Sphere.of(new Vector3(x, 0, 0), 0.5, new Rgb(1, 1, 1), 0);
    }
}
