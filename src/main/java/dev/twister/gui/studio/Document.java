package dev.twister.gui.studio;

import dev.twister.gui.edit.CameraRig;
import dev.twister.gui.edit.SceneHistory;
import dev.twister.scene.Camera;
import dev.twister.scene.Scene;
import dev.twister.world.animation.CameraMotion;
import java.nio.file.Path;
import java.util.Optional;
import java.util.function.BiConsumer;
import java.util.function.UnaryOperator;
import javafx.beans.property.BooleanProperty;
import javafx.beans.property.ReadOnlyObjectProperty;
import javafx.beans.property.ReadOnlyObjectWrapper;
import javafx.beans.property.SimpleBooleanProperty;

/** The scene that is open, its file, and its edits. Used by JavaFX's thread alone. */
public final class Document {
    private final ReadOnlyObjectWrapper<Scene> scene;
    private final ReadOnlyObjectWrapper<Scene> original;
    private final ReadOnlyObjectWrapper<EditedFile> file;
    private final ReadOnlyObjectWrapper<SceneHistory.State> edits =
            new ReadOnlyObjectWrapper<>(SceneHistory.State.UNTOUCHED);
    private final BiConsumer<Scene, Scene> changing;
    private final BiConsumer<Scene, Scene> changed;
    private final BooleanProperty cameraLocked = new SimpleBooleanProperty(false);
    private SceneHistory history;
    private long number;

    /**
     * Opens a scene.
     *
     * @param changing called with the scenes before and after a change, before {@link #sceneProperty} changes
     * @param changed called with them after it has changed
     */
    Document(OpenedScene opened, BiConsumer<Scene, Scene> changing, BiConsumer<Scene, Scene> changed) {
        this.changing = changing;
        this.changed = changed;
        Scene first = withCameraAbovePlane(opened.scene());
        history = new SceneHistory(first);
        scene = new ReadOnlyObjectWrapper<>(first);
        original = new ReadOnlyObjectWrapper<>(opened.scene());
        file = new ReadOnlyObjectWrapper<>(opened.file());
    }

    /** The scene as it is now, including the camera. */
    public ReadOnlyObjectProperty<Scene> sceneProperty() {
        return scene.getReadOnlyProperty();
    }

    public Scene scene() {
        return scene.get();
    }

    /** The scene as it was opened, to which a reset leads. */
    public ReadOnlyObjectProperty<Scene> originalProperty() {
        return original.getReadOnlyProperty();
    }

    public Scene original() {
        return original.get();
    }

    /** The file that the scene came from or was saved to last. */
    public ReadOnlyObjectProperty<EditedFile> fileProperty() {
        return file.getReadOnlyProperty();
    }

    public Path file() {
        return file.get().path();
    }

    /** The folder of the scene's file; the working directory if it has none. */
    public Path folder() {
        return Optional.ofNullable(file().toAbsolutePath().getParent())
                .orElse(Path.of("").toAbsolutePath());
    }

    /** What can be undone and redone, and whether there are unsaved changes. */
    public ReadOnlyObjectProperty<SceneHistory.State> editsProperty() {
        return edits.getReadOnlyProperty();
    }

    /** Counts the scenes that were opened; the edits of one scene keep its number. */
    public long number() {
        return number;
    }

    /** Replaces the scene and discards its edits; {@link #refresh} shows it. */
    void open(OpenedScene opened) {
        number++;
        history = new SceneHistory(opened.scene());
        original.set(opened.scene());
        file.set(opened.file());
    }

    /**
     * Changes the scene. Successive edits of the same name are undone together, until {@link #endGesture}.
     *
     * @param what names the edit in the menu, such as "light's size"
     */
    void edit(String what, UnaryOperator<Scene> change) {
        history.edit(what, change.apply(scene.get()));
        refresh();
    }

    /** Sets the spheres' initial places, which {@link #undo} keeps; {@link #edit} shows them. */
    void carryOnMoved(Scene moved) {
        history.carryOnMoved(moved);
    }

    /** Starts a new undo step, for example when the mouse button is released. */
    void endGesture() {
        history.endGesture();
    }

    /** Undoes the last edit and returns its name. */
    Optional<String> undo() {
        Optional<String> undone = history.undoable();
        history.undo();
        refresh();
        return undone;
    }

    /** Redoes the edit undone last and returns its name. */
    Optional<String> redo() {
        Optional<String> redone = history.redoable();
        history.redo();
        refresh();
        return redone;
    }

    /** Whether the camera stays where it is, but for views and keyframes. */
    public BooleanProperty cameraLockedProperty() {
        return cameraLocked;
    }

    /** Moves the camera unless it is locked, which is no edit; its lens and keyframes stay. */
    void moveCamera(UnaryOperator<Camera> move) {
        if (cameraLocked.get()) {
            return;
        }
        Camera now = scene.get().camera();
        lookFrom(CameraRig.of(now).on(move.apply(now)));
    }

    /** Moves the camera and its focus along the path of its keyframes, which is no edit. */
    void followPath(Camera seen) {
        Camera now = scene.get().camera();
        lookFrom(seen.withKeyframes(now.keyframes()).withAperture(now.aperture()));
    }

    /** Shows the scene at another time of its film, which is no edit. */
    void follow(Scene now) {
        if (!now.equals(scene.get())) {
            history.carryOn(now);
            refresh();
        }
    }

    /** Moves the camera to a view and takes its lens, which is no edit; the keyframes stay. */
    void goTo(Camera view) {
        lookFrom(view.withKeyframes(scene.get().camera().keyframes()));
    }

    private void lookFrom(Camera camera) {
        if (!camera.equals(scene.get().camera())) {
            history.carryOn(scene.get().withCamera(camera));
            refresh();
        }
    }

    /** The scene with its edits so far. */
    public SceneHistory.Version present() {
        return history.version();
    }

    /** The scene to write to a file, with the camera's present pose; call {@link #saved} afterwards. */
    public SceneHistory.Version toSave() {
        history.endGesture();
        return history.version();
    }

    /** Tells that a version was written to a file; edits made since then are still unsaved. */
    public void saved(SceneHistory.Version version, EditedFile target) {
        if (history.markSaved(version)) {
            file.set(target);
            edits.set(SceneHistory.State.of(history));
        }
    }

    void markUnsaved() {
        history.markUnsaved();
        refresh();
    }

    /** Brings the properties up to date with the history. */
    void refresh() {
        history.carryOn(withCameraAbovePlane(history.present()));
        edits.set(SceneHistory.State.of(history));
        Scene before = scene.get();
        Scene now = history.present();
        if (!now.equals(before)) {
            changing.accept(before, now);
            scene.set(now);
            changed.accept(before, now);
        }
    }

    private static Scene withCameraAbovePlane(Scene scene) {
        return scene.withCamera(CameraMotion.above(scene.camera(), scene.ground()));
    }
}
