package dev.twister.gui.studio;

import dev.twister.gui.drawing.DrawnPicture;
import dev.twister.gui.edit.BodyEdits;
import dev.twister.gui.edit.BodyExtent;
import dev.twister.gui.edit.BodyNumber;
import dev.twister.gui.edit.SelectedBodies;
import dev.twister.scene.Material;
import dev.twister.scene.Mesh;
import dev.twister.scene.Scene;
import dev.twister.scene.Vector3;
import dev.twister.world.SceneMeshes;
import java.util.Optional;
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
}
