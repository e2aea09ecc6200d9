package dev.twister.gui.bodies;

import dev.twister.gui.controls.Problems;
import dev.twister.gui.model.BodyEdits;
import dev.twister.gui.model.BodyGroup;
import dev.twister.gui.model.DroppedBodies;
import dev.twister.gui.model.NewLight;
import dev.twister.gui.model.NewMesh;
import dev.twister.gui.model.NewSphere;
import dev.twister.gui.model.Orbit;
import dev.twister.gui.model.SelectedBodies;
import dev.twister.gui.model.TagEdits;
import dev.twister.gui.model.ThrownSpheres;
import dev.twister.gui.studio.Errands;
import dev.twister.gui.studio.Selection;
import dev.twister.gui.studio.Studio;
import dev.twister.scene.Light;
import dev.twister.scene.Mesh;
import dev.twister.scene.Scene;
import dev.twister.scene.Shape;
import dev.twister.scene.Sphere;
import dev.twister.scene.property.SceneLimits;
import java.util.List;
import java.util.Optional;

/** The menu's actions on bodies. */
public final class BodyActions {
    public static final String UNDELETED_LIGHT = "The last light can't be deleted; a scene has at least one";

    private final Studio studio;
    private final Errands errands;
    private Optional<BodyGroup> copied = Optional.empty();

    public BodyActions(Studio studio, Errands errands) {
        this.studio = studio;
        this.errands = errands;
    }

    public void insert() {
        studio.pictureProperty().get().ifPresent(shown -> {
            Sphere sphere = NewSphere.inFrontOf(shown.input(), studio.bodies().scene(), shown.meshes());
            studio.insert("insert sphere", List.of(sphere), List.of());
        });
    }

    public void insert(Shape.Kind kind) {
        studio.pictureProperty().get().ifPresent(shown -> {
            Mesh mesh = NewMesh.inFrontOf(shown.input(), studio.bodies().scene(), shown.meshes(), kind);
            studio.insert("insert " + mesh.geometry().name(), List.of(mesh), List.of());
        });
    }

    public void insertLight() {
        studio.pictureProperty().get().filter(_ -> hasRoomFor(1)).ifPresent(shown -> {
            Light light = NewLight.over(shown.input(), studio.bodies().scene(), shown.meshes());
            studio.insert("insert light", List.of(), List.of(light));
        });
    }

    /** Adds copies of the selected bodies, to the right of them. */
    public void duplicate() {
        selected().ifPresent(originals -> {
            insert("duplicate", originals.beside());
        });
    }

    public void copy() {
        selected().ifPresent(originals -> {
            copied = Optional.of(originals);
            studio.notice("Copied " + (originals.count() == 1 ? "a " : "") + originals.kind());
        });
    }

    /** Adds the copied bodies, to the right of the originals or of the last pasted ones. */
    public void paste() {
        copied.ifPresentOrElse(
                originals -> {
                    BodyGroup pasted = originals.beside();
                    copied = Optional.of(pasted);
                    insert("paste", pasted);
                },
                () -> studio.notice("Nothing has been copied"));
    }

    /** Puts the selected spheres and meshes on the ground. */
    public void drop() {
        SelectedBodies selected = studio.selection().bodies();
        if (selected.where(body -> BodyEdits.isSolid(studio.scene(), body)).count() == 0) {
            studio.notice("Select a sphere or a mesh to put it on the ground");
        } else {
            studio.edit(
                    "drop to the ground",
                    scene -> DroppedBodies.of(scene, studio.bodies().meshes(), selected.bodies()));
            studio.endGesture();
        }
    }

    public void delete() {
        Scene standing = studio.scene();
        SelectedBodies selected = studio.selection().bodies();
        SelectedBodies deleted = BodyEdits.deletable(standing, selected);
        if (deleted.count() > 0) {
            String what =
                    deleted.count() == 1 ? BodyEdits.kind(standing, deleted.active()) : deleted.count() + " bodies";
            studio.edit("delete " + what, scene -> BodyEdits.deleted(scene, deleted.bodies()));
            studio.endGesture();
            if (deleted.count() < selected.count()) {
                boolean locked = selected.bodies().stream()
                        .anyMatch(body -> TagEdits.of(standing, body).locked());
                studio.notice(locked ? "Locked bodies stay" : UNDELETED_LIGHT);
            }
        }
    }

    public void selectAlong(int steps) {
        Selection selection = studio.selection();
        selection.select(BodyEdits.along(studio.scene(), selection.active(), steps));
    }

    /** Moves the camera so that the selected bodies fill the picture. */
    public void frameSelected() {
        studio.bodies()
                .extent(studio.selection().bodies())
                .ifPresentOrElse(
                        extent -> studio.moveCamera(camera -> Orbit.framed(camera, extent.middle(), extent.radius())),
                        () -> studio.notice("Select a sphere, a mesh or a light to frame it"));
    }

    /** The selected spheres, meshes and lights where they are now; tells it if there are none. */
    private Optional<BodyGroup> selected() {
        Scene now = studio.bodies().scene();
        SelectedBodies movable = studio.selection().bodies().where(body -> BodyEdits.isMovable(now, body));
        if (movable.count() == 0) {
            studio.notice("Select a sphere, a mesh or a light to copy it");
            return Optional.empty();
        }
        return Optional.of(new BodyGroup(
                movable.bodies().stream()
                        .filter(body -> BodyEdits.isSolid(now, body))
                        .map(body -> BodyEdits.solid(now, body))
                        .toList(),
                movable.bodies().stream()
                        .filter(body -> BodyEdits.isLight(now, body))
                        .map(body -> BodyEdits.light(now, body))
                        .toList(),
                studio.bodies().extent(movable).orElseThrow().apart()));
    }

    private void insert(String what, BodyGroup group) {
        if (hasRoomFor(group.lights().size())) {
            studio.insert(what + " " + group.kind(), group.bodies(), group.lights());
        }
    }

    /** Whether the scene may have this number of lights more; reports it if not. */
    private boolean hasRoomFor(int lights) {
        boolean room = studio.scene().lights().count() + lights <= SceneLimits.MAX_LIGHTS;
        if (!room) {
            studio.notice("A scene has at most " + SceneLimits.MAX_LIGHTS + " lights");
        }
        return room;
    }

    /** Throws the spheres into the air; in the background, because placing 500,000 of them takes a while. */
    public void randomize() {
        Scene before = studio.scene();
        long number = studio.document().number();
        errands.run(
                () -> ThrownSpheres.of(before, System.nanoTime()),
                thrown -> {
                    if (studio.document().number() == number) {
                        place(thrown);
                    }
                },
                problem -> studio.notice(Problems.explain(problem)));
    }

    private void place(Scene thrown) {
        if (ThrownSpheres.fit(thrown, studio.scene())) {
            studio.edit("randomize", scene -> ThrownSpheres.placed(thrown, scene));
            studio.endGesture();
        } else {
            randomize();
        }
    }
}
