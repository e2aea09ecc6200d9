package dev.twister.gui;

import dev.twister.engine.EngineOffer;
import dev.twister.engine.JvmEngines;
import dev.twister.gui.drawing.DrawingLoop;
import dev.twister.gui.drawing.DrawingRequest;
import dev.twister.gui.drawing.DrawingStatus;
import dev.twister.gui.drawing.DrawnPicture;
import dev.twister.gui.drawing.EngineChoice;
import dev.twister.gui.drawing.SkyShelf;
import dev.twister.scene.Camera;
import dev.twister.scene.Scene;
import dev.twister.scene.SceneReader;
import dev.twister.world.CameraMotion;
import java.nio.file.Path;
import java.util.Optional;
import java.util.function.UnaryOperator;
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
    private final ReadOnlyObjectWrapper<Optional<DrawnPicture>> picture = new ReadOnlyObjectWrapper<>(Optional.empty());
    private final ReadOnlyObjectWrapper<DrawingStatus> drawing = new ReadOnlyObjectWrapper<>(DrawingStatus.QUIET);
    private Camera home;
    private int viewWidth;
    private int viewHeight;
    private long requests;

    private Studio(GuiOptions options, SkyShelf skies, DrawingLoop loop) {
        this.skies = skies;
        this.loop = loop;
        scene = new ReadOnlyObjectWrapper<>(options.scene());
        engine = new ReadOnlyObjectWrapper<>(new EngineChoice(0, options.engine()));
        home = options.scene().camera();
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

    /**
     * Changes the scene.
     *
     * @param what names the edit to a person, such as "light's size"
     */
    public void edit(String what, UnaryOperator<Scene> change) {
        show(change.apply(scene.get()));
    }

    /** Moves the viewer, which is no edit. */
    public void moveCamera(UnaryOperator<Camera> move) {
        Scene now = scene.get();
        Camera moved = move.apply(now.camera());
        if (!moved.equals(now.camera())) {
            show(now.withCamera(moved));
        }
    }

    /** Back to where the scene's file has the camera. */
    public void goHome() {
        moveCamera(_ -> home);
    }

    /** Draws with that engine as soon as it is ready. */
    public void chooseEngine(EngineOffer offer) {
        engine.set(new EngineChoice(engine.get().number() + 1, offer));
        request();
    }

    /**
     * Shows another scene.
     *
     * @throws dev.twister.scene.SceneException where it is not a scene; the old one stays
     * @throws dev.twister.sky.SkyException where its sky cannot be read; the old one stays
     */
    public void open(Path file) {
        Scene read = SceneReader.read(file);
        skies.refresh(read.skybox());
        home = read.camera();
        show(read);
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

    private void show(Scene next) {
        scene.set(next.withCamera(CameraMotion.above(next.camera(), next.plane())));
        request();
    }

    private void request() {
        if (viewWidth > 0 && viewHeight > 0) {
            requests++;
            loop.request(new DrawingRequest(requests, scene.get(), viewWidth, viewHeight, engine.get(), false));
        }
    }
}
