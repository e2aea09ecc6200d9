package dev.twister.gui;

import dev.twister.gui.model.BodyEdits;
import dev.twister.gui.model.BodyExtent;
import dev.twister.gui.model.NewSphere;
import dev.twister.gui.model.Orbit;
import dev.twister.gui.model.Solid;
import java.util.Optional;

/** What the menu does with bodies. */
final class BodyActions {
    private final Studio studio;
    private Optional<Copied> copied = Optional.empty();

    /**
     * A body, and how far beside it another one does not touch it.
     *
     * @param apart in meters
     */
    private record Copied(Solid body, double apart) {
        Copied beside() {
            return new Copied(body.beside(apart), apart);
        }
    }

    BodyActions(Studio studio) {
        this.studio = studio;
    }

    void insert() {
        studio.pictureProperty()
                .get()
                .ifPresent(shown ->
                        insert("insert", new Solid.OfSphere(NewSphere.inFrontOf(shown.input(), studio.scene()))));
    }

    /** Another body like the selected one, to the right of it. */
    void duplicate() {
        selected().ifPresent(original -> insert("duplicate", original.beside().body()));
    }

    void copy() {
        selected().ifPresent(original -> {
            copied = Optional.of(original);
            studio.notice("Copied a " + original.body().kind());
        });
    }

    /** To the right of the body that was copied, or pasted before. */
    void paste() {
        copied.ifPresentOrElse(
                original -> {
                    Copied pasted = original.beside();
                    copied = Optional.of(pasted);
                    insert("paste", pasted.body());
                },
                () -> studio.notice("Nothing has been copied"));
    }

    void delete() {
        int body = studio.selectionProperty().get();
        if (BodyEdits.isSolid(studio.scene(), body)) {
            String kind = BodyEdits.solid(studio.scene(), body).kind();
            studio.edit("delete " + kind, scene -> BodyEdits.deleted(scene, body));
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
            BodyExtent extent = studio.extentNow(body);
            studio.moveCamera(camera -> Orbit.framed(camera, extent.middle(), extent.radius()));
        } else {
            studio.notice("Select a sphere, a mesh or the light to frame it");
        }
    }

    /** The selected sphere or mesh where it is now; says so where there is none. */
    private Optional<Copied> selected() {
        int body = studio.selectionProperty().get();
        if (BodyEdits.isSolid(studio.scene(), body)) {
            Solid standing = BodyEdits.solid(studio.scene(), body);
            return Optional.of(new Copied(
                    standing.withPosition(studio.positionNow(body)),
                    studio.extentNow(body).apart()));
        }
        studio.notice("Select a sphere or a mesh to copy it");
        return Optional.empty();
    }

    private void insert(String what, Solid body) {
        studio.insert(what + " " + body.kind(), body);
    }
}
