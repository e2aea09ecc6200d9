package dev.twister.gui.picking;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import dev.twister.gui.edit.BodyExtent;
import dev.twister.gui.edit.BodyNumber;
import dev.twister.gui.edit.Scenes;
import dev.twister.scene.Body;
import dev.twister.scene.Camera;
import dev.twister.scene.Light;
import dev.twister.scene.Mesh;
import dev.twister.scene.Rgb;
import dev.twister.scene.Scene;
import dev.twister.scene.Shape;
import dev.twister.scene.Sphere;
import dev.twister.scene.Vector3;
import dev.twister.scene.light.LightShape;
import dev.twister.world.FrameInput;
import dev.twister.world.SceneImages;
import dev.twister.world.SceneMeshes;
import dev.twister.world.World;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Where new bodies stand. */
class FreePlaceTest {
    private static final Vector3 EYE = new Vector3(0, 4, -10);

    private final Scene scene = Scenes.scene();

    /** Only the plane, seen from a bit above. */
    private static Scene empty(double yaw, double pitch) {
        return Scenes.scene().withSpheres(List.of()).withCamera(Camera.of(EYE, yaw, pitch, 60));
    }

    private static SceneMeshes meshes(Scene scene) {
        return SceneMeshes.read(scene, _ -> {});
    }

    private static FrameInput picture(Scene scene) {
        return World.of(scene, SceneImages.of(Scenes.SKY), meshes(scene)).snapshot();
    }

    private static Sphere sphere(Scene scene) {
        return NewBodies.sphere(picture(scene), scene, meshes(scene));
    }

    private static Scene with(Scene scene, Body body) {
        return scene.withBodies(scene.bodies().with(List.of(body)));
    }

    private static boolean isSeen(Scene scene, Vector3 place, int body) {
        double[] pixel = Projection.of(picture(scene)).point(place);
        return pixel[0] >= 0
                && pixel[0] <= Scenes.WIDTH
                && pixel[1] >= 0
                && pixel[1] <= Scenes.HEIGHT
                && PointerRay.bodyAt(picture(scene), pixel[0], pixel[1]) == body;
    }

    /** Whether the boxes around two upright shapes have a point in common. */
    private static boolean meet(Vector3 one, Vector3 other, Vector3 size) {
        return Math.abs(one.x() - other.x()) < size.x()
                && Math.abs(one.y() - other.y()) < size.y()
                && Math.abs(one.z() - other.z()) < size.z();
    }

    @Test
    void aSphereStandsWhereTheCameraLooksOnTheGround() {
        Scene down = empty(0, 20);
        Vector3 place = sphere(down).position();
        assertThat(place.y()).isEqualTo(1.5);
        assertThat(place.x()).isCloseTo(0, within(1e-4));
        assertThat(place.z()).isCloseTo(-10 + 4 / Math.tan(Math.toRadians(20)), within(1e-3));
    }

    @Test
    void aFarGroundInViewIsNotWalkedTo() {
        Scene ahead = empty(0, 3);
        Vector3 place = sphere(ahead).position();
        assertThat(place.minus(EYE).length()).isCloseTo(15, within(0.5));
    }

    @Test
    void fromHighAboveASphereStandsInTheMiddleOfThePicture() {
        Scene high = empty(0, 0).withCamera(Camera.of(new Vector3(0, 60, -60), 0, 45, 40));
        assertThat(sphere(high).position().minus(new Vector3(0, 1.5, 0)).length())
                .isCloseTo(0, within(1e-2));
    }

    @ParameterizedTest
    @ValueSource(doubles = {0, 40, -130})
    void spheresStandInARowAcrossThePicture(double yaw) {
        Scene edited = empty(yaw, 15);
        double turn = Math.toRadians(yaw);
        Vector3 first = sphere(edited).position();
        for (int number = 0; number < 3; number++) {
            Sphere added = sphere(edited);
            edited = with(edited, added);
            Vector3 way = added.position().minus(first);
            assertThat(way.x() * Math.sin(turn) + way.z() * Math.cos(turn)).isCloseTo(0, within(1e-3));
            assertThat(way.length()).isCloseTo(number == 0 ? 0 : 3.2, within(1e-3));
            assertThat(isSeen(edited, added.position(), 2 + number)).isTrue();
        }
        assertThat(edited.spheres().get(1).position())
                .isNotEqualTo(edited.spheres().get(2).position());
    }

    @Test
    void spheresStandBesideThoseThatThePictureDoesNotShowYet() {
        Scene edited = empty(0, 15);
        FrameInput before = picture(edited);
        for (int number = 0; number < 5; number++) {
            edited = with(edited, NewBodies.sphere(before, edited, SceneMeshes.NONE));
        }
        for (Sphere sphere : edited.spheres()) {
            assertThat(sphere.position().y()).isEqualTo(1.5);
            assertThat(edited.spheres())
                    .filteredOn(other -> !other.equals(sphere))
                    .allMatch(other -> other.position().minus(sphere.position()).length() >= 3);
        }
    }

    @ParameterizedTest
    @EnumSource(Shape.Kind.class)
    void shapesStandBesideEachOther(Shape.Kind kind) {
        Scene before = empty(40, 15);
        Scene one = with(before, NewBodies.mesh(picture(before), before, meshes(before), kind));
        Scene two = with(one, NewBodies.mesh(picture(one), one, meshes(one), kind));
        Vector3 size = Shape.of(kind, 3).size();
        Vector3 first = two.meshes().getFirst().position();
        Vector3 second = two.meshes().getLast().position();
        assertThat(List.of(first.y(), second.y())).containsOnly(size.y() / 2);
        assertThat(meet(first, second, size)).isFalse();
        assertThat(second.minus(first).length()).isLessThan(6);
        double[] pixel = Projection.of(picture(two)).point(second);
        assertThat(pixel[0]).isBetween(0.0, (double) Scenes.WIDTH);
    }

    @Test
    void aMeshFileStandsBesideAShapeOfItsSize() {
        Scene before = empty(0, 15);
        Scene one = with(before, NewBodies.mesh(picture(before), before, meshes(before), Shape.Kind.BOX));
        Mesh cube = one.meshes().getFirst();
        BodyExtent bounds = BodyExtent.of(one, meshes(one), BodyNumber.ofMesh(0))
                .movedBy(cube.position().times(-1));
        Vector3 second =
                NewBodies.mesh(picture(one), one, meshes(one), cube, bounds).position();
        assertThat(meet(cube.position(), second, new Vector3(3, 3, 3))).isFalse();
        assertThat(second.y()).isCloseTo(1.5, within(1e-6));
    }

    @Test
    void lightsHangBesideEachOtherOverNewBodies() {
        Scene before = with(empty(0, 15), sphere(empty(0, 15)));
        Light first = NewBodies.light(picture(before), before, SceneMeshes.NONE, LightShape.Kind.SPHERE);
        Scene one = before.withLights(before.lights().with(List.of(first)));
        Light second = NewBodies.light(picture(one), one, SceneMeshes.NONE, LightShape.Kind.SPHERE);
        Vector3 sphere = before.spheres().getFirst().position();
        assertThat(first.position().x()).isEqualTo(sphere.x());
        assertThat(first.position().z()).isEqualTo(sphere.z());
        assertThat(Stream.of(first, second).map(light -> light.position().y())).containsOnly(3.5);
        assertThat(second.position().minus(first.position()).length()).isBetween(0.5, 2.0);
    }

    @Test
    void aSphereStandsBesideASmallBodyAndBeforeALargeOne() {
        Vector3 beside = sphere(scene).position();
        assertThat(beside.z()).isCloseTo(0, within(1e-4));
        assertThat(beside.x()).isCloseTo(3.2, within(1e-4));
        Scene large = scene.withSpheres(List.of(Sphere.of(new Vector3(0, 8, 8), 8, new Rgb(1, 1, 1), 0)));
        Vector3 before = sphere(large).position();
        assertThat(before.minus(new Vector3(0, 8, 8)).length()).isGreaterThan(9.5);
        assertThat(isSeen(with(large, sphere(large)), before, 3)).isTrue();
    }

    @Test
    void inARoomSpheresStandBesideEachOther() {
        Scene room = with(empty(0, 15), Sphere.of(Vector3.ZERO, 500, new Rgb(1, 1, 1), 0));
        Sphere first = sphere(room);
        Vector3 second = sphere(with(room, first)).position();
        assertThat(second.minus(first.position()).length()).isGreaterThan(3);
    }

    @Test
    void whereThePictureIsFullSpheresStandOutOfItsSightRatherThanInEachOther() {
        Scene full = empty(0, 15).withCamera(Camera.of(new Vector3(0, 2, -4), 0, 15, 60));
        for (int number = 0; number < 4; number++) {
            full = with(full, sphere(full));
        }
        for (Sphere sphere : full.spheres()) {
            assertThat(full.spheres())
                    .filteredOn(other -> !other.equals(sphere))
                    .allMatch(other -> other.position().minus(sphere.position()).length() > 3);
        }
    }

    @Test
    void aSphereIsNotAroundTheCamera() {
        Scene near = scene.withCamera(Camera.of(new Vector3(0, 2, -1.6), 0, 0, 60));
        Vector3 place = sphere(near).position();
        assertThat(place.minus(new Vector3(0, 2, -1.6)).length()).isGreaterThan(1.5);
    }

    @Test
    void aSphereInTheSkyIsAtHand() {
        Scene up = scene.withCamera(Camera.of(new Vector3(0, 2, -10), 180, -30, 60));
        Vector3 place = sphere(up).position();
        assertThat(Math.hypot(place.y() - 2, place.z() + 10)).isCloseTo(15, within(1e-4));
    }
}
