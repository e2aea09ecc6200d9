package dev.twister.gui.rendering;

import dev.twister.gui.controls.Tooltips;
import java.util.Optional;
import javafx.geometry.Pos;
import javafx.scene.control.Button;
import javafx.scene.control.Label;
import javafx.scene.control.ProgressBar;
import javafx.scene.layout.HBox;

/** The progress of a rendering in the status line, with a button to cancel, while the render window is closed. */
public final class RenderStatus extends HBox {
    private final ProgressBar bar = new ProgressBar(0);
    private final Label text = new Label();

    /** @param stop cancels the rendering */
    RenderStatus(Runnable stop) {
        bar.setAccessibleText("Progress of the rendering");
        text.setId("rendering");
        text.setMinWidth(0);
        Button cancel = new Button("Cancel");
        cancel.setId("cancel-rendering");
        cancel.setTooltip(Tooltips.of("Cancels the rendering. Finished numbered frames stay."));
        cancel.setMinWidth(USE_PREF_SIZE);
        cancel.setOnAction(_ -> stop.run());
        getStyleClass().add("reading");
        setAlignment(Pos.CENTER_LEFT);
        getChildren().addAll(bar, text, cancel);
        managedProperty().bind(visibleProperty());
        setVisible(false);
    }

    /** Shows the progress, as {@link RenderWindow#showProgress} does. */
    void show(String progress, Optional<Double> part) {
        text.setText(progress);
        bar.setProgress(part.orElse(ProgressBar.INDETERMINATE_PROGRESS));
        setVisible(true);
    }

    void hide() {
        // An invisible bar that moves would cost processor time.
        bar.setProgress(0);
        setVisible(false);
    }
}
