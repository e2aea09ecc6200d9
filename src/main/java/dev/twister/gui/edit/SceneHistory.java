package dev.twister.gui.edit;

import dev.twister.physics.SameSpheres;
import dev.twister.scene.Camera;
import dev.twister.scene.Scene;
import dev.twister.scene.Sphere;
import dev.twister.scene.Vector3;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Collections;
import java.util.Deque;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Optional;
import java.util.Set;

/**
 * A scene with the edits that led to it, which can be taken back and made again. Successive edits of one gesture (a
 * drag, a slider's movement) count as one. The camera's pose and places of spheres that physics moved are not edits:
 * undo leaves them as they are. The field of view can be undone but does not make the scene unsaved; the lens and the
 * keyframes do both. Used by one thread.
 */
public final class SceneHistory {
    static final int MAX_STEPS = 1000;

    /** In the lists that are held besides the present one; 16 to 32 MB of references. */
    static final long MAX_HELD_SPHERES = 4_000_000;

    /**
     * An edit that can be taken back, or made again.
     *
     * @param to the scene that it leads to
     * @param from the scene on the edit's other side, when it had been made
     * @param version of the scene that it leads to
     */
    private record Step(String what, Scene to, Scene from, long version) {
        Step from(Scene other) {
            return new Step(what, to, other, version);
        }
    }

    /** A scene as it was at some time. */
    public static final class Version {
        private final SceneHistory history;
        private final Scene scene;
        private final long number;

        private Version(SceneHistory history, Scene scene, long number) {
            this.history = history;
            this.scene = scene;
            this.number = number;
        }

        public Scene scene() {
            return scene;
        }

        /** Whether the other one is the same, but for the camera. */
        public boolean isSame(Version other) {
            return history == other.history && number == other.number;
        }
    }

    private final Deque<Step> past = new ArrayDeque<>();
    private final Deque<Step> future = new ArrayDeque<>();
    private Optional<String> gesture = Optional.empty();
    private Scene present;
    private long version;
    private long newestVersion;
    private long savedVersion;

    /** A scene as its file has it: nothing to take back, nothing to save. */
    public SceneHistory(Scene scene) {
        present = scene;
    }

    public Scene present() {
        return present;
    }

    /**
     * Makes an edit. One of the same name as the last belongs to the same gesture, until {@link #endGesture}; one that
     * changes nothing is none.
     *
     * @param what the edit's displayed name, such as "light's size"
     */
    public void edit(String what, Scene edited) {
        if (edited.equals(present)) {
            return;
        }
        if (isOnlySeenFromElsewhere(edited)) {
            carryOn(edited);
            return;
        }
        if (gesture.filter(what::equals).isEmpty()) {
            past.push(new Step(what, present, edited, version));
            gesture = Optional.of(what);
        } else {
            past.push(past.pop().from(edited));
        }
        future.clear();
        boolean onlyViewed = edited.withCamera(present.camera()).equals(present)
                && CameraRig.of(edited.camera()).equals(CameraRig.of(present.camera()));
        present = edited;
        if (!onlyViewed) {
            newestVersion++;
            version = newestVersion;
        }
        forgetTheOldest();
    }

    private boolean isOnlySeenFromElsewhere(Scene edited) {
        Camera camera = edited.camera();
        return camera.fieldOfViewDegrees() == present.camera().fieldOfViewDegrees()
                && camera.viewHeight() == present.camera().viewHeight()
                && CameraRig.of(camera).equals(CameraRig.of(present.camera()))
                && edited.withCamera(present.camera()).equals(present);
    }

    /** The next edit is a new step, whatever its name. */
    public void endGesture() {
        gesture = Optional.empty();
    }

    /** What is no edit: the camera has moved. */
    public void carryOn(Scene now) {
        present = now;
    }

    /**
     * Time has moved spheres, so that they start elsewhere; each stays the one that it was. That is nothing to take
     * back, but something to save. No edit that is taken back or made again puts them back, but one that moved the same
     * sphere.
     */
    public void carryOnMoved(Scene now) {
        if (!now.spheres().equals(present.spheres())) {
            newestVersion++;
            version = newestVersion;
        }
        present = now;
    }

    /** The edit that {@link #undo} takes back. */
    public Optional<String> undoable() {
        return Optional.ofNullable(past.peek()).map(Step::what);
    }

    /** The edit that {@link #redo} makes again. */
    public Optional<String> redoable() {
        return Optional.ofNullable(future.peek()).map(Step::what);
    }

    /** Undoes the last edit, if there is one. */
    public void undo() {
        step(past, future);
    }

    /** Redoes the edit that was undone last, if there is one. */
    public void redo() {
        step(future, past);
    }

    /** There is something to save, whatever was edited. */
    public void markUnsaved() {
        newestVersion++;
        version = newestVersion;
    }

    /** Whether the scene was edited since it was opened or saved. */
    public boolean hasChanged() {
        return version != savedVersion;
    }

    /** The present, to be told apart from what it is edited to. */
    public Version version() {
        return new Version(this, present, version);
    }

    /** A version has been saved, however it was edited since; whether it was one of this history. */
    public boolean markSaved(Version saved) {
        boolean own = saved.history == this;
        if (own) {
            savedVersion = saved.number;
        }
        return own;
    }

    private void step(Deque<Step> from, Deque<Step> to) {
        endGesture();
        Step step = from.poll();
        if (step == null) {
            return;
        }
        boolean carriedOn = !present.spheres().equals(step.from().spheres());
        to.push(new Step(step.what(), step.from(), step.to(), version));
        present = step.to()
                .withSpheres(CarriedSpheres.of(step.from().spheres(), step.to().spheres(), present.spheres()))
                .withCamera(camera(step));
        if (carriedOn) {
            newestVersion++;
        }
        version = carriedOn ? newestVersion : step.version();
    }

    private Camera camera(Step step) {
        Camera from = step.from().camera();
        Camera to = step.to().camera();
        Camera turned = present.camera();
        if (from.fieldOfViewDegrees() != to.fieldOfViewDegrees()) {
            turned = turned.withFieldOfViewDegrees(to.fieldOfViewDegrees());
        }
        if (from.viewHeight() != to.viewHeight()) {
            turned = turned.withViewHeight(to.viewHeight());
        }
        return CameraRig.of(present.camera())
                .edited(CameraRig.of(from), CameraRig.of(to))
                .on(turned);
    }

    private void forgetTheOldest() {
        while (past.size() > MAX_STEPS || (past.size() > 1 && heldSpheres() > MAX_HELD_SPHERES)) {
            past.removeLast();
        }
    }

    private long heldSpheres() {
        Set<List<Sphere>> lists = Collections.newSetFromMap(new IdentityHashMap<>());
        past.forEach(step -> {
            lists.add(step.to().spheres());
            lists.add(step.from().spheres());
        });
        lists.remove(present.spheres());
        return lists.stream().mapToLong(List::size).sum();
    }

    /**
     * What can be done about the edits of a scene.
     *
     * @param undoable the edit that undo takes back
     * @param redoable the edit that redo makes again
     * @param changed whether there is something to save
     */
    public record State(Optional<String> undoable, Optional<String> redoable, boolean changed) {
        /** A scene as its file has it. */
        public static final State UNTOUCHED = new State(Optional.empty(), Optional.empty(), false);

        public static State of(SceneHistory history) {
            return new State(history.undoable(), history.redoable(), history.hasChanged());
        }
    }

    /** Spheres between which an edit leads, when time has moved some since. */
    static final class CarriedSpheres {
        private CarriedSpheres() {}

        /**
         * Applies the edit that turned one list into another to the present list: spheres that the edit does not move
         * stay at their present places.
         *
         * @param present the spheres of {@code from}, in the same order, at their present places
         */
        static List<Sphere> of(List<Sphere> from, List<Sphere> to, List<Sphere> present) {
            if (present.equals(from)) {
                return to;
            }
            int[] same = SameSpheres.of(from, to);
            List<Sphere> carried = new ArrayList<>(to);
            for (int index = 0; index < same.length; index++) {
                int number = same[index];
                Sphere sphere = to.get(index);
                if (number != SameSpheres.NONE && from.get(number).position().equals(sphere.position())) {
                    Vector3 now = present.get(number).position();
                    carried.set(index, sphere.withPosition(now));
                }
            }
            return carried;
        }
    }
}
