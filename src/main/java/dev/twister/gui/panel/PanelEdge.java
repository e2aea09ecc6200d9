package dev.twister.gui.panel;

import dev.twister.gui.controls.Tooltips;
import dev.twister.gui.files.SettingsKeeper;
import dev.twister.gui.files.WindowSettings;
import javafx.beans.value.ObservableValue;
import javafx.scene.Cursor;
import javafx.scene.control.Tooltip;
import javafx.scene.input.MouseEvent;
import javafx.scene.layout.Region;

/** The panel's left edge: a drag makes the panel wider or narrower, a double click as wide as usual. */
public final class PanelEdge extends Region {
    private static final double WIDTH = 5;

    /** The width left for the picture. */
    private static final double LEAST_PICTURE = 240;

    private final Region panel;
    private double grip;

    /** @param docked whether the panel is shown beside it */
    public PanelEdge(Region panel, ObservableValue<Boolean> docked, SettingsKeeper settings) {
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
