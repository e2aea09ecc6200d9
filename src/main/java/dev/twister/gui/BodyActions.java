package dev.twister.gui;

import dev.twister.gui.model.BodyEdits;
import dev.twister.gui.model.BodyNumber;
import dev.twister.gui.model.NewSphere;
import dev.twister.gui.model.Orbit;
import dev.twister.scene.Sphere;
import dev.twister.scene.Vector3;
import java.util.Optional;

/** What the menu does with bodies. */
final class BodyActions {
    private final Studio studio;
    private Optional<Sphere> copied = Optional.empty();

    BodyActions(Studio studio) {
        this.studio = studio;
    }

    void insert() {
        studio.pictureProperty()
                .get()
                .ifPresent(shown -> insert("insert sphere", NewSphere.inFrontOf(shown.input(), studio.scene())));
    }

    /** Another sphere like the selected one, to the right of it. */
    void duplicate() {
        selected().ifPresent(sphere -> insert("duplicate sphere", BodyEdits.beside(sphere)));
    }

    void copy() {
        selected().ifPresent(sphere -> {
            copied = Optional.of(sphere);
            studio.notice("Copied a sphere");
        });
    }

    /** To the right of the sphere that was copied, or pasted before. */
    void paste() {
        copied.ifPresentOrElse(
                sphere -> {
                    Sphere pasted = BodyEdits.beside(sphere);
                    copied = Optional.of(pasted);
                    insert("paste sphere", pasted);
                },
                () -> studio.notice("No sphere has been copied"));
    }

    void delete() {
        int body = studio.selectionProperty().get();
        if (BodyEdits.isSphere(studio.scene(), body)) {
            studio.edit("delete sphere", scene -> BodyEdits.deleted(scene, body));
            studio.endGesture();
        }
    }

    void selectAlong(int steps) {
        studio.select(BodyEdits.along(studio.scene(), studio.selectionProperty().get(), steps));
    }

    /** Moves the camera so that the selected body fills the picture. */
    void frameSelected() {
        int body = studio.selectionProperty().get();
        if (BodyEdits.isMovable(studio.scene(), body)) {
            double radius = BodyEdits.radius(studio.scene(), body);
            Vector3 center = studio.positionNow(body);
            studio.moveCamera(camera -> Orbit.framed(camera, center, radius));
        } else {
            studio.notice("Select a sphere or the light to frame it");
        }
    }

    /** The selected sphere where it is now; says so where there is none. */
    private Optional<Sphere> selected() {
        int body = studio.selectionProperty().get();
        if (BodyEdits.isSphere(studio.scene(), body)) {
            return Optional.of(BodyEdits.sphere(studio.scene(), body).withPosition(studio.positionNow(body)));
        }
        studio.notice("Select a sphere to copy it");
        return Optional.empty();
    }

    private void insert(String what, Sphere sphere) {
        studio.edit(what, scene -> BodyEdits.inserted(scene, sphere));
        studio.endGesture();
        studio.select(BodyNumber.ofSphere(studio.scene().spheres().size() - 1));
    }
}
