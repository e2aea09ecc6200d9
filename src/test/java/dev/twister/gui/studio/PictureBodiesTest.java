package dev.twister.gui.studio;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.gui.edit.BodyNumber;
import dev.twister.kernel.Layout;
import dev.twister.scene.Mesh;
import dev.twister.scene.Rgb;
import dev.twister.scene.Scene;
import dev.twister.scene.Sphere;
import dev.twister.scene.Vector3;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;

class PictureBodiesTest {
    private static final Scene SCENE = Scene.under(Path.of("none.hdr"));
    private static final Sphere LEFT = sphere(-1);
    private static final Sphere RIGHT = sphere(1);
    private static final int FIRST = Layout.FIRST_SPHERE;

    @Test
    void aSphereKeepsItsNumberWhereNoneCameOrWent() {
        PictureBodies bodies = bodies(List.of(LEFT, RIGHT), List.of(LEFT, sphere(5)), false);
        assertThat(bodies.inScene(FIRST + 1)).isEqualTo(FIRST + 1);
        assertThat(bodies.inPicture(FIRST + 1)).isEqualTo(FIRST + 1);
    }

    @Test
    void afterADeletionEachIsTheSameSphere() {
        PictureBodies bodies = bodies(List.of(LEFT, RIGHT), List.of(RIGHT), true);
        assertThat(bodies.inScene(FIRST + 1)).isEqualTo(FIRST);
        assertThat(bodies.inPicture(FIRST)).isEqualTo(FIRST + 1);
        assertThat(bodies.inScene(FIRST)).isEqualTo(Layout.NOTHING);
    }

    @Test
    void whereAsManyCameAsWentEachIsTheSameSphereOrNone() {
        PictureBodies bodies = bodies(List.of(LEFT, RIGHT), List.of(RIGHT, sphere(5)), true);
        assertThat(bodies.inScene(FIRST)).isEqualTo(Layout.NOTHING);
        assertThat(bodies.inScene(FIRST + 1)).isEqualTo(FIRST);
        assertThat(bodies.inPicture(FIRST)).isEqualTo(FIRST + 1);
        assertThat(bodies.inPicture(FIRST + 1)).isEqualTo(Layout.NOTHING);
        PictureBodies replaced = bodies(List.of(LEFT, RIGHT), List.of(LEFT, sphere(5)), true);
        assertThat(replaced.inScene(FIRST)).isEqualTo(FIRST);
        assertThat(replaced.inScene(FIRST + 1)).isEqualTo(Layout.NOTHING);
    }

    @Test
    void whatIsNoSphereStaysWhatItIs() {
        PictureBodies bodies = bodies(List.of(LEFT, RIGHT), List.of(RIGHT), true);
        assertThat(bodies.inScene(BodyNumber.LIGHT)).isEqualTo(BodyNumber.LIGHT);
        assertThat(bodies.inScene(Layout.NOTHING)).isEqualTo(Layout.NOTHING);
    }

    @Test
    void whatWasPouredIsNoneOfTheScenes() {
        PictureBodies bodies = bodies(List.of(LEFT), List.of(LEFT, RIGHT), true);
        assertThat(bodies.inScene(FIRST + 5)).isEqualTo(Layout.NOTHING);
    }

    @Test
    void afterADeletionEachMeshIsTheSameOne() {
        Mesh knot = Mesh.of(Path.of("knot.obj"));
        Mesh vase = Mesh.of(Path.of("vase.obj"));
        PictureBodies bodies =
                new PictureBodies(SCENE.withMeshes(List.of(knot, vase)), SCENE.withMeshes(List.of(vase)), true);
        assertThat(bodies.inScene(BodyNumber.ofMesh(1))).isEqualTo(BodyNumber.ofMesh(0));
        assertThat(bodies.inPicture(BodyNumber.ofMesh(0))).isEqualTo(BodyNumber.ofMesh(1));
        assertThat(bodies.inScene(BodyNumber.ofMesh(0))).isEqualTo(Layout.NOTHING);
    }

    private static PictureBodies bodies(List<Sphere> pictured, List<Sphere> standing, boolean renumbered) {
        return new PictureBodies(SCENE.withSpheres(pictured), SCENE.withSpheres(standing), renumbered);
    }

    private static Sphere sphere(double x) {
        return Sphere.of(new Vector3(x, 0, 0), 0.5, new Rgb(1, 1, 1), 0);
    }
}
