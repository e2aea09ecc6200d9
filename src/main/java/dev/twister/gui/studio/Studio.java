package dev.twister.gui.studio;

import dev.twister.engine.EngineOffer;
import dev.twister.gui.drawing.DrawingLoop;
import dev.twister.gui.drawing.DrawingRequest;
import dev.twister.gui.drawing.DrawingStatus;
import dev.twister.gui.drawing.DrawnPicture;
import dev.twister.gui.drawing.EngineChoice;
import dev.twister.gui.model.BodyEdits;
import dev.twister.gui.model.BodyExtent;
import dev.twister.gui.model.BodyNumber;
import dev.twister.gui.model.CameraRig;
import dev.twister.gui.model.EditState;
import dev.twister.gui.model.EditedFile;
import dev.twister.gui.model.RefinementGoal;
import dev.twister.gui.model.ResolutionMode;
import dev.twister.gui.model.SceneHistory;
import dev.twister.image.PictureSize;
import dev.twister.scene.Body;
import dev.twister.scene.Camera;
import dev.twister.scene.Material;
import dev.twister.scene.Mesh;
import dev.twister.scene.Scene;
import dev.twister.scene.Vector3;
import dev.twister.world.CameraMotion;
import dev.twister.world.Picture;
import dev.twister.world.SceneMeshes;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.function.Consumer;
import java.util.function.UnaryOperator;
import javafx.beans.property.BooleanProperty;
import javafx.beans.property.ReadOnlyObjectProperty;
import javafx.beans.property.ReadOnlyObjectWrapper;
import javafx.beans.property.ReadOnlyStringProperty;
import javafx.beans.property.ReadOnlyStringWrapper;
import javafx.beans.property.SimpleBooleanProperty;

/**
 * What a person sees and edits, and the one place where it changes: views bind to its properties and call its methods.
 * Used by JavaFX's thread alone; needs no toolkit.
 */
public final class Studio implements AutoCloseable {
    private static final double NANOS_PER_SECOND = 1e9;

    /** After the window was asleep, say, the camera does not leap. */
    private static final double LONGEST_STEP_SECONDS = 0.25;

    private final SceneAssets assets;
    private final DrawingLoop loop;
    private final ReadOnlyObjectWrapper<Scene> scene;
    private final ReadOnlyObjectWrapper<EngineChoice> engine;
    private final ReadOnlyObjectWrapper<EditedFile> file;
    private final ReadOnlyObjectWrapper<EditState> edits = new ReadOnlyObjectWrapper<>(EditState.UNTOUCHED);
    private final ReadOnlyObjectWrapper<ResolutionMode> resolution = new ReadOnlyObjectWrapper<>(ResolutionMode.WINDOW);
    private final ReadOnlyObjectWrapper<Picture> shown = new ReadOnlyObjectWrapper<>(Picture.REFLECTIONS);
    private final Selection selection = new Selection(this);
    private final ReadOnlyObjectWrapper<Optional<DrawnPicture>> picture = new ReadOnlyObjectWrapper<>(Optional.empty());
    private final ReadOnlyObjectWrapper<DrawingStatus> drawing = new ReadOnlyObjectWrapper<>(DrawingStatus.QUIET);
    private final BooleanProperty refining = new SimpleBooleanProperty(true);
    private final CameraHand hand = new CameraHand(this);
    private final CameraFilm film;
    private final FrameHistory frames = new FrameHistory();
    private final MotionControl motion = new MotionControl(this);
    private final ReadOnlyStringWrapper notice = new ReadOnlyStringWrapper("");
    private SceneHistory document;
    private long documents;
    private final ReadOnlyObjectWrapper<Scene> original;
    private double displayMillis;
    private long lastPulseNanos;
    private double viewWidth;
    private double viewHeight;
    private long requests;

    /** The first request with the numbers that bodies have now; they change where some come or go. */
    private long numbered;

    private Studio(OpenedScene opened, EngineOffer offer, SceneAssets assets) {
        this.assets = assets;
        loop = assets.drawingLoop();
        Scene first = withCameraAbovePlane(opened.scene());
        scene = new ReadOnlyObjectWrapper<>(first);
        engine = new ReadOnlyObjectWrapper<>(new EngineChoice(0, offer));
        file = new ReadOnlyObjectWrapper<>(opened.file());
        document = new SceneHistory(first);
        original = new ReadOnlyObjectWrapper<>(opened.scene());
        film = new CameraFilm(this);
        refining.subscribe(_ -> request());
    }

    /**
     * A studio with its drawing thread at work, which draws once the view's size is known.
     *
     * @param opened shown first
     * @param engine draws first
     */
    public static Studio start(OpenedScene opened, EngineOffer engine) {
        Studio studio = new Studio(opened, engine, new SceneAssets());
        studio.loop.start();
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

    /**
     * Which body of the scene that is shown is which of the scene's; empty while it is a picture of the scene before.
     */
    public Optional<PictureBodies> picturedBodies() {
        return picture.get()
                .map(DrawnPicture::request)
                .filter(request -> request.document() == documents)
                .map(request -> new PictureBodies(request.scene(), scene.get(), request.number() < numbered));
    }

    /** The samples per pixel of the picture that is shown, where it is finished and no other one is being drawn. */
    public Optional<Integer> restingSamples() {
        return picture.get()
                .filter(shown -> shown.request().number() == requests
                        && !shown.request().isContinuous()
                        && shown.samples() >= shown.request().refineTo())
                .map(DrawnPicture::samples);
    }

    /** What the drawing thread has to say. */
    public ReadOnlyObjectProperty<DrawingStatus> drawingProperty() {
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

    /** Whether a picture at rest gathers samples and then rests; otherwise it is drawn again and again. */
    public BooleanProperty refiningProperty() {
        return refining;
    }

    /** The last ten seconds' pictures. */
    public FrameHistory frames() {
        return frames;
    }

    /** What was done or refused last, for the status line; may be empty. */
    public ReadOnlyStringProperty noticeProperty() {
        return notice.getReadOnlyProperty();
    }

    /** Tells a person something that needs no answer. */
    public void notice(String text) {
        notice.set(text);
    }

    /** Takes a notice away, where it is still the last one. */
    public void retract(String text) {
        if (notice.get().equals(text)) {
            notice.set("");
        }
    }

    /** The file that the scene came from or was saved to last. */
    public ReadOnlyObjectProperty<EditedFile> fileProperty() {
        return file.getReadOnlyProperty();
    }

    /** The scene as its file had it, to which a reset leads. */
    public ReadOnlyObjectProperty<Scene> originalProperty() {
        return original.getReadOnlyProperty();
    }

    public Scene original() {
        return original.get();
    }

    /** What can be undone, made again, and whether there is something to save. */
    public ReadOnlyObjectProperty<EditState> editsProperty() {
        return edits.getReadOnlyProperty();
    }

    /**
     * Changes the scene. Where bodies move, the change is told where they are seen, and only those that it puts
     * elsewhere are there from then on; all others go on as they were. Successive edits of the same name are one to
     * {@link #undo}, until {@link #endGesture}; the camera is no part of that.
     *
     * @param what names the edit to a person, such as "light's size"
     */
    public void edit(String what, UnaryOperator<Scene> change) {
        Scene standing = scene.get();
        Scene edited = change.apply(standing);
        if (motion.isOn() && !edited.spheres().equals(standing.spheres())) {
            MovedScene.Edit edit = MovedScene.of(
                            standing, motion.motionProperty().get(), picture.get())
                    .edit(change);
            document.carryOnMoved(edit.before());
            edited = edit.after();
        }
        document.edit(what, edited);
        show();
    }

    /** Adds spheres and meshes to the scene, which is an edit of its own, and selects them. */
    public void insert(String what, List<Body> bodies) {
        edit(what, standing -> standing.withBodies(standing.bodies().with(bodies)));
        endGesture();
        selection.select(BodyEdits.numbersOfLast(scene.get(), bodies));
    }

    /** Whether and how bodies move. */
    public MotionControl motion() {
        return motion;
    }

    /** Where a movable body is in the picture that is shown. */
    public Vector3 positionNow(int body) {
        return BodyEdits.isSphere(scene.get(), body)
                ? MovedScene.of(scene.get(), motion.motionProperty().get(), picture.get())
                        .position(BodyNumber.sphere(body))
                : BodyEdits.position(scene.get(), body);
    }

    /** The scene with its spheres where the picture that is shown has them. */
    public Scene sceneNow() {
        return motion.isOn()
                ? MovedScene.of(scene.get(), motion.motionProperty().get(), picture.get())
                        .asSeen()
                : scene.get();
    }

    /** The room that a movable body takes in the picture that is shown. */
    public BodyExtent extentNow(int body) {
        SceneMeshes shown = picture.get().map(DrawnPicture::meshes).orElse(SceneMeshes.NONE);
        Vector3 standing = BodyEdits.position(scene.get(), body);
        Vector3 now = positionNow(body);
        return BodyExtent.of(scene.get(), shown, body).movedBy(now.minus(standing));
    }

    /** What a mesh's file says that it is made of; the default where it has not been read. */
    public Material fileMaterial(int body) {
        Mesh mesh = BodyEdits.mesh(scene.get(), body);
        return picture.get()
                .map(DrawnPicture::meshes)
                .filter(shown -> shown.holds(mesh))
                .map(shown -> shown.fileMaterial(mesh))
                .orElse(Material.DEFAULT);
    }

    /** The next edit is one of its own: the mouse button was let go, say. */
    public void endGesture() {
        document.endGesture();
    }

    /** Takes the last edit back, where there is one. */
    public void undo() {
        document.undoable().ifPresent(what -> notice("Undone: " + what));
        document.undo();
        show();
    }

    /** Makes the edit again that was taken back last, where there is one. */
    public void redo() {
        document.redoable().ifPresent(what -> notice("Redone: " + what));
        document.redo();
        show();
    }

    /** The bodies that a person works on. */
    public Selection selection() {
        return selection;
    }

    /** How large the picture is drawn. */
    public ReadOnlyObjectProperty<ResolutionMode> resolutionProperty() {
        return resolution.getReadOnlyProperty();
    }

    public void setResolution(ResolutionMode mode) {
        resolution.set(mode);
        request();
    }

    /** What is shown of the scene: its picture, or a stage or a view of it. */
    public ReadOnlyObjectProperty<Picture> shownProperty() {
        return shown.getReadOnlyProperty();
    }

    public void setShown(Picture picture) {
        shown.set(picture);
        request();
    }

    /** What walks, turns and keeps views. */
    public CameraHand hand() {
        return hand;
    }

    /** What plays the film of the camera's keyframes. */
    public CameraFilm film() {
        return film;
    }

    /** Moves the viewer along the film's path, which is no edit; the focus goes along. */
    void followPath(Camera seen) {
        Scene now = scene.get();
        Camera followed = seen.withKeyframes(now.camera().keyframes())
                .withAperture(now.camera().aperture());
        if (!followed.equals(now.camera())) {
            document.carryOn(now.withCamera(followed));
            show();
        }
    }

    /** Moves the viewer, which is no edit; the lens and the keyframes stay. */
    public void moveCamera(UnaryOperator<Camera> move) {
        Scene now = scene.get();
        Camera moved = CameraRig.of(now.camera()).on(move.apply(now.camera()));
        if (!moved.equals(now.camera())) {
            document.carryOn(now.withCamera(moved));
            show();
        }
    }

    /** Moves the viewer to a view, which is no edit; its lens comes along, the keyframes stay. */
    void goTo(Camera view) {
        Scene now = scene.get();
        document.carryOn(now.withCamera(view.withKeyframes(now.camera().keyframes())));
        show();
    }

    /** Draws with that engine as soon as it is ready. */
    public void chooseEngine(EngineOffer offer) {
        engine.set(new EngineChoice(engine.get().number() + 1, offer));
        request();
    }

    /** Shows another scene, and forgets the old one with its edits. */
    public void show(OpenedScene opened) {
        documents++;
        document = new SceneHistory(opened.scene());
        original.set(opened.scene());
        file.set(opened.file());
        selection.select(BodyNumber.NONE);
        motion.reset();
        show();
        film.startAnew();
        request();
    }

    /**
     * Shows a scene with edits of it that were not saved.
     *
     * @param before to which they are taken back
     */
    public void restore(OpenedScene before, Scene edited) {
        show(before);
        edit("restored changes", _ -> edited);
        endGesture();
        document.markUnsaved();
        show();
    }

    /** The number of the last request: a picture of it, or of a later one, is of what there is now. */
    public long lastRequest() {
        return requests;
    }

    /** Which one of the scenes that were opened this is; its edits have the same number. */
    public long document() {
        return documents;
    }

    /** The scene with its edits up to now. */
    public SceneHistory.Version present() {
        return document.version();
    }

    /** The scene as it is to be written, the camera where it is now; to be told of by {@link #saved}. */
    public SceneHistory.Version toSave() {
        document.endGesture();
        return document.version();
    }

    /** A scene was written to that file: the edits up to it are safe, those after it are not. */
    public void saved(SceneHistory.Version version, EditedFile target) {
        if (document.markSaved(version)) {
            file.set(target);
            edits.set(EditState.of(document));
        }
    }

    /** Makes a panorama that was read the sky; one that the scene has already is drawn as its file has it now. */
    public void useSky(Path panorama) {
        edit("sky", now -> now.withSky(now.sky().withFile(panorama)));
        endGesture();
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

    /**
     * Called in every pulse: walks and turns on, and takes over what the drawing thread has finished.
     *
     * @param nanos now, by {@link System#nanoTime}
     */
    public void pulse(long nanos) {
        double seconds = Math.clamp((nanos - lastPulseNanos) / NANOS_PER_SECOND, 0, LONGEST_STEP_SECONDS);
        lastPulseNanos = nanos;
        hand.pulse(seconds);
        film.pulse(seconds);
        loop.takeNewest().ifPresent(newest -> {
            frames.add(newest, displayMillis);
            picture.set(Optional.of(newest));
        });
        assets.takeWarnings().ifPresent(this::notice);
        if (assets.takeMeshesRead()) {
            request();
        }
        drawing.set(loop.status());
    }

    /** How long the interface's thread was busy in a pulse, up to the end of its layout. */
    public void noteDisplayMillis(double millis) {
        displayMillis = millis;
    }

    /** Lets the drawing thread end. */
    @Override
    public void close() {
        loop.close();
    }

    /** Waits for the drawing thread to end, after {@link #close}; whether it did. */
    public boolean awaitEnd(Duration limit) throws InterruptedException {
        return loop.awaitEnd(limit);
    }

    private void show() {
        document.carryOn(withCameraAbovePlane(document.present()));
        edits.set(EditState.of(document));
        if (!document.present().equals(scene.get())) {
            Scene before = scene.get();
            Scene now = document.present();
            if (before.spheres().size() != now.spheres().size()
                    || before.meshes().size() != now.meshes().size()) {
                numbered = requests + 1;
            }
            scene.set(now);
            selection.follow(before, now);
            // Views that are kept change no picture.
            if (!before.withViews(now.views()).equals(now)) {
                request();
            }
        }
    }

    private static Scene withCameraAbovePlane(Scene scene) {
        return scene.withCamera(CameraMotion.above(scene.camera(), scene.ground()));
    }

    /** Asks for a picture of what there is now. */
    void request() {
        if (viewWidth >= 1 && viewHeight >= 1) {
            requests++;
            PictureSize size = resolution.get().size(viewWidth, viewHeight);
            int refineTo = refining.get() ? RefinementGoal.samples(scene.get(), shown.get()) : 0;
            loop.request(new DrawingRequest(
                    requests,
                    documents,
                    scene.get(),
                    size.width(),
                    size.height(),
                    engine.get(),
                    refineTo,
                    motion.motionProperty().get(),
                    shown.get()));
        }
    }
}
