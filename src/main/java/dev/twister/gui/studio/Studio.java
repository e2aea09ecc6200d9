package dev.twister.gui.studio;

import dev.twister.denoise.DenoiserOffer;
import dev.twister.engine.EngineOffer;
import dev.twister.gui.drawing.DrawingLoop;
import dev.twister.gui.drawing.DrawingRequest;
import dev.twister.gui.drawing.DrawingRequest.EngineChoice;
import dev.twister.gui.drawing.DrawingRequest.Refinement;
import dev.twister.gui.drawing.DrawnPicture;
import dev.twister.gui.drawing.RefinementGoal;
import dev.twister.gui.drawing.ResolutionMode;
import dev.twister.gui.edit.BodyEdits;
import dev.twister.gui.edit.BodyNumber;
import dev.twister.gui.edit.TagEdits;
import dev.twister.image.PictureSize;
import dev.twister.scene.Body;
import dev.twister.scene.Camera;
import dev.twister.scene.Light;
import dev.twister.scene.Scene;
import dev.twister.scene.light.Lights;
import dev.twister.scene.select.SceneBodies;
import dev.twister.scene.select.VisibleBodies;
import dev.twister.world.StageOrView;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.function.Consumer;
import java.util.function.UnaryOperator;
import java.util.stream.IntStream;
import javafx.beans.property.BooleanProperty;
import javafx.beans.property.ObjectProperty;
import javafx.beans.property.ReadOnlyObjectProperty;
import javafx.beans.property.ReadOnlyObjectWrapper;
import javafx.beans.property.ReadOnlyStringProperty;
import javafx.beans.property.ReadOnlyStringWrapper;
import javafx.beans.property.SimpleBooleanProperty;
import javafx.beans.property.SimpleObjectProperty;

/**
 * The application's state, and the only class that changes it: views bind to its properties and call its methods. Used
 * by JavaFX's thread alone; needs no toolkit.
 */
public final class Studio implements AutoCloseable {
    private static final double NANOS_PER_SECOND = 1e9;

    /** Bounds the camera's movement in one pulse, for example after the window was suspended. */
    private static final double LONGEST_STEP_SECONDS = 0.25;

    private final SceneAssets assets;
    private final DrawingLoop loop;
    private final Document document;
    private final ReadOnlyObjectWrapper<EngineChoice> engine;
    private final ReadOnlyObjectWrapper<ResolutionMode> resolution = new ReadOnlyObjectWrapper<>(ResolutionMode.WINDOW);
    private final ReadOnlyObjectWrapper<StageOrView> shown = new ReadOnlyObjectWrapper<>(StageOrView.BEAUTY);
    private final ReadOnlyObjectWrapper<Optional<DrawnPicture>> picture = new ReadOnlyObjectWrapper<>(Optional.empty());
    private final ReadOnlyObjectWrapper<DrawingLoop.Status> drawing =
            new ReadOnlyObjectWrapper<>(DrawingLoop.Status.QUIET);
    private final BooleanProperty refining = new SimpleBooleanProperty(true);
    private final ObjectProperty<Double> noiseGoal = new SimpleObjectProperty<>(0.0);
    private final ObjectProperty<Optional<DenoiserOffer>> denoiser = new SimpleObjectProperty<>(Optional.empty());
    private final ReadOnlyStringWrapper notice = new ReadOnlyStringWrapper("");

    /** The warnings about files in the notice; empty if it says something else. */
    private String warned = "";

    private final FrameHistory frames = new FrameHistory();
    private final Selection selection;
    private final MotionControl motion;
    private final PresentBodies bodies;
    private final CameraControl cameraControl;
    private final Film film;
    private double displayMillis;
    private long lastPulseNanos;
    private double viewWidth;
    private double viewHeight;
    private final VisibleScene drawn = new VisibleScene();
    private Optional<Scene> requested = Optional.empty();
    private long requests;

    /** The first request with the present body numbers; they change when bodies are added or deleted. */
    private long numbered;

    private Studio(OpenedScene opened, EngineOffer offer, SceneAssets assets) {
        this.assets = assets;
        loop = assets.drawingLoop();
        document = new Document(opened, this::changing, this::changed);
        engine = new ReadOnlyObjectWrapper<>(new EngineChoice(0, offer));
        selection = new Selection(document, this::notice);
        motion = new MotionControl(document, selection, this::notice, this::request);
        bodies = new PresentBodies(document, motion, picture);
        cameraControl = new CameraControl(document, this::notice);
        film = new Film(document, motion::isOn, bodies::meshes, this::request, this::notice);
        refining.subscribe(_ -> request());
        noiseGoal.subscribe(_ -> request());
        denoiser.subscribe(_ -> request());
    }

    /**
     * A studio whose drawing thread has started; it draws once the size of the view is known.
     *
     * @param opened shown first
     * @param engine draws first
     * @param substitute draws until the engine is ready, and if it fails; must open at once
     */
    public static Studio start(OpenedScene opened, EngineOffer engine, EngineOffer substitute) {
        Studio studio = new Studio(opened, engine, new SceneAssets(substitute));
        studio.loop.start();
        return studio;
    }

    /** The scene that is open, its file and its edits. */
    public Document document() {
        return document;
    }

    /** The scene as it is now, including the camera. */
    public ReadOnlyObjectProperty<Scene> sceneProperty() {
        return document.sceneProperty();
    }

    public Scene scene() {
        return document.scene();
    }

    /** The engine that was chosen; {@link #pictureProperty} tells which one drew. */
    public ReadOnlyObjectProperty<EngineChoice> engineProperty() {
        return engine.getReadOnlyProperty();
    }

    /** The picture to show; empty until the first is finished. */
    public ReadOnlyObjectProperty<Optional<DrawnPicture>> pictureProperty() {
        return picture.getReadOnlyProperty();
    }

    /** Maps bodies of the picture to bodies of the scene; empty while the picture is of the previous scene. */
    public Optional<PictureBodies> picturedBodies() {
        return picture.get()
                .map(DrawnPicture::request)
                .filter(request -> request.document() == document.number())
                .map(request -> new PictureBodies(
                        request.scene(),
                        document.scene(),
                        request.number() < numbered || BodyEdits.haveOtherCounts(request.scene(), document.scene())));
    }

    /** The samples per pixel of the picture; empty unless it is finished and no other is being drawn. */
    public Optional<Integer> restingSamples() {
        return picture.get()
                .filter(shown -> shown.isWhole()
                        && shown.request().number() == requests
                        && !shown.request().isContinuous()
                        && shown.gathered().isDone())
                .map(DrawnPicture::samples);
    }

    /** Whether something moves or the picture is not finished. */
    public boolean isBusy() {
        return cameraControl.isMoving()
                || film.playingProperty().get()
                || motion.motionProperty().get().running()
                || restingSamples().isEmpty();
    }

    /** The state of the drawing thread. */
    public ReadOnlyObjectProperty<DrawingLoop.Status> drawingProperty() {
        return drawing.getReadOnlyProperty();
    }

    /** The files that scenes name. */
    public SceneAssets assets() {
        return assets;
    }

    /** See {@link DrawingLoop#radiance}. */
    public CompletableFuture<Optional<float[]>> radiance(DrawnPicture shown) {
        return loop.radiance(shown);
    }

    /** See {@link DrawingLoop#watch}. */
    public void watch(Consumer<DrawnPicture> watcher) {
        loop.watch(watcher);
    }

    /** See {@link DrawingLoop#unwatch}. */
    public void unwatch() {
        loop.unwatch();
    }

    /** Whether a still picture gathers samples and then rests; if not, it is drawn again and again. */
    public BooleanProperty refiningProperty() {
        return refining;
    }

    /** The noise at which a path-traced picture rests, relative to white; 0 for none. */
    public ObjectProperty<Double> noiseGoalProperty() {
        return noiseGoal;
    }

    /** What removes the noise of a path-traced picture at rest; empty to leave it. */
    public ObjectProperty<Optional<DenoiserOffer>> denoiserProperty() {
        return denoiser;
    }

    /** The pictures of the last ten seconds. */
    public FrameHistory frames() {
        return frames;
    }

    /** The message for the status line; may be empty. */
    public ReadOnlyStringProperty noticeProperty() {
        return notice.getReadOnlyProperty();
    }

    /** Shows a message in the status line. */
    public void notice(String text) {
        warned = "";
        notice.set(text);
    }

    /** Clears a message, if it is still shown. */
    public void retract(String text) {
        if (notice.get().equals(text)) {
            notice("");
        }
    }

    /**
     * Changes the scene. While physics runs, the change is applied to the bodies at their displayed places; those that
     * it moves start there from now on, the others are not affected. Successive edits of the same name are undone
     * together, until {@link #endGesture}; moving the camera is no edit.
     *
     * @param what names the edit in the menu, such as "light's size"
     */
    public void edit(String what, UnaryOperator<Scene> change) {
        Scene edited = change.apply(scene());
        if (motion.isOn() && !edited.spheres().equals(scene().spheres())) {
            PresentBodies.MovedScene.Edit edit = bodies.moved().edit(change);
            document.carryOnMoved(edit.before());
            document.edit(what, _ -> edit.after());
        } else {
            document.edit(what, _ -> edited);
        }
    }

    /** Changes the scene as {@link #edit} does, and ends the gesture. */
    public void editOnce(String what, UnaryOperator<Scene> change) {
        edit(what, change);
        endGesture();
    }

    /** Adds spheres and meshes, and lights, to the scene as an edit of its own, and selects them. */
    public void insert(String what, List<Body> added, List<Light> lights) {
        editOnce(what, standing -> {
            Scene more = standing.withBodies(standing.bodies().with(added));
            return lights.isEmpty() ? more : more.withLights(more.lights().with(lights));
        });
        List<Integer> numbers = new ArrayList<>(BodyEdits.numbersOfLast(scene(), added));
        int before = scene().lights().count() - lights.size();
        IntStream.range(0, lights.size()).forEach(index -> numbers.add(BodyNumber.ofLight(before + index)));
        selection.select(numbers);
    }

    /** Starts a new undo step, for example when the mouse button is released. */
    public void endGesture() {
        document.endGesture();
    }

    public void undo() {
        document.undo().ifPresent(what -> notice("Undone: " + what));
        film.follow();
    }

    public void redo() {
        document.redo().ifPresent(what -> notice("Redone: " + what));
        film.follow();
    }

    /** Starts and pauses physics. */
    public MotionControl motion() {
        return motion;
    }

    /** Where bodies are in the picture. */
    public PresentBodies bodies() {
        return bodies;
    }

    /** The selected bodies. */
    public Selection selection() {
        return selection;
    }

    /** The size of the picture, relative to the window. */
    public ReadOnlyObjectProperty<ResolutionMode> resolutionProperty() {
        return resolution.getReadOnlyProperty();
    }

    public void setResolution(ResolutionMode mode) {
        resolution.set(mode);
        request();
    }

    /** What is displayed: the picture, a stage or a view. */
    public ReadOnlyObjectProperty<StageOrView> shownProperty() {
        return shown.getReadOnlyProperty();
    }

    public void setShown(StageOrView picture) {
        shown.set(picture);
        request();
    }

    /** Walks, turns, and keeps views. */
    public CameraControl cameraControl() {
        return cameraControl;
    }

    /** Sets and plays the scene's keyframes. */
    public Film film() {
        return film;
    }

    /** Moves the camera, which is no edit; its lens and keyframes stay. */
    public void moveCamera(UnaryOperator<Camera> move) {
        document.moveCamera(move);
    }

    /** Draws with that engine as soon as it is ready. */
    public void chooseEngine(EngineOffer offer) {
        engine.set(new EngineChoice(engine.get().number() + 1, offer));
        request();
    }

    /** Shows another scene, and discards the present one with its edits. */
    public void show(OpenedScene opened) {
        document.open(opened);
        selection.select(BodyNumber.NONE);
        motion.reset();
        document.refresh();
        film.startAnew();
        request();
    }

    /**
     * Shows a scene with unsaved edits of it.
     *
     * @param before the scene without them, to which undo leads
     */
    public void restore(OpenedScene before, Scene edited) {
        show(before);
        editOnce("restored changes", _ -> edited);
        document.markUnsaved();
    }

    /** The number of the last request: pictures of it or of later ones show the present scene. */
    public long lastRequest() {
        return requests;
    }

    /** Makes a panorama the sky; if it is the sky already, the picture is drawn again with the file's new content. */
    public void useSky(Path panorama) {
        editOnce("sky", now -> now.withSky(now.sky().withFile(panorama)));
        request();
    }

    /** The area for the picture, in pixels of the screen. */
    public void setViewSize(double width, double height) {
        if (width != viewWidth || height != viewHeight) {
            viewWidth = width;
            viewHeight = height;
            request();
        }
    }

    /** Shows warnings about files beside those that are still shown. */
    private void warn(String warnings) {
        warned = warned.isEmpty() ? warnings : warned + "; " + warnings;
        notice.set(warned);
    }

    /**
     * Called in every pulse: moves the camera, and takes the picture that the drawing thread has finished.
     *
     * @param nanos now, by {@link System#nanoTime}
     */
    public void pulse(long nanos) {
        double seconds = Math.clamp((nanos - lastPulseNanos) / NANOS_PER_SECOND, 0, LONGEST_STEP_SECONDS);
        lastPulseNanos = nanos;
        cameraControl.pulse(seconds);
        film.pulse(seconds);
        loop.takeNewest().ifPresent(newest -> {
            frames.add(newest, displayMillis);
            picture.set(Optional.of(newest));
        });
        assets.takeWarnings().ifPresent(this::warn);
        if (assets.takeMeshesRead()) {
            request();
        }
        drawing.set(loop.status());
    }

    /** Tells how long JavaFX's thread was busy in a pulse, up to the end of its layout. */
    public void noteDisplayMillis(double millis) {
        displayMillis = millis;
    }

    /** Ends the drawing thread; returns at once. */
    @Override
    public void close() {
        loop.close();
    }

    /** Waits for the drawing thread to end after {@link #close}; returns whether it did. */
    public boolean awaitEnd(Duration limit) throws InterruptedException {
        return loop.awaitEnd(limit);
    }

    private void changing(Scene before, Scene now) {
        if (BodyEdits.haveOtherCounts(before, now) || TagEdits.hideOthers(before, now)) {
            numbered = requests + 1;
        }
    }

    private void changed(Scene before, Scene now) {
        selection.follow(before, now);
        // Views that are kept, names and groups change no picture.
        Scene wanted = drawn.of(now);
        if (requested
                .filter(last -> last.withViews(wanted.views()).equals(wanted))
                .isEmpty()) {
            request();
        }
    }

    private void request() {
        if (viewWidth >= 1 && viewHeight >= 1) {
            requests++;
            Scene wanted = drawn.of(scene());
            requested = Optional.of(wanted);
            PictureSize size = resolution.get().size(viewWidth, viewHeight);
            int refineTo = refining.get() ? RefinementGoal.samples(scene(), shown.get()) : 0;
            Refinement refinement = new Refinement(refineTo, noiseGoal.get(), denoiser.get());
            loop.request(new DrawingRequest(
                    requests,
                    document.number(),
                    film.played(wanted),
                    size.width(),
                    size.height(),
                    engine.get(),
                    refinement,
                    motion.motionProperty().get(),
                    shown.get()));
        }
    }

    /** The visible part of the scene. What an edit does not change stays the same list, which is compared at once. */
    private static final class VisibleScene {
        private Scene whole = Scene.under(Path.of(""));
        private SceneBodies bodies = whole.bodies();
        private Lights lights = whole.lights();

        /** See {@link VisibleBodies#of}; its tracks are those of the whole scene, as a picture has none. */
        @SuppressWarnings("ReferenceEquality") // an edit makes a new record; to compare all spheres takes longer
        Scene of(Scene scene) {
            if (scene.bodies() != whole.bodies() || scene.lights() != whole.lights()) {
                Scene visible = VisibleBodies.of(scene);
                bodies = visible.bodies().equals(bodies) ? bodies : visible.bodies();
                lights = visible.lights().equals(lights) ? lights : visible.lights();
                whole = scene;
            }
            return scene.withBodies(bodies).withLights(lights);
        }
    }
}
