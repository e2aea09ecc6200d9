package dev.twister.gui;

import dev.twister.bench.PictureSize;
import dev.twister.engine.EngineOffer;
import dev.twister.engine.JvmEngines;
import dev.twister.gui.drawing.DrawingLoop;
import dev.twister.gui.drawing.DrawingRequest;
import dev.twister.gui.drawing.DrawingStatus;
import dev.twister.gui.drawing.DrawnPicture;
import dev.twister.gui.drawing.EngineChoice;
import dev.twister.gui.drawing.SkyShelf;
import dev.twister.gui.model.BodyEdits;
import dev.twister.gui.model.EditState;
import dev.twister.gui.model.ResolutionMode;
import dev.twister.gui.model.SceneHistory;
import dev.twister.kernel.Layout;
import dev.twister.scene.Camera;
import dev.twister.scene.Scene;
import dev.twister.scene.SceneReader;
import dev.twister.scene.SceneWriter;
import dev.twister.world.CameraMotion;
import java.nio.file.Path;
import java.util.Optional;
import java.util.function.UnaryOperator;
import javafx.beans.property.ReadOnlyIntegerProperty;
import javafx.beans.property.ReadOnlyIntegerWrapper;
import javafx.beans.property.ReadOnlyObjectProperty;
import javafx.beans.property.ReadOnlyObjectWrapper;

/**
 * What a person sees and edits, and the one place where it changes: views bind to its properties and call its methods. Used by
 * JavaFX's thread alone; needs no toolkit.
 */
public final class Studio implements AutoCloseable {
    private final SkyShelf skies;
    private final DrawingLoop loop;
    private final ReadOnlyObjectWrapper<Scene> scene;
    private final ReadOnlyObjectWrapper<EngineChoice> engine;
    private final ReadOnlyObjectWrapper<Optional<Path>> file;
    private final ReadOnlyObjectWrapper<EditState> edits = new ReadOnlyObjectWrapper<>(EditState.UNTOUCHED);
    private final ReadOnlyObjectWrapper<ResolutionMode> resolution = new ReadOnlyObjectWrapper<>(ResolutionMode.WINDOW);
    private final ReadOnlyIntegerWrapper selection = new ReadOnlyIntegerWrapper(Layout.NOTHING);
    private final ReadOnlyObjectWrapper<Optional<DrawnPicture>> picture = new ReadOnlyObjectWrapper<>(Optional.empty());
    private final ReadOnlyObjectWrapper<DrawingStatus> drawing = new ReadOnlyObjectWrapper<>(DrawingStatus.QUIET);
    private SceneHistory document;
    private Scene original;
    private int viewWidth;
    private int viewHeight;
    private long requests;

    private Studio(GuiOptions options, SkyShelf skies, DrawingLoop loop) {
        this.skies = skies;
        this.loop = loop;
        scene = new ReadOnlyObjectWrapper<>(options.scene());
        engine = new ReadOnlyObjectWrapper<>(new EngineChoice(0, options.engine()));
        file = new ReadOnlyObjectWrapper<>(Optional.of(options.file()));
        document = new SceneHistory(options.scene());
        original = options.scene();
    }

    /** A studio with its drawing thread at work, which draws once the view's size is known. */
    public static Studio start(GuiOptions options) {
        SkyShelf skies = new SkyShelf();
        DrawingLoop loop = new DrawingLoop(skies, JvmEngines.parallel());
        Studio studio = new Studio(options, skies, loop);
        loop.start();
        return studio;
    }

    /** The scene as it is now, the camera included. */
    public ReadOnlyObjectProperty<Scene> sceneProperty() {
        return scene.getReadOnlyProperty();
    }

    public Scene scene() {
        return scene.get();
    }

    /** The engine that was chosen; {@link #pictureProperty} tells which one drew. */
    public ReadOnlyObjectProperty<EngineChoice> engineProperty() {
        return engine.getReadOnlyProperty();
    }

    /** The picture to show; empty until the first is finished. */
    public ReadOnlyObjectProperty<Optional<DrawnPicture>> pictureProperty() {
        return picture.getReadOnlyProperty();
    }

    /** What the drawing thread has to say. */
    public ReadOnlyObjectProperty<DrawingStatus> drawingProperty() {
        return drawing.getReadOnlyProperty();
    }

    /** The file that the scene came from or was saved to last. */
    public ReadOnlyObjectProperty<Optional<Path>> fileProperty() {
        return file.getReadOnlyProperty();
    }

    /** The scene as its file had it, to which a reset leads. */
    public Scene original() {
        return original;
    }

    /** What can be undone, made again, and whether there is something to save. */
    public ReadOnlyObjectProperty<EditState> editsProperty() {
        return edits.getReadOnlyProperty();
    }

    /**
     * Changes the scene. Successive edits of the same name are one to {@link #undo}, until {@link #endGesture}; the camera
     * is no part of that.
     *
     * @param what names the edit to a person, such as "light's size"
     */
    public void edit(String what, UnaryOperator<Scene> change) {
        document.edit(what, change.apply(scene.get()));
        show();
    }

    /** The next edit is one of its own: the mouse button was let go, say. */
    public void endGesture() {
        document.endGesture();
    }

    /** Takes the last edit back, where there is one. */
    public void undo() {
        document.undo();
        show();
    }

    /** Makes the edit again that was taken back last, where there is one. */
    public void redo() {
        document.redo();
        show();
    }

    /** The body that a person works on, numbered as the kernel has it; {@link Layout#NOTHING} where there is none. */
    public ReadOnlyIntegerProperty selectionProperty() {
        return selection.getReadOnlyProperty();
    }

    /** Selects the light or a sphere; any other number selects nothing. */
    public void select(int body) {
        selection.set(BodyEdits.isMovable(scene.get(), body) ? body : Layout.NOTHING);
    }

    /** How large the picture is drawn. */
    public ReadOnlyObjectProperty<ResolutionMode> resolutionProperty() {
        return resolution.getReadOnlyProperty();
    }

    public void setResolution(ResolutionMode mode) {
        resolution.set(mode);
        request();
    }

    /** Moves the viewer, which is no edit. */
    public void moveCamera(UnaryOperator<Camera> move) {
        Scene now = scene.get();
        Camera moved = move.apply(now.camera());
        if (!moved.equals(now.camera())) {
            document.carryOn(now.withCamera(moved));
            show();
        }
    }

    /** Back to where the scene's file has the camera. */
    public void goHome() {
        moveCamera(_ -> original.camera());
    }

    /** Draws with that engine as soon as it is ready. */
    public void chooseEngine(EngineOffer offer) {
        engine.set(new EngineChoice(engine.get().number() + 1, offer));
        request();
    }

    /**
     * Reads a scene and its sky, and shows nothing yet; any thread may do so.
     *
     * @throws dev.twister.scene.SceneException where it is not a scene
     * @throws dev.twister.sky.SkyException where its sky cannot be read
     */
    public OpenedScene read(Path scenesFile) {
        Scene read = SceneReader.read(scenesFile);
        skies.refresh(read.skybox());
        return new OpenedScene(scenesFile, read);
    }

    /** Shows another scene, and forgets the old one with its edits. */
    public void show(OpenedScene opened) {
        document = new SceneHistory(opened.scene());
        original = opened.scene();
        file.set(Optional.of(opened.file()));
        selection.set(Layout.NOTHING);
        show();
    }

    /**
     * Shows another scene, as {@link #read} and {@link #show(OpenedScene)}; the old one stays where that fails.
     *
     * @throws dev.twister.scene.SceneException where it is not a scene
     * @throws dev.twister.sky.SkyException where its sky cannot be read
     */
    public void open(Path scenesFile) {
        show(read(scenesFile));
    }

    /**
     * Saves the scene, the camera where it is now.
     *
     * @throws dev.twister.scene.SceneException where it cannot be written
     */
    public void save(Path target) {
        SceneWriter.write(scene.get(), target);
        document.markSaved();
        file.set(Optional.of(target));
        edits.set(EditState.of(document));
    }

    /**
     * Reads a panorama, so that the scene can have it; any thread may do so.
     *
     * @throws dev.twister.sky.SkyException where it cannot be read
     */
    public void readSky(Path panorama) {
        skies.refresh(panorama);
    }

    /** The size of the area for the picture, in pixels of the screen. */
    public void setViewSize(int width, int height) {
        if (width != viewWidth || height != viewHeight) {
            viewWidth = width;
            viewHeight = height;
            request();
        }
    }

    /** Called in every pulse: takes over what the drawing thread has finished. */
    public void pulse() {
        loop.takeNewest().ifPresent(newest -> picture.set(Optional.of(newest)));
        drawing.set(loop.status());
    }

    /** Lets the drawing thread end. */
    @Override
    public void close() {
        loop.close();
    }

    private void show() {
        Scene now = document.present();
        document.carryOn(now.withCamera(CameraMotion.above(now.camera(), now.plane())));
        scene.set(document.present());
        edits.set(EditState.of(document));
        select(selection.get());
        request();
    }

    private void request() {
        if (viewWidth > 0 && viewHeight > 0) {
            requests++;
            PictureSize size = resolution.get().size(viewWidth, viewHeight);
            loop.request(new DrawingRequest(requests, scene.get(), size.width(), size.height(), engine.get(), false));
        }
    }
}
