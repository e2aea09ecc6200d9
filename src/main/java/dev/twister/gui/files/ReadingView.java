package dev.twister.gui.files;

import dev.twister.gui.controls.Command;
import dev.twister.gui.controls.Tooltips;
import dev.twister.gui.studio.Studio;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import javafx.geometry.Pos;
import javafx.scene.control.Button;
import javafx.scene.control.Label;
import javafx.scene.control.ProgressIndicator;
import javafx.scene.layout.HBox;

/** Shows which file is being read, if it takes long, with a button to cancel. */
public final class ReadingView extends HBox {
    /** Files that take less time are not shown. */
    private static final long LONG_NANOS = TimeUnit.MILLISECONDS.toNanos(500);

    private final Studio studio;
    private final Reading reading;
    private final Label name = new Label();
    private Optional<String> present = Optional.empty();
    private long sinceNanos;

    public ReadingView(Studio studio, Reading reading) {
        this.studio = studio;
        this.reading = reading;
        name.setId("reading");
        Button cancel = new Button("Cancel");
        cancel.setId("cancel-reading");
        cancel.setTooltip(
                Tooltips.of("Stops reading.\nKey: " + Command.DESELECT.keys().getDisplayText()));
        cancel.setOnAction(_ -> cancel(studio, reading));
        getStyleClass().add("reading");
        setAlignment(Pos.CENTER_LEFT);
        getChildren().addAll(new ProgressIndicator(), name, cancel);
        show(false);
    }

    /** Whether a file is being read. */
    public static boolean isReading(Studio studio, Reading reading) {
        return name(studio, reading).isPresent();
    }

    /** Cancels reading. */
    public static void cancel(Studio studio, Reading reading) {
        name(studio, reading).ifPresent(file -> studio.notice("Canceled reading " + file));
        reading.cancel();
        studio.assets().cancelReading();
    }

    /** Called in every pulse. */
    public void pulse(long nanos) {
        Optional<String> now = name(studio, reading);
        if (!now.equals(present)) {
            present = now;
            sinceNanos = nanos;
            name.setText(now.map(file -> "Reading " + file + "…").orElse(""));
        }
        boolean shown = now.isPresent() && nanos - sinceNanos >= LONG_NANOS;
        if (shown != isVisible()) {
            show(shown);
        }
    }

    private static Optional<String> name(Studio studio, Reading reading) {
        return reading.presentProperty().get().map(Reading.Task::name).or(studio.assets()::beingRead);
    }

    private void show(boolean shown) {
        setVisible(shown);
        setManaged(shown);
    }
}
