package dev.twister.gui;

import dev.twister.gui.bodies.AxisHandles;
import dev.twister.gui.bodies.BodyActions;
import dev.twister.gui.bodies.BodyMouse;
import dev.twister.gui.bodies.BoxSelection;
import dev.twister.gui.bodies.HandleMouse;
import dev.twister.gui.bodies.SelectionView;
import dev.twister.gui.bodies.TransformHandles;
import dev.twister.gui.bodies.TransformKeys;
import dev.twister.gui.camera.DopeSheet;
import dev.twister.gui.camera.FilmBar;
import dev.twister.gui.camera.KeyframeMenu;
import dev.twister.gui.camera.OrbitMouse;
import dev.twister.gui.controls.Command;
import dev.twister.gui.controls.CommandActions;
import dev.twister.gui.controls.Dialogs;
import dev.twister.gui.controls.Problems;
import dev.twister.gui.files.AssetActions;
import dev.twister.gui.files.AutosaveKeeper;
import dev.twister.gui.files.DropTarget;
import dev.twister.gui.files.FileActions;
import dev.twister.gui.files.FileNames;
import dev.twister.gui.files.Reading;
import dev.twister.gui.files.ReadingView;
import dev.twister.gui.files.SceneSaving;
import dev.twister.gui.files.SettingsKeeper;
import dev.twister.gui.files.TitleDialog;
import dev.twister.gui.gallery.SceneGallery;
import dev.twister.gui.model.BodyNumber;
import dev.twister.gui.model.BodyTransform;
import dev.twister.gui.model.ShownPictures;
import dev.twister.gui.model.WindowSettings;
import dev.twister.gui.panel.Panel;
import dev.twister.gui.panel.PanelEdge;
import dev.twister.gui.panel.PanelKeys;
import dev.twister.gui.panel.PanelWindow;
import dev.twister.gui.panel.SkyList;
import dev.twister.gui.picture.ClippingView;
import dev.twister.gui.picture.Comparison;
import dev.twister.gui.picture.Comparison.Mode;
import dev.twister.gui.picture.ExposureActions;
import dev.twister.gui.picture.FrameTimesView;
import dev.twister.gui.picture.HintLine;
import dev.twister.gui.picture.PathPick;
import dev.twister.gui.picture.PathTable;
import dev.twister.gui.picture.PathView;
import dev.twister.gui.picture.PictureActions;
import dev.twister.gui.picture.PictureView;
import dev.twister.gui.picture.PictureViewer;
import dev.twister.gui.picture.PixelInspector;
import dev.twister.gui.picture.SafeFrame;
import dev.twister.gui.picture.SplitView;
import dev.twister.gui.picture.ZoomMouse;
import dev.twister.gui.rendering.RenderActions;
import dev.twister.gui.studio.EngineList;
import dev.twister.gui.studio.Errands;
import dev.twister.gui.studio.Studio;
import dev.twister.gui.studio.TagActions;
import dev.twister.world.StageOrView;
import java.util.List;
import java.util.Optional;
import javafx.beans.property.BooleanProperty;
import javafx.beans.value.ObservableValue;
import javafx.geometry.Pos;
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
    private final SettingsKeeper settings;
    private final Reading reading;
    private final Errands errands = new Errands();
    private final FileActions files;
    private final SceneGallery gallery;
    private final SceneSaving saving;
    private final AssetActions assets;
    private final AutosaveKeeper autosaves;
    private final PictureActions pictures;
    private final RenderActions render;
    private final HelpWindows help;
    private final PictureViewer viewer;
    private final Panel panel;
    private final PanelWindow panelWindow;
    private final PixelInspector inspector;
    private final Comparison comparison;
    private final BodyActions bodies;
    private final TagActions tags;
    private final KeyframeMenu keyframes;
    private final TransformKeys transform;
    private final BoxSelection box;
    private final SafeFrame safeFrame;
    private final PathPick paths;
    private final BodyMouse bodyMouse;
    private final MenuView menu;
    private final FilmBar film;

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
            WindowOptions options) {
        this.stage = stage;
        this.studio = studio;
        this.picture = picture;
        this.frameTimes = frameTimes;
        this.reading = reading;
        settings = new SettingsKeeper(options.settings(), options.found(), errands, studio::notice);
        Dialogs dialogs = new Dialogs(stage);
        saving = new SceneSaving(
                studio, options.files(), options.shipped(), dialogs, settings, errands, this::takeTyped);
        assets = new AssetActions(studio, options.files(), dialogs, settings, reading);
        files = new FileActions(
                studio, options.files(), options.shipped(), dialogs, settings, reading, saving, assets, errands);
        gallery = new SceneGallery(stage, settings, files);
        autosaves = new AutosaveKeeper(studio, options.autosaves());
        pictures = new PictureActions(studio, options.files(), dialogs, errands);
        viewer = new PictureViewer(stage, studio, options.files(), dialogs, errands);
        help = new HelpWindows(stage);
        comparison = new Comparison(studio, studio.assets()::drawingLoop);
        middle.getChildren().add(1, new SplitView(picture, studio, comparison));
        bodies = new BodyActions(studio, errands);
        tags = new TagActions(studio);
        keyframes = new KeyframeMenu(picture, studio);
        transform = TransformKeys.install(middle, picture, studio);
        box = new BoxSelection(middle, picture, studio);
        safeFrame = new SafeFrame(picture, studio);
        picture.addOverlay(safeFrame);
        inspector = new PixelInspector(picture, studio, errands);
        StackPane.setAlignment(inspector, Pos.TOP_RIGHT);
        paths = new PathPick(studio);
        PathTable table = new PathTable(paths);
        StackPane.setAlignment(table, Pos.BOTTOM_CENTER);
        middle.getChildren().addAll(inspector, table);
        String usualEngine = studio.engineProperty().get().offer().id();
        EngineList engines = EngineList.load(studio, errands);
        render = new RenderActions(stage, studio, engines, options.files(), dialogs);
        CommandActions actions = actions(() -> Panel.resetAll(studio, engines, usualEngine));
        ClippingView clipping = new ClippingView(picture, studio);
        picture.addOverlay(clipping);
        ExposureActions exposure = new ExposureActions(studio, errands);
        actions.on(Command.AUTO_EXPOSURE, exposure::setAutomatically)
                .on(
                        Command.CLIPPING,
                        () -> clipping.shownProperty()
                                .set(!clipping.shownProperty().get()));
        panel = new Panel(studio, engines, comparison, clipping.shownProperty(), assets, tags, errands, actions);
        panel.foldAsKept(settings);
        HBox side = new HBox(panel);
        panelWindow = new PanelWindow(stage, panel, side, picture, settings);
        side.getChildren().addFirst(new PanelEdge(panel, panelWindow.dockedProperty(), settings));
        menu = new MenuView(studio, settings, files, actions, bodies::insert);
        pictures.recorderProperty().subscribe(recorder -> menu.showRecording(recorder.isPresent()));
        menu.check(Command.INSPECT, inspector.visibleProperty());
        menu.check(Command.COMPARE, comparison.modeProperty().map(mode -> mode != Mode.OFF));
        menu.check(Command.EXPLAIN, paths.pathProperty().map(Optional::isPresent));
        menu.check(Command.CLIPPING, clipping.shownProperty());
        menu.check(Command.Q_UP, qUpProperty());
        menu.check(Command.PANEL, panel.visibleProperty());
        menu.check(Command.FLOAT_PANEL, panelWindow.floatingProperty());
        menu.check(Command.FRAME_TIMES, frameTimes.visibleProperty());
        menu.check(Command.FULL_SCREEN, stage.fullScreenProperty());
        menu.explainKeys(root.getScene(), studio);
        film = new FilmBar(studio, actions, this::focusPicture);
        menu.check(Command.SAFE_FRAME, safeFrame.shownProperty());
        menu.check(Command.LOCK_CAMERA, studio.document().cameraLockedProperty());
        menu.check(Command.PLAY, studio.film().playingProperty());
        menu.check(Command.FILM, film.visibleProperty());
        root.setTop(menu);
        root.setBottom(new VBox(film, new DopeSheet(studio, film), root.getBottom()));
        root.setRight(side);
        AxisHandles handles = new AxisHandles(picture, studio, paths);
        TransformHandles transforms = new TransformHandles(picture, studio, handles);
        HandleMouse.install(middle, picture, studio, transforms, stage.focusedProperty());
        SelectionView outline = new SelectionView(picture, studio, List.of(transforms, handles));
        picture.addOverlay(outline);
        ZoomMouse.install(picture);
        OrbitMouse.install(picture, studio);
        picture.addOverlay(new PathView(picture, studio, paths));
        bodyMouse = BodyMouse.install(picture, studio, paths, handles, stage.focusedProperty());
        bodyMouse.axisProperty().subscribe(outline::showAxis);
        bodyMouse.axisProperty().subscribe(handles::point);
        handles.onProperty().bind(settings.settingsProperty().map(kept -> kept.get(WindowSettings.AXIS_HANDLES)));
        menu.check(Command.AXIS_HANDLES, handles.onProperty());
        PanelKeys.leadBack(panel, this::focusPicture);
        for (Scene scene : List.of(root.getScene(), panelWindow.scene())) {
            PanelKeys.install(scene, panel, () -> showPanel(true));
            DropTarget.install(scene, files);
        }
        errands.run(
                () -> SkyList.in(options.shipped().skyboxes()),
                panel::offerSkies,
                problem -> studio.notice(Problems.explain(problem)));
        if (!settings.settings().get(WindowSettings.HINT_SEEN)) {
            HintLine hint =
                    new HintLine(picture, () -> settings.change(kept -> kept.with(WindowSettings.HINT_SEEN, true)));
            StackPane.setAlignment(hint, Pos.BOTTOM_CENTER);
            middle.getChildren().add(hint);
        }
        restore();
        stage.setMinHeight(LEAST_HEIGHT);
        panelWindow.dockedProperty().subscribe(_ -> limitWidth());
        // Style sheets say it, in the text's size.
        panel.minWidthProperty().subscribe(_ -> limitWidth());
        options.asked().ifPresent(settings::remember);
        studio.engineProperty()
                .subscribe((_, choice) -> settings.change(
                        kept -> kept.with(WindowSettings.ENGINE, choice.offer().id())));
        studio.document().editsProperty().subscribe(_ -> showTitle());
        studio.document().fileProperty().subscribe(_ -> showTitle());
        stage.setOnCloseRequest(this::closeOnceSaved);
        autosaves.offer(dialogs, files);
        stage.setFullScreenExitKeyCombination(KeyCombination.NO_MATCH);
        stage.setFullScreenExitHint("");
    }

    /** Called in every pulse. */
    void pulse(long nanos) {
        pictures.pulse();
        render.pulse();
        autosaves.pulse(nanos);
        panel.pulse(nanos);
        inspector.pulse();
        comparison.pulse(nanos);
    }

    /** Whether something goes on that is shown in every pulse. */
    boolean isBusy() {
        return comparison.isOn() || pictures.recorderProperty().get().isPresent();
    }

    /** Gives the picture the focus, whichever window has it. */
    private void focusPicture() {
        stage.requestFocus();
        picture.requestFocus();
    }

    private void startTransform(BodyTransform.Mode mode) {
        stage.requestFocus();
        transform.start(mode);
    }

    /** Keeps the settings, and begins nothing more; {@link #awaitFiles} waits for what is still being written. */
    @Override
    public void close() {
        boolean filling = stage.isMaximized() || stage.isFullScreen();
        int width = (int) stage.getWidth();
        int height = (int) stage.getHeight();
        settings.change(
                kept -> (filling ? kept : kept.withSize(width, height)).with(WindowSettings.MAXIMIZED, filling));
        panelWindow.close();
        settings.write();
        help.close();
        gallery.close();
        comparison.close();
        pictures.finish();
        render.finish();
        autosaves.finish();
        reading.cancel();
        errands.finish();
        menu.dismantle();
    }

    /**
     * Waits until a recording's last frames and all other files are written; called after {@link #close}, by any
     * thread.
     */
    void awaitFiles() {
        pictures.close();
        render.close();
        errands.close();
        autosaves.close();
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
        return settings.settingsProperty().map(kept -> kept.get(WindowSettings.Q_UP));
    }

    Comparison comparison() {
        return comparison;
    }

    FileActions files() {
        return files;
    }

    SceneSaving saving() {
        return saving;
    }

    SettingsKeeper settings() {
        return settings;
    }

    private static void toggle(BooleanProperty on) {
        on.set(!on.get());
    }

    private void toggleLock() {
        BooleanProperty locked = studio.document().cameraLockedProperty();
        toggle(locked);
        studio.notice(locked.get() ? "The camera is locked" : "The camera is free");
    }

    private CommandActions actions(Runnable resetAll) {
        return new CommandActions()
                .on(Command.NEW, files::newScene)
                .on(Command.GALLERY, gallery::show)
                .on(Command.OPEN, files::open)
                .on(Command.SAVE, saving::save)
                .on(Command.SAVE_AS, saving::saveAs)
                .on(Command.TITLE, () -> TitleDialog.show(stage, studio))
                .on(Command.VIEW_PICTURE, viewer::open)
                .on(Command.SCREENSHOT, pictures::screenshot)
                .on(Command.RENDER, render::show)
                .on(Command.RECORD, pictures::toggleRecording)
                .on(Command.QUIT, this::closeOnceSaved)
                .on(Command.UNDO, studio::undo)
                .on(Command.REDO, studio::redo)
                .on(Command.REDO_ALSO, studio::redo)
                .on(Command.INSERT, bodies::insert)
                .on(Command.INSERT_MESH, assets::insertMesh)
                .on(Command.INSERT_LIGHT, bodies::insertLight)
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
                .on(Command.INVERT, studio.selection()::invert)
                .on(Command.SAME_MATERIAL, studio.selection()::selectSameMaterial)
                .on(Command.BOX, box::arm)
                .on(Command.SAFE_FRAME, () -> toggle(safeFrame.shownProperty()))
                .on(Command.LOCK_CAMERA, this::toggleLock)
                .on(Command.SELECT_ALL, studio.selection()::selectAll)
                .on(Command.NEXT, () -> bodies.selectAlong(1))
                .on(Command.PREVIOUS, () -> bodies.selectAlong(-1))
                .on(Command.DESELECT, this::backToThePicture)
                .on(Command.RESET, resetAll)
                .on(Command.NEXT_SHOWN, () -> showAlong(1))
                .on(Command.PREVIOUS_SHOWN, () -> showAlong(-1))
                .on(Command.INSPECT, () -> inspector.setVisible(!inspector.isVisible()))
                .on(Command.EXPLAIN, () -> bodyMouse.togglePath())
                .on(Command.COMPARE, this::toggleComparison)
                .on(Command.ZOOM_IN, () -> picture.zoom(ZoomMouse.STEP))
                .on(Command.ZOOM_OUT, () -> picture.zoom(1 / ZoomMouse.STEP))
                .on(Command.ZOOM_TO_FIT, picture::zoomToFit)
                .on(Command.PANEL, () -> showPanel(!panel.isVisible()))
                .on(Command.FLOAT_PANEL, this::toggleFloating)
                .on(Command.FRAME_TIMES, () -> showFrameTimes(!frameTimes.isVisible()))
                .on(Command.MOVE, () -> studio.motion().setOn(!studio.motion().isOn()))
                .on(Command.FRAME, bodies::frameSelected)
                .on(Command.FRAME_ALSO, bodies::frameSelected)
                .on(
                        Command.Q_UP,
                        () -> settings.change(kept -> kept.with(WindowSettings.Q_UP, !kept.get(WindowSettings.Q_UP))))
                .on(
                        Command.AXIS_HANDLES,
                        () -> settings.change(
                                kept -> kept.with(WindowSettings.AXIS_HANDLES, !kept.get(WindowSettings.AXIS_HANDLES))))
                .on(Command.PAUSE, studio.motion()::togglePause)
                .on(Command.STEP, studio.motion()::stepOnce)
                .on(Command.RANDOMIZE, bodies::randomize)
                .on(Command.FULL_SCREEN, () -> stage.setFullScreen(!stage.isFullScreen()))
                .on(Command.PLAY, studio.film()::togglePlaying)
                .on(Command.SET_KEYFRAME, studio.film()::setKeyframe)
                .on(Command.DELETE_KEYFRAME, studio.film()::deleteKeyframe)
                .on(Command.SET_KEYFRAME_OF, keyframes::show)
                .on(Command.DELETE_KEYFRAME_OF, keyframes::delete)
                .on(Command.NEXT_KEYFRAME, () -> studio.film().goAlong(true))
                .on(Command.PREVIOUS_KEYFRAME, () -> studio.film().goAlong(false))
                .on(Command.FILM, () -> studio.film().shownProperty().set(!film.isVisible()))
                .on(Command.CONTROLS, () -> help.showControls(panel.rows()))
                .on(Command.ABOUT, help::showAbout);
    }

    private void restore() {
        Rectangle2D screen = Screen.getPrimary().getVisualBounds();
        stage.setWidth(Math.min(settings.settings().get(WindowSettings.WIDTH), screen.getWidth()));
        stage.setHeight(Math.min(settings.settings().get(WindowSettings.HEIGHT), screen.getHeight()));
        if (Double.isNaN(stage.getY())) {
            // Where a window is as high as the screen, JavaFX would have its upper border above it.
            stage.setX(screen.getMinX() + (screen.getWidth() - stage.getWidth()) / 2);
            stage.setY(screen.getMinY() + (screen.getHeight() - stage.getHeight()) / 2);
        }
        stage.setMaximized(settings.settings().get(WindowSettings.MAXIMIZED));
        panelWindow.setFloating(settings.settings().get(WindowSettings.PANEL_FLOATS));
        showPanel(settings.settings().get(WindowSettings.PANEL_SHOWN));
        showFrameTimes(settings.settings().get(WindowSettings.FRAME_TIMES_SHOWN));
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
        settings.change(kept -> kept.with(WindowSettings.PANEL_SHOWN, shown));
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
        settings.change(kept -> kept.with(WindowSettings.FRAME_TIMES_SHOWN, shown));
    }

    private void toggleComparison() {
        comparison.modeProperty().set(comparison.isOn() ? Mode.OFF : Mode.SPLIT);
    }

    private void showAlong(int steps) {
        StageOrView next = ShownPictures.along(studio.shownProperty().get(), steps);
        studio.setShown(next);
        studio.notice(ShownPictures.label(next));
    }

    private void backToThePicture() {
        if (ReadingView.isReading(studio, reading)) {
            ReadingView.cancel(studio, reading);
        } else if (picture.isFocused() && paths.isShown()) {
            paths.clear();
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
        render.beforeClosing(() -> saving.afterSaving(stage::hide));
    }

    private boolean takeTyped() {
        return panel.takeTyped();
    }

    private void showTitle() {
        String name = FileNames.name(studio.document().file());
        stage.setTitle((studio.document().editsProperty().get().changed() ? "• " : "") + name + " – Twister");
    }
}
