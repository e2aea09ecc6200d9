package dev.twister.gui.studio;

import dev.twister.gui.drawing.DrawingRequest.Motion;
import dev.twister.gui.drawing.DrawnPicture;
import dev.twister.gui.edit.BodyEdits;
import dev.twister.gui.edit.BodyExtent;
import dev.twister.gui.edit.BodyNumber;
import dev.twister.gui.edit.SelectedBodies;
import dev.twister.physics.SameSpheres;
import dev.twister.scene.Material;
import dev.twister.scene.Mesh;
import dev.twister.scene.Scene;
import dev.twister.scene.Sphere;
import dev.twister.scene.Vector3;
import dev.twister.scene.property.SceneLimits;
import dev.twister.world.Bodies;
import dev.twister.world.SceneMeshes;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.UnaryOperator;
import javafx.beans.value.ObservableValue;

/** Where the scene's bodies are in the picture that is shown, in which physics may have moved them. */
public final class PresentBodies {
    private final Document document;
    private final MotionControl motion;
    private final ObservableValue<Optional<DrawnPicture>> picture;

    PresentBodies(Document document, MotionControl motion, ObservableValue<Optional<DrawnPicture>> picture) {
        this.document = document;
        this.motion = motion;
        this.picture = picture;
    }

    /** The scene with its spheres at their displayed places. */
    public Scene scene() {
        return motion.isOn() ? moved().asSeen() : document.scene();
    }

    MovedScene moved() {
        return MovedScene.of(document.scene(), motion.motionProperty().get(), picture.getValue());
    }

    /** The center of a movable body. */
    public Vector3 position(int body) {
        return BodyEdits.isSphere(document.scene(), body)
                ? moved().position(BodyNumber.sphere(body))
                : BodyEdits.position(document.scene(), body);
    }

    /** The bounds of a movable body. */
    public BodyExtent extent(int body) {
        Vector3 standing = BodyEdits.position(document.scene(), body);
        Vector3 now = position(body);
        return BodyExtent.of(document.scene(), meshes(), body).movedBy(now.minus(standing));
    }

    /** The bounds of all movable ones of several bodies; empty if there are none. */
    public Optional<BodyExtent> extent(SelectedBodies several) {
        Scene now = scene();
        return Optional.of(several.bodies().stream()
                        .filter(body -> BodyEdits.isMovable(document.scene(), body))
                        .map(body -> BodyExtent.of(now, meshes(), body))
                        .toList())
                .filter(extents -> !extents.isEmpty())
                .map(BodyExtent::of);
    }

    /** The material in a mesh's file; the default until the file has been read. */
    public Material fileMaterial(int body) {
        Mesh mesh = BodyEdits.mesh(document.scene(), body);
        return meshes().holds(mesh) ? meshes().fileMaterial(mesh) : Material.DEFAULT;
    }

    /** The meshes of the picture. */
    public SceneMeshes meshes() {
        return picture.getValue().map(DrawnPicture::meshes).orElse(SceneMeshes.NONE);
    }

    /**
     * A scene whose spheres may have been moved by physics.
     *
     * @param standing the scene with its spheres at their initial places
     * @param seen the picture that shows their present places; empty if they have not moved
     */
    record MovedScene(Scene standing, Optional<DrawnPicture> seen) {
        /**
         * An edit of moving bodies.
         *
         * @param before the scene that undo restores: a sphere that the edit moves is at its displayed place
         * @param after the edited scene: all other spheres keep their initial places
         */
        record Edit(Scene before, Scene after) {}

        /** The scene as a picture shows it; unmoved if physics is off or the picture is of another start. */
        static MovedScene of(Scene scene, Motion motion, Optional<DrawnPicture> picture) {
            return new MovedScene(
                    scene,
                    picture.filter(
                            shown -> motion.isOn() && shown.request().motion().start() == motion.start()));
        }

        /** The position of a sphere, by its index. */
        Vector3 position(int index) {
            int[] same = sameInPicture();
            return position(same, index);
        }

        /** The scene with its spheres at their present places. */
        Scene asSeen() {
            return standing.withSpheres(spheresAsSeen());
        }

        private List<Sphere> spheresAsSeen() {
            List<Sphere> stand = standing.spheres();
            int[] same = sameInPicture();
            List<Sphere> moved = new ArrayList<>(stand.size());
            for (int index = 0; index < stand.size(); index++) {
                moved.add(at(position(same, index), stand.get(index)));
            }
            return moved;
        }

        /** Edits the scene as it is seen. */
        Edit edit(UnaryOperator<Scene> change) {
            List<Sphere> stand = standing.spheres();
            List<Sphere> moved = spheresAsSeen();
            Scene edited = change.apply(standing.withSpheres(moved));
            int[] old = SameSpheres.of(moved, edited.spheres());
            List<Sphere> before = new ArrayList<>(stand);
            List<Sphere> after = new ArrayList<>(edited.spheres());
            for (int index = 0; index < old.length; index++) {
                int number = old[index];
                if (number != SameSpheres.NONE) {
                    Vector3 place = moved.get(number).position();
                    if (place.equals(after.get(index).position())) {
                        after.set(index, at(stand.get(number).position(), after.get(index)));
                    } else {
                        before.set(number, at(place, stand.get(number)));
                    }
                }
            }
            return new Edit(standing.withSpheres(before), edited.withSpheres(after));
        }

        /** For each sphere its index in the picture's scene. */
        private int[] sameInPicture() {
            return seen.map(shown -> SameSpheres.of(shown.request().scene().spheres(), standing.spheres()))
                    .orElseGet(() -> new int[0]);
        }

        private Vector3 position(int[] same, int index) {
            Vector3 start = standing.spheres().get(index).position();
            return seen.filter(shown -> same[index] != SameSpheres.NONE
                            // A sphere that was edited since then is at its new place.
                            && shown.request()
                                    .scene()
                                    .spheres()
                                    .get(same[index])
                                    .position()
                                    .equals(start))
                    .map(shown -> place(shown.input().bodies(), BodyNumber.ofSphere(same[index])))
                    .orElse(start);
        }

        private static Vector3 place(Bodies bodies, int body) {
            return SceneLimits.POSITION.clamp(bodies.centerInScene(body));
        }

        private static Sphere at(Vector3 place, Sphere sphere) {
            return sphere.withPosition(place);
        }
    }
}
