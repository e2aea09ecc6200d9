package dev.twister.gui.panel;

import dev.twister.gui.controls.Tooltips;
import dev.twister.gui.files.SettingsKeeper;
import dev.twister.gui.files.WindowSettings;
import java.util.EnumSet;
import java.util.Set;
import javafx.beans.binding.BooleanBinding;
import javafx.beans.property.ReadOnlyBooleanProperty;
import javafx.beans.property.ReadOnlyBooleanWrapper;
import javafx.beans.value.ObservableValue;
import javafx.event.Event;
import javafx.scene.Cursor;
import javafx.scene.Node;
import javafx.scene.Scene;
import javafx.scene.control.Tooltip;
import javafx.scene.input.KeyCode;
import javafx.scene.input.KeyEvent;
import javafx.scene.input.MouseEvent;
import javafx.scene.layout.Pane;
import javafx.scene.layout.Region;
import javafx.scene.layout.StackPane;
import javafx.stage.Screen;
import javafx.stage.Stage;
import javafx.stage.WindowEvent;

/**
 * Where the panel is: beside the picture, with an edge that sets its width, or in a window of its own, whose closing
 * docks it.
 */
public final class PanelWindow {
    private static final double WIDTH = 440;
    private static final double HEIGHT = 700;
    private static final double MARGIN = 40;

    /** Keys that move the focus among the panel's controls, and the one of the menu. */
    private static final Set<KeyCode> OF_THE_PANEL = EnumSet.of(
            KeyCode.TAB,
            KeyCode.UP,
            KeyCode.DOWN,
            KeyCode.LEFT,
            KeyCode.RIGHT,
            KeyCode.KP_UP,
            KeyCode.KP_DOWN,
            KeyCode.KP_LEFT,
            KeyCode.KP_RIGHT,
            KeyCode.F10);

    private final Stage owner;
    private final Panel panel;
    private final Pane side;
    private final Node picture;
    private final SettingsKeeper settings;
    private final StackPane holder = new StackPane();
    private final Scene scene = new Scene(holder, WIDTH, HEIGHT);
    private final Stage stage = new Stage();
    private final ReadOnlyBooleanWrapper floating = new ReadOnlyBooleanWrapper();
    private final BooleanBinding docked;

    /**
     * The window, which is not shown yet.
     *
     * @param owner the main window
     * @param side holds the panel, and is to hold it and its edge while it is docked
     * @param picture of the main window
     */
    public PanelWindow(Stage owner, Panel panel, Pane side, Node picture, SettingsKeeper settings) {
        this.owner = owner;
        this.panel = panel;
        this.side = side;
        this.picture = picture;
        this.settings = settings;
        docked = floating.not().and(panel.visibleProperty());
        side.getChildren().addFirst(new Edge(panel, docked, settings));
        holder.setId("panel-window");
        stage.initOwner(owner);
        stage.setTitle("Panel – Twister");
        scene.getStylesheets().setAll(owner.getScene().getStylesheets());
        stage.setScene(scene);
        stage.setOnCloseRequest(event -> {
            event.consume();
            setFloating(false);
        });
        stage.setOnHiding(_ -> keepPlace());
        scene.addEventHandler(KeyEvent.KEY_PRESSED, this::forward);
        scene.addEventHandler(KeyEvent.KEY_RELEASED, this::forward);
        panel.visibleProperty().subscribe(_ -> show());
        // A window that is not shown yet can own none.
        owner.addEventHandler(WindowEvent.WINDOW_SHOWN, _ -> {
            show();
            owner.requestFocus();
        });
    }

    /** The scene that holds the panel while it floats. */
    public Scene scene() {
        return scene;
    }

    /** Whether the window has the focus. */
    public ReadOnlyBooleanProperty focusedProperty() {
        return stage.focusedProperty();
    }

    /** Whether the panel is in this window, shown or hidden. */
    public ReadOnlyBooleanProperty floatingProperty() {
        return floating.getReadOnlyProperty();
    }

    /** Whether the panel is at the side of the picture, and shown. */
    public ObservableValue<Boolean> dockedProperty() {
        return docked;
    }

    /** Moves the panel into this window, or back beside the picture. */
    public void setFloating(boolean floats) {
        if (floats != floating.get()) {
            Pane from = floats ? side : holder;
            Pane to = floats ? holder : side;
            from.getChildren().remove(panel);
            to.getChildren().add(panel);
            floating.set(floats);
            settings.change(kept -> kept.with(WindowSettings.PANEL_FLOATS, floats));
            show();
        }
    }

    /** Hides the window; its place is kept. */
    public void close() {
        stage.hide();
    }

    private void show() {
        boolean shown = floating.get() && panel.isVisible() && owner.isShowing();
        if (shown && !stage.isShowing()) {
            place();
            stage.show();
        } else if (!shown && stage.isShowing()) {
            stage.hide();
        }
    }

    private void keepPlace() {
        WindowSettings.Bounds place =
                new WindowSettings.Bounds(stage.getX(), stage.getY(), stage.getWidth(), stage.getHeight());
        settings.change(place::keptIn);
    }

    /** Where it was; beside the main window's right edge if that is on no screen now. */
    private void place() {
        WindowSettings.Bounds place = WindowSettings.Bounds.of(settings.settings())
                .filter(kept -> !Screen.getScreensForRectangle(kept.x(), kept.y(), kept.width(), kept.height())
                        .isEmpty())
                .orElseGet(() -> new WindowSettings.Bounds(
                        owner.getX() + owner.getWidth() - WIDTH - MARGIN, owner.getY() + 2 * MARGIN, WIDTH, HEIGHT));
        stage.setX(place.x());
        stage.setY(place.y());
        stage.setWidth(place.width());
        stage.setHeight(place.height());
    }

    /** Keys that no control of the panel takes are those of the main window. */
    private void forward(KeyEvent event) {
        boolean alt = event.isAltDown() || event.getCode() == KeyCode.ALT;
        if (!alt && !OF_THE_PANEL.contains(event.getCode())) {
            // The picture takes keys of its own, while bodies are moved by them.
            boolean toPicture = picture.equals(owner.getScene().getFocusOwner());
            Event.fireEvent(toPicture ? picture : owner.getScene().getRoot(), event);
        }
    }

    /** The panel's left edge: a drag makes the panel wider or narrower, a double click as wide as usual. */
    private static final class Edge extends Region {
        private static final double WIDTH = 5;

        /** The width left for the picture. */
        private static final double LEAST_PICTURE = 240;

        private final Region panel;
        private double grip;

        /** @param docked whether the panel is shown beside it */
        Edge(Region panel, ObservableValue<Boolean> docked, SettingsKeeper settings) {
            this.panel = panel;
            setId("panel-edge");
            getStyleClass().add("panel-edge");
            setMinWidth(WIDTH);
            setPrefWidth(WIDTH);
            setCursor(Cursor.H_RESIZE);
            visibleProperty().bind(docked);
            managedProperty().bind(docked);
            Tooltip.install(
                    this, Tooltips.of("Drag to make the panel wider or narrower; double-click for its usual width."));
            setOnMousePressed(event -> grip = panel.getWidth() + event.getSceneX());
            setOnMouseDragged(this::dragged);
            setOnMouseReleased(_ -> {
                int width = settings.settings().get(WindowSettings.PANEL_WIDTH);
                int now = (int) Math.rint(panel.getPrefWidth());
                if (!panel.getStyle().isEmpty() && now != width) {
                    settings.change(kept -> kept.with(WindowSettings.PANEL_WIDTH, now));
                }
            });
            setOnMouseClicked(event -> {
                if (event.getClickCount() > 1) {
                    show(WindowSettings.USUAL_PANEL);
                    settings.change(kept -> kept.with(WindowSettings.PANEL_WIDTH, WindowSettings.USUAL_PANEL));
                }
            });
            show(settings.settings().get(WindowSettings.PANEL_WIDTH));
        }

        private void dragged(MouseEvent event) {
            double most = Math.max(panel.getMinWidth(), getScene().getWidth() - LEAST_PICTURE);
            show((int) Math.rint(Math.clamp(grip - event.getSceneX(), Math.max(0, panel.getMinWidth()), most)));
        }

        /** As an inline style, which the style sheet's own width does not replace. */
        private void show(int width) {
            panel.setStyle(width == WindowSettings.USUAL_PANEL ? "" : "-fx-pref-width: " + width + "px;");
        }
    }
}
