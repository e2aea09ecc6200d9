package dev.twister.gui;

import dev.twister.gui.bodies.BodyActions;
import dev.twister.gui.camera.DopeSheet;
import dev.twister.gui.camera.FilmBar;
import dev.twister.gui.camera.KeyframeMenu;
import dev.twister.gui.controls.Command;
import dev.twister.gui.controls.CommandActions;
import dev.twister.gui.controls.Dialogs;
import dev.twister.gui.drawing.DrawingRequest.Motion;
import dev.twister.gui.drawing.StagesAndViews;
import dev.twister.gui.edit.BodyNumber;
import dev.twister.gui.edit.BodyTransform;
import dev.twister.gui.files.DroppedFile;
import dev.twister.gui.files.FileActions;
import dev.twister.gui.files.FileNames;
import dev.twister.gui.files.Reading;
import dev.twister.gui.files.ReadingView;
import dev.twister.gui.files.SceneSaving;
import dev.twister.gui.files.SettingsKeeper;
import dev.twister.gui.files.TitleDialog;
import dev.twister.gui.files.WindowSettings;
import dev.twister.gui.panel.Panel;
import dev.twister.gui.panel.PanelWindow;
import dev.twister.gui.picture.Comparison;
import dev.twister.gui.picture.Comparison.Mode;
import dev.twister.gui.picture.FrameTimesView;
import dev.twister.gui.picture.PictureView;
import dev.twister.gui.picture.PictureZoom;
import dev.twister.gui.rendering.RenderActions;
import dev.twister.gui.studio.BackgroundTasks;
import dev.twister.gui.studio.Denoising;
import dev.twister.gui.studio.EngineList;
import dev.twister.gui.studio.Film;
import dev.twister.gui.studio.MotionControl;
import dev.twister.gui.studio.Studio;
import dev.twister.gui.studio.TagActions;
import dev.twister.scene.light.LightShape;
import dev.twister.world.StageOrView;
import java.util.List;
import java.util.Optional;
import javafx.beans.property.BooleanProperty;
import javafx.beans.value.ObservableValue;
import javafx.geometry.Rectangle2D;
import javafx.scene.Node;
import javafx.scene.Scene;
import javafx.scene.input.KeyCombination;
import javafx.scene.layout.BorderPane;
import javafx.scene.layout.HBox;
import javafx.scene.layout.StackPane;
import javafx.scene.layout.VBox;
import javafx.stage.Screen;
import javafx.stage.Stage;
import javafx.stage.WindowEvent;

/** Menu, panel, dialogs, and what is kept between runs: all of the window around the picture. */
final class Workbench implements AutoCloseable {
    /** The width left for the picture when the panel is shown. */
    private static final double LEAST_PICTURE = 240;

    private static final double LEAST_HEIGHT = 240;

    private final Stage stage;
    private final Studio studio;
    private final PictureView picture;
    private final FrameTimesView frameTimes;
    private final Reading reading;
    private final BackgroundTasks tasks = new BackgroundTasks();
    private final FileTools files;
    private final PictureTools tools;
    private final BodyActions bodies;
    private final TagActions tags;
    private final KeyframeMenu keyframes;
    private final RenderActions render;
    private final HelpWindows help;
    private final Panel panel;
    private final PanelWindow panelWindow;
    private final MenuView menu;

    /**
     * Puts the menu at the root's top, the panel at its right, and the keyframes above what is at its bottom.
     *
     * @param root of the stage's scene
     * @param middle of the root, with the picture; what is said of the picture is laid over it
     * @param reading reads the files that are opened
     */
    Workbench(
            Stage stage,
            BorderPane root,
            StackPane middle,
            PictureView picture,
            FrameTimesView frameTimes,
            Studio studio,
            Reading reading,
            MainWindow.Options options) {
        this.stage = stage;
        this.studio = studio;
        this.picture = picture;
        this.frameTimes = frameTimes;
        this.reading = reading;
        files = FileTools.of(stage, studio, options, reading, tasks, this::takeTyped);
        tools = PictureTools.over(middle, picture, studio, settings(), tasks, stage.focusedProperty());
        help = new HelpWindows(stage);
        bodies = new BodyActions(studio, tasks);
        tags = new TagActions(studio);
        keyframes = new KeyframeMenu(picture, studio);
        String usualEngine = studio.engineProperty().get().offer().id();
        EngineList engines = EngineList.load(studio, tasks);
        render = new RenderActions(stage, studio, engines, options.files(), files.dialogs());
        CommandActions actions = new CommandActions();
        panel = new Panel(
                studio,
                engines,
                tools.comparison(),
                tools.clipping().shownProperty(),
                files.assets(),
                tags,
                tasks,
                actions);
        panel.foldAsKept(settings());
        HBox side = new HBox(panel);
        panelWindow = new PanelWindow(stage, panel, side, picture, settings());
        bind(actions);
        actions.on(Command.RESET, () -> Panel.resetAll(studio, tasks, engines, usualEngine));
        menu = new MenuView(studio, settings(), files.files(), actions, bodies::insert);
        putAround(root, side, new FilmBar(studio, actions, this::focusPicture));
        tasks.run(options.shipped()::skies, panel::offerSkies, problem -> studio.notice(Dialogs.explain(problem)));
        restore();
        keepUpToDate();
        options.asked().ifPresent(settings()::remember);
        files.autosaves().offer(files.dialogs(), files.files());
    }

    /** Puts all that surrounds the picture in its place, and has keys and dropped files come there. */
    private void putAround(BorderPane root, HBox side, FilmBar film) {
        root.setTop(menu);
        root.setBottom(new VBox(film, new DopeSheet(studio, film), root.getBottom()));
        root.setRight(side);
        menu.explainKeys(root.getScene(), studio);
        panel.leadBack(this::focusPicture);
        for (Scene scene : List.of(root.getScene(), panelWindow.scene())) {
            panel.followKeys(scene, () -> showPanel(true));
            DroppedFile.accept(scene, files.files()::drop);
        }
    }

    /** Keeps the window's limits, title and settings as the scene and the panel are. */
    private void keepUpToDate() {
        stage.setMinHeight(LEAST_HEIGHT);
        stage.setOnCloseRequest(this::closeOnceSaved);
        stage.setFullScreenExitKeyCombination(KeyCombination.NO_MATCH);
        stage.setFullScreenExitHint("");
        files.pictures().recorderProperty().subscribe(recorder -> menu.showRecording(recorder.isPresent()));
        panelWindow.dockedProperty().subscribe(_ -> limitWidth());
        // Style sheets say it, in the text's size.
        panel.minWidthProperty().subscribe(_ -> limitWidth());
        studio.engineProperty()
                .subscribe((_, choice) -> settings()
                        .change(kept ->
                                kept.with(WindowSettings.ENGINE, choice.offer().id())));
        if (settings().settings().get(WindowSettings.DENOISED)) {
            Denoising.start(studio, tasks, _ -> {});
        }
        studio.denoiserProperty()
                .subscribe((_, denoiser) ->
                        settings().change(kept -> kept.with(WindowSettings.DENOISED, denoiser.isPresent())));
        studio.document().editsProperty().subscribe(_ -> showTitle());
        studio.document().fileProperty().subscribe(_ -> showTitle());
    }

    /** Called in every pulse. */
    void pulse(long nanos) {
        files.pictures().pulse();
        render.pulse();
        files.autosaves().pulse(nanos);
        panel.pulse(nanos);
        tools.inspector().pulse();
        comparison().pulse(nanos);
    }

    /** Whether something goes on that is shown in every pulse. */
    boolean isBusy() {
        return comparison().isOn() || files.pictures().recorderProperty().get().isPresent();
    }

    /** Gives the picture the focus, whichever window has it. */
    private void focusPicture() {
        stage.requestFocus();
        picture.requestFocus();
    }

    private void startTransform(BodyTransform.Mode mode) {
        stage.requestFocus();
        tools.transform().start(mode);
    }

    /** Keeps the settings, and begins nothing more; {@link #awaitFiles} waits for what is still being written. */
    @Override
    public void close() {
        boolean filling = stage.isMaximized() || stage.isFullScreen();
        int width = (int) stage.getWidth();
        int height = (int) stage.getHeight();
        settings()
                .change(kept ->
                        (filling ? kept : kept.withSize(width, height)).with(WindowSettings.MAXIMIZED, filling));
        panelWindow.close();
        settings().write();
        help.close();
        files.gallery().close();
        comparison().close();
        files.pictures().finish();
        render.finish();
        files.autosaves().finish();
        reading.cancel();
        tasks.finish();
        menu.dismantle();
    }

    /**
     * Waits until a recording's last frames and all other files are written; called after {@link #close}, by any
     * thread.
     */
    void awaitFiles() {
        files.pictures().close();
        render.close();
        tasks.close();
        files.autosaves().close();
    }

    /** The progress of renderings, for the status line. */
    Node renderStatus() {
        return render.status();
    }

    Panel panel() {
        return panel;
    }

    PanelWindow panelWindow() {
        return panelWindow;
    }

    /** See {@link WindowSettings#Q_UP}. */
    ObservableValue<Boolean> qUpProperty() {
        return settings().settingsProperty().map(kept -> kept.get(WindowSettings.Q_UP));
    }

    Comparison comparison() {
        return tools.comparison();
    }

    FileActions files() {
        return files.files();
    }

    SceneSaving saving() {
        return files.saving();
    }

    SettingsKeeper settings() {
        return files.settings();
    }

    private void toggleLock() {
        BooleanProperty locked = studio.document().cameraLockedProperty();
        locked.set(!locked.get());
        studio.notice(locked.get() ? "The camera is locked" : "The camera is free");
    }

    private void bind(CommandActions actions) {
        bindFile(actions);
        bindEdit(actions);
        bindView(actions);
        bindMotion(actions);
    }

    private void bindFile(CommandActions actions) {
        actions.on(Command.NEW, files.files()::newScene)
                .on(Command.GALLERY, files.gallery()::show)
                .on(Command.OPEN, files.files()::open)
                .on(Command.SAVE, saving()::save)
                .on(Command.SAVE_AS, saving()::saveAs)
                .on(Command.TITLE, () -> TitleDialog.show(stage, studio))
                .on(Command.VIEW_PICTURE, files.viewer()::open)
                .on(Command.SCREENSHOT, files.pictures()::screenshot)
                .on(Command.RENDER, render::show)
                .on(Command.RECORD, files.pictures()::toggleRecording)
                .on(Command.QUIT, this::closeOnceSaved)
                .on(Command.CONTROLS, () -> help.showControls(panel.rows()))
                .on(Command.ABOUT, help::showAbout);
    }

    private void bindEdit(CommandActions actions) {
        actions.on(Command.UNDO, studio::undo)
                .on(Command.REDO, studio::redo)
                .on(Command.REDO_ALSO, studio::redo)
                .on(Command.INSERT, bodies::insert)
                .on(Command.INSERT_MESH, files.assets()::insertMesh)
                .on(Command.INSERT_LIGHT, () -> bodies.insert(LightShape.Kind.SPHERE))
                .on(Command.INSERT_SUN, () -> bodies.insert(LightShape.Kind.SUN))
                .on(Command.INSERT_SPOT, () -> bodies.insert(LightShape.Kind.SPOT))
                .on(Command.DUPLICATE, bodies::duplicate)
                .on(Command.COPY, bodies::copy)
                .on(Command.PASTE, bodies::paste)
                .on(Command.DELETE, bodies::delete)
                .on(Command.DROP, bodies::drop)
                .on(Command.GRAB, () -> startTransform(BodyTransform.Mode.MOVE))
                .on(Command.ROTATE, () -> startTransform(BodyTransform.Mode.ROTATE))
                .on(Command.SCALE, () -> startTransform(BodyTransform.Mode.SCALE))
                .on(Command.HIDE, tags::hide)
                .on(Command.SHOW_ALL, tags::showAll)
                .on(Command.LOCK, tags::toggleLock)
                .on(Command.GROUP, tags::group)
                .on(Command.UNGROUP, tags::ungroup)
                .on(Command.SELECT_GROUP, tags::selectGroup)
                .on(Command.SELECT_ALL, studio.selection()::selectAll)
                .on(Command.INVERT, studio.selection()::invert)
                .on(Command.SAME_MATERIAL, studio.selection()::selectSameMaterial)
                .on(Command.BOX, tools.box()::arm)
                .on(Command.NEXT, () -> bodies.selectAlong(1))
                .on(Command.PREVIOUS, () -> bodies.selectAlong(-1))
                .on(Command.DESELECT, this::backToThePicture)
                .on(Command.AUTO_EXPOSURE, files.pictures()::setExposure);
    }

    private void bindView(CommandActions actions) {
        actions.on(Command.NEXT_SHOWN, () -> showAlong(1))
                .on(Command.PREVIOUS_SHOWN, () -> showAlong(-1))
                .on(Command.INSPECT, tools.inspector().visibleProperty())
                .on(
                        Command.EXPLAIN,
                        tools.bodyMouse()::togglePath,
                        tools.paths().pathProperty().map(Optional::isPresent))
                .on(
                        Command.COMPARE,
                        this::toggleComparison,
                        comparison().modeProperty().map(mode -> mode != Mode.OFF))
                .on(Command.CLIPPING, tools.clipping().shownProperty())
                .on(Command.ZOOM_IN, () -> picture.zoom(PictureZoom.STEP))
                .on(Command.ZOOM_OUT, () -> picture.zoom(1 / PictureZoom.STEP))
                .on(Command.ZOOM_TO_FIT, picture::zoomToFit)
                .on(Command.FRAME, bodies::frameSelected)
                .on(Command.FRAME_ALSO, bodies::frameSelected)
                .on(Command.Q_UP, () -> toggle(WindowSettings.Q_UP), qUpProperty())
                .on(
                        Command.AXIS_HANDLES,
                        () -> toggle(WindowSettings.AXIS_HANDLES),
                        tools.handles().onProperty())
                .on(Command.PANEL, () -> showPanel(!panel.isVisible()), panel.visibleProperty())
                .on(Command.FLOAT_PANEL, this::toggleFloating, panelWindow.floatingProperty())
                .on(Command.SAFE_FRAME, tools.safeFrame().shownProperty())
                .on(Command.LOCK_CAMERA, this::toggleLock, studio.document().cameraLockedProperty())
                .on(Command.FRAME_TIMES, () -> showFrameTimes(!frameTimes.isVisible()), frameTimes.visibleProperty())
                .on(Command.FULL_SCREEN, () -> stage.setFullScreen(!stage.isFullScreen()), stage.fullScreenProperty());
    }

    private void bindMotion(CommandActions actions) {
        MotionControl motion = studio.motion();
        Film film = studio.film();
        actions.on(
                        Command.MOVE,
                        () -> motion.setOn(!motion.isOn()),
                        motion.motionProperty().map(Motion::isOn))
                .on(
                        Command.PAUSE,
                        motion::togglePause,
                        motion.motionProperty().map(now -> now.isOn() && !now.running()))
                .on(Command.STEP, motion::stepOnce)
                .on(Command.RANDOMIZE, bodies::randomize)
                .on(Command.PLAY, film::togglePlaying, film.playingProperty())
                .on(Command.SET_KEYFRAME, film::setKeyframe)
                .on(Command.DELETE_KEYFRAME, film::deleteKeyframe)
                .on(Command.SET_KEYFRAME_OF, keyframes::show)
                .on(Command.DELETE_KEYFRAME_OF, keyframes::delete)
                .on(Command.NEXT_KEYFRAME, () -> film.goAlong(true))
                .on(Command.PREVIOUS_KEYFRAME, () -> film.goAlong(false))
                .on(Command.FILM, film.shownProperty());
    }

    private void toggle(WindowSettings.Key<Boolean> key) {
        settings().change(kept -> kept.with(key, !kept.get(key)));
    }

    private void restore() {
        Rectangle2D screen = Screen.getPrimary().getVisualBounds();
        stage.setWidth(Math.min(settings().settings().get(WindowSettings.WIDTH), screen.getWidth()));
        stage.setHeight(Math.min(settings().settings().get(WindowSettings.HEIGHT), screen.getHeight()));
        if (Double.isNaN(stage.getY())) {
            // Where a window is as high as the screen, JavaFX would have its upper border above it.
            stage.setX(screen.getMinX() + (screen.getWidth() - stage.getWidth()) / 2);
            stage.setY(screen.getMinY() + (screen.getHeight() - stage.getHeight()) / 2);
        }
        stage.setMaximized(settings().settings().get(WindowSettings.MAXIMIZED));
        panelWindow.setFloating(settings().settings().get(WindowSettings.PANEL_FLOATS));
        showPanel(settings().settings().get(WindowSettings.PANEL_SHOWN));
        showFrameTimes(settings().settings().get(WindowSettings.FRAME_TIMES_SHOWN));
    }

    /** The panel hides no picture. */
    private void limitWidth() {
        double beside = panelWindow.dockedProperty().getValue() ? Math.max(0, panel.getMinWidth()) : 0;
        stage.setMinWidth(Math.min(Screen.getPrimary().getVisualBounds().getWidth(), beside + LEAST_PICTURE));
    }

    private void showPanel(boolean shown) {
        panel.setVisible(shown);
        panel.setManaged(shown);
        if (!shown) {
            focusPicture();
        }
        settings().change(kept -> kept.with(WindowSettings.PANEL_SHOWN, shown));
    }

    private void toggleFloating() {
        boolean floats = !panelWindow.floatingProperty().get();
        if (floats) {
            showPanel(true);
        }
        panelWindow.setFloating(floats);
        focusPicture();
    }

    private void showFrameTimes(boolean shown) {
        frameTimes.setVisible(shown);
        settings().change(kept -> kept.with(WindowSettings.FRAME_TIMES_SHOWN, shown));
    }

    private void toggleComparison() {
        comparison().modeProperty().set(comparison().isOn() ? Mode.OFF : Mode.SPLIT);
    }

    private void showAlong(int steps) {
        StageOrView next = StagesAndViews.along(studio.shownProperty().get(), steps);
        studio.setShown(next);
        studio.notice(StagesAndViews.label(next));
    }

    private void backToThePicture() {
        if (ReadingView.isReading(studio, reading)) {
            ReadingView.cancel(studio, reading);
        } else if (picture.isFocused() && tools.paths().isShown()) {
            tools.paths().clear();
        } else if (picture.isFocused()) {
            studio.selection().select(BodyNumber.NONE);
        } else {
            focusPicture();
        }
    }

    private void closeOnceSaved(WindowEvent event) {
        event.consume();
        closeOnceSaved();
    }

    private void closeOnceSaved() {
        render.beforeClosing(() -> saving().afterSaving(stage::hide));
    }

    private boolean takeTyped() {
        return panel.takeTyped();
    }

    private void showTitle() {
        String name = FileNames.name(studio.document().file());
        stage.setTitle((studio.document().editsProperty().get().changed() ? "• " : "") + name + " – Twister");
    }
}
