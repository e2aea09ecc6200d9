package dev.twister.gui.bodies;

import dev.twister.gui.controls.Dialogs;
import dev.twister.gui.edit.BodyEdits;
import dev.twister.gui.edit.SelectedBodies;
import dev.twister.gui.edit.TagEdits;
import dev.twister.gui.edit.ThrownSpheres;
import dev.twister.gui.picking.NewBodies;
import dev.twister.gui.studio.BackgroundTasks;
import dev.twister.gui.studio.Orbit;
import dev.twister.gui.studio.Selection;
import dev.twister.gui.studio.Studio;
import dev.twister.scene.Body;
import dev.twister.scene.Light;
import dev.twister.scene.Mesh;
import dev.twister.scene.Scene;
import dev.twister.scene.Shape;
import dev.twister.scene.Sphere;
import dev.twister.scene.Vector3;
import dev.twister.scene.light.LightShape;
import dev.twister.scene.property.SceneLimits;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;

/** The menu's actions on bodies. */
public final class BodyActions {
    public static final String UNDELETED_LIGHT = "The last light can't be deleted; a scene has at least one";

    private final Studio studio;
    private final BackgroundTasks tasks;
    private Optional<BodyGroup> copied = Optional.empty();

    public BodyActions(Studio studio, BackgroundTasks tasks) {
        this.studio = studio;
        this.tasks = tasks;
    }

    public void insert() {
        studio.pictureProperty().get().ifPresent(shown -> {
            Sphere sphere = NewBodies.sphere(shown.input(), studio.bodies().scene(), shown.meshes());
            studio.insert("insert sphere", List.of(sphere), List.of());
        });
    }

    public void insert(Shape.Kind kind) {
        studio.pictureProperty().get().ifPresent(shown -> {
            Mesh mesh = NewBodies.mesh(shown.input(), studio.bodies().scene(), shown.meshes(), kind);
            studio.insert("insert " + mesh.geometry().name(), List.of(mesh), List.of());
        });
    }

    public void insert(LightShape.Kind kind) {
        studio.pictureProperty().get().filter(_ -> hasRoomFor(1)).ifPresent(shown -> {
            Light light = NewBodies.light(shown.input(), studio.bodies().scene(), shown.meshes(), kind);
            studio.insert("insert " + light.shape().name(), List.of(), List.of(light));
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
            studio.editOnce(
                    "drop to the ground",
                    scene -> BodyEdits.onGround(scene, studio.bodies().meshes(), selected.bodies()));
        }
    }

    public void delete() {
        Scene standing = studio.scene();
        SelectedBodies selected = studio.selection().bodies();
        SelectedBodies deleted = BodyEdits.deletable(standing, selected);
        if (deleted.count() > 0) {
            String what =
                    deleted.count() == 1 ? BodyEdits.kind(standing, deleted.active()) : deleted.count() + " bodies";
            studio.editOnce("delete " + what, scene -> BodyEdits.deleted(scene, deleted.bodies()));
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
        tasks.run(
                () -> ThrownSpheres.of(before, System.nanoTime()),
                thrown -> {
                    if (studio.document().number() == number) {
                        place(thrown);
                    }
                },
                problem -> studio.notice(Dialogs.explain(problem)));
    }

    private void place(Scene thrown) {
        if (ThrownSpheres.fit(thrown, studio.scene())) {
            studio.editOnce("randomize", scene -> ThrownSpheres.placed(thrown, scene));
        } else {
            randomize();
        }
    }

    /**
     * Spheres, meshes and lights that are copied together.
     *
     * @param bodies spheres and meshes
     * @param apart so far to the right, in meters, another group like it does not touch it
     */
    public record BodyGroup(List<Body> bodies, List<Light> lights, double apart) {
        public BodyGroup {
            bodies = List.copyOf(bodies);
            lights = List.copyOf(lights);
        }

        public int count() {
            return bodies.size() + lights.size();
        }

        /** What they are called in a sentence, such as {@code sphere} or {@code 3 bodies}. */
        public String kind() {
            if (count() > 1) {
                return count() + " bodies";
            }
            return bodies.isEmpty() ? "light" : bodies.getFirst().kind();
        }

        /** The same to the right, or as far as the scene has room for all of them. */
        public BodyGroup beside() {
            double right = Stream.concat(
                            bodies.stream().map(Body::position), lights.stream().map(Light::position))
                    .mapToDouble(Vector3::x)
                    .max()
                    .orElseThrow();
            Vector3 way = new Vector3(Math.min(apart, SceneLimits.POSITION.max() - right), 0, 0);
            return new BodyGroup(
                    bodies.stream()
                            .map(body -> body.withPosition(moved(body.position(), way)))
                            .toList(),
                    lights.stream()
                            .map(light -> light.withPosition(moved(light.position(), way)))
                            .toList(),
                    apart);
        }

        private static Vector3 moved(Vector3 place, Vector3 way) {
            return SceneLimits.POSITION.clamp(place.plus(way));
        }
    }
}
