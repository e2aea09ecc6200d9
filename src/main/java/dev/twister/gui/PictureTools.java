package dev.twister.gui;

import dev.twister.gui.bodies.AxisHandles;
import dev.twister.gui.bodies.BodyMouse;
import dev.twister.gui.bodies.BoxSelection;
import dev.twister.gui.bodies.HandleMouse;
import dev.twister.gui.bodies.SelectionView;
import dev.twister.gui.bodies.TransformHandles;
import dev.twister.gui.bodies.TransformKeys;
import dev.twister.gui.camera.OrbitMouse;
import dev.twister.gui.files.SettingsKeeper;
import dev.twister.gui.files.WindowSettings;
import dev.twister.gui.picture.ClippingView;
import dev.twister.gui.picture.Comparison;
import dev.twister.gui.picture.PathPick;
import dev.twister.gui.picture.PathTable;
import dev.twister.gui.picture.PathView;
import dev.twister.gui.picture.PictureView;
import dev.twister.gui.picture.PictureZoom;
import dev.twister.gui.picture.PixelInspector;
import dev.twister.gui.picture.SafeFrame;
import dev.twister.gui.picture.SplitView;
import dev.twister.gui.studio.BackgroundTasks;
import dev.twister.gui.studio.Studio;
import java.util.List;
import javafx.beans.property.ReadOnlyBooleanProperty;
import javafx.geometry.Pos;
import javafx.scene.control.Button;
import javafx.scene.control.Label;
import javafx.scene.input.KeyEvent;
import javafx.scene.input.MouseEvent;
import javafx.scene.input.ScrollEvent;
import javafx.scene.layout.HBox;
import javafx.scene.layout.StackPane;

/** What lies over the picture and listens to the pointer there: the selection, its handles, paths and marks. */
record PictureTools(
        Comparison comparison,
        TransformKeys transform,
        BoxSelection box,
        SafeFrame safeFrame,
        PixelInspector inspector,
        PathPick paths,
        ClippingView clipping,
        AxisHandles handles,
        BodyMouse bodyMouse) {
    /**
     * Lays the tools over a picture. What comes first gets the pointer's events first, and lies below what comes later.
     *
     * @param middle has the picture as its first child
     * @param focused whether the window has the focus
     */
    static PictureTools over(
            StackPane middle,
            PictureView picture,
            Studio studio,
            SettingsKeeper settings,
            BackgroundTasks tasks,
            ReadOnlyBooleanProperty focused) {
        Comparison comparison = new Comparison(studio, studio.assets()::drawingLoop);
        middle.getChildren().add(1, new SplitView(picture, studio, comparison));
        TransformKeys transform = TransformKeys.install(middle, picture, studio);
        BoxSelection box = new BoxSelection(middle, picture, studio);
        SafeFrame safeFrame = new SafeFrame(picture, studio);
        picture.addOverlay(safeFrame);
        PixelInspector inspector = new PixelInspector(picture, studio, tasks);
        StackPane.setAlignment(inspector, Pos.TOP_RIGHT);
        PathPick paths = new PathPick(studio);
        PathTable table = new PathTable(paths);
        StackPane.setAlignment(table, Pos.BOTTOM_CENTER);
        middle.getChildren().addAll(inspector, table);
        ClippingView clipping = new ClippingView(picture, studio);
        picture.addOverlay(clipping);
        AxisHandles handles = new AxisHandles(picture, studio, paths);
        handles.onProperty().bind(settings.settingsProperty().map(kept -> kept.get(WindowSettings.AXIS_HANDLES)));
        TransformHandles transforms = new TransformHandles(picture, studio, handles);
        HandleMouse.install(middle, picture, studio, transforms, focused);
        SelectionView outline = new SelectionView(picture, studio, List.of(transforms, handles));
        picture.addOverlay(outline);
        PictureZoom.install(picture);
        OrbitMouse.install(picture, studio);
        picture.addOverlay(new PathView(picture, studio, paths));
        BodyMouse bodyMouse = BodyMouse.install(picture, studio, paths, handles, focused);
        bodyMouse.axisProperty().subscribe(outline::showAxis);
        bodyMouse.axisProperty().subscribe(handles::point);
        if (!settings.settings().get(WindowSettings.HINT_SEEN)) {
            HintLine hint =
                    new HintLine(picture, () -> settings.change(kept -> kept.with(WindowSettings.HINT_SEEN, true)));
            StackPane.setAlignment(hint, Pos.BOTTOM_CENTER);
            middle.getChildren().add(hint);
        }
        return new PictureTools(comparison, transform, box, safeFrame, inspector, paths, clipping, handles, bodyMouse);
    }

    /** What a newcomer needs first, over the picture's lower edge, until the picture is used for the first time. */
    private static final class HintLine extends HBox {
        static final String TEXT = "W A S D: walk  ·  Drag: look around  ·  Click: select  ·  F1: all keys";

        private final Runnable whenDone;

        /**
         * A line that is seen at once.
         *
         * @param whenDone called once, when it goes away
         */
        HintLine(PictureView picture, Runnable whenDone) {
            this.whenDone = whenDone;
            getStyleClass().add("hint-line");
            setId("hint-line");
            setAlignment(Pos.CENTER);
            setMaxSize(USE_PREF_SIZE, USE_PREF_SIZE);
            Label text = new Label(TEXT);
            text.setMinWidth(0);
            Button close = new Button("✕");
            close.setId("close-hint");
            close.setAccessibleText("Close the hint");
            close.setFocusTraversable(false);
            close.setOnAction(_ -> leave());
            getChildren().addAll(text, close);
            managedProperty().bind(visibleProperty());
            picture.addEventFilter(KeyEvent.KEY_PRESSED, event -> {
                if (!event.getCode().isModifierKey()) {
                    leave();
                }
            });
            picture.addEventFilter(MouseEvent.MOUSE_PRESSED, _ -> leave());
            picture.addEventFilter(ScrollEvent.SCROLL, _ -> leave());
        }

        private void leave() {
            if (isVisible()) {
                setVisible(false);
                whenDone.run();
            }
        }
    }
}
