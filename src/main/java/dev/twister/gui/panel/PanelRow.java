package dev.twister.gui.panel;

import dev.twister.gui.controls.Command;
import dev.twister.gui.controls.Ids;
import dev.twister.gui.controls.Tooltips;
import java.util.Objects;
import java.util.Optional;
import java.util.stream.Stream;
import javafx.css.PseudoClass;
import javafx.scene.Node;
import javafx.scene.control.Button;
import javafx.scene.control.Label;
import javafx.scene.control.Tooltip;
import javafx.scene.input.KeyCombination;
import javafx.scene.input.KeyEvent;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Priority;
import javafx.scene.layout.Region;

/** A row of the panel: name, controls, and a button that resets them. */
public abstract class PanelRow extends HBox {
    private static final PseudoClass IDLE = PseudoClass.getPseudoClass("idle");

    private final Button reset = new Button("↺");
    private final Label nameLabel;
    private final Tooltip tooltip;
    private final KeyCombination keys;
    private final String hint;

    /**
     * A row without controls.
     *
     * @param hint for the tooltip
     * @param key moves the focus to the first control; empty for none
     */
    PanelRow(String label, String hint, String key) {
        keys = key.isEmpty() ? KeyCombination.NO_MATCH : KeyCombination.valueOf(key);
        this.hint = key.isEmpty() ? hint : hint + "\nKey: " + keys.getDisplayText();
        tooltip = Tooltips.of(this.hint);
        nameLabel = new Label(label);
        nameLabel.getStyleClass().add("row-name");
        nameLabel.setTooltip(tooltip);
        reset.getStyleClass().add("reset");
        reset.setTooltip(Tooltips.of("Resets: " + label));
        reset.setAccessibleText("Reset " + label);
        getStyleClass().add("row");
        setId(Ids.of(label));
    }

    /** Adds controls between the name and the reset button; the first one takes the free width. */
    final void addControls(Node... controls) {
        getChildren().add(nameLabel);
        getChildren().addAll(controls);
        getChildren().add(reset);
        for (Node control : controls) {
            Tooltip.install(control, tooltip);
            control.setAccessibleText(nameLabel.getText());
        }
        setHgrow(controls[0], Priority.ALWAYS);
        if (controls[0] instanceof Region region) {
            region.setMaxWidth(Double.MAX_VALUE);
            region.setMinWidth(0);
        }
        nameLabel.setLabelFor(controls[0]);
    }

    /** Adds one more control before the reset button. */
    final void addControl(Region control) {
        control.setMinWidth(USE_PREF_SIZE);
        getChildren().add(getChildren().size() - 1, control);
    }

    /** Runs the command of a key that the row's control would consume. */
    final void leaveToTheWindow(KeyEvent event, Command... commands) {
        Stream.of(commands)
                .map(Command::keys)
                .filter(keys -> keys.match(event))
                .map(keys -> getScene().getAccelerators().get(keys))
                .filter(Objects::nonNull)
                .forEach(command -> {
                    command.run();
                    event.consume();
                });
    }

    /** Sets whether the reset button is enabled, and its action. */
    final void setReset(boolean differs, Runnable action) {
        reset.setDisable(!differs);
        reset.setOnAction(_ -> action.run());
    }

    /** Shows whether the row has no effect at present, and why. */
    final void setIdle(Optional<String> why) {
        pseudoClassStateChanged(IDLE, why.isPresent());
        tooltip.setText(Tooltips.lines(why.map(reason -> reason + "\n" + hint).orElse(hint)));
    }

    final Label nameLabel() {
        return nameLabel;
    }

    public final String name() {
        return nameLabel.getText();
    }

    public final KeyCombination keys() {
        return keys;
    }

    /** The control that gets the focus when the row's key is pressed. */
    public abstract Node firstControl();
}
