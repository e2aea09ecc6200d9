package dev.twister.gui;

import java.util.Locale;
import java.util.Objects;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import javafx.scene.Node;
import javafx.scene.control.Button;
import javafx.scene.control.Label;
import javafx.scene.control.Tooltip;
import javafx.scene.input.KeyCombination;
import javafx.scene.input.KeyEvent;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Priority;
import javafx.scene.layout.Region;
import javafx.util.Duration;

/** A line of the panel: a name, controls, and a button that resets them. */
abstract sealed class PanelRow extends HBox permits NumberRow, ColorRow, ChoiceRow, SwitchRow, BodiesRow {
    private static final Duration TOOLTIP_DELAY = Duration.millis(400);
    private static final Duration TOOLTIP_TIME = Duration.seconds(30);

    private static final int LETTERS_IN_A_LINE = 60;
    private static final Pattern WHITE_SPACE = Pattern.compile("\\s+");

    private final Button reset = new Button("↺");
    private final Label nameLabel;
    private final Tooltip tooltip;
    private final KeyCombination keys;

    /**
     * A row without controls yet.
     *
     * @param hint what the controls do, for the tooltip
     * @param key what leads to the first of them
     */
    PanelRow(String label, String hint, String key) {
        keys = KeyCombination.valueOf(key);
        tooltip = tooltip(hint + "\nKey: " + keys.getDisplayText());
        nameLabel = new Label(label);
        nameLabel.getStyleClass().add("row-name");
        nameLabel.setTooltip(tooltip);
        reset.getStyleClass().add("reset");
        reset.setTooltip(tooltip("Resets: " + label));
        reset.setAccessibleText("Reset " + label);
        getStyleClass().add("row");
        setId(id(label));
    }

    /** The id of a row with that name, such as {@code shadow-samples}. */
    static String id(String label) {
        return label.toLowerCase(Locale.ROOT).replace(' ', '-');
    }

    static Tooltip tooltip(String text) {
        Tooltip tooltip = new Tooltip(text.lines().map(PanelRow::inLines).collect(Collectors.joining("\n")));
        tooltip.setShowDelay(TOOLTIP_DELAY);
        tooltip.setShowDuration(TOOLTIP_TIME);
        return tooltip;
    }

    /** A tooltip and a list are as wide as their longest line, so a sentence is broken between words. */
    static String inLines(String sentence) {
        StringBuilder lines = new StringBuilder();
        int length = 0;
        for (String word : WHITE_SPACE.splitAsStream(sentence).toList()) {
            boolean fits = length + word.length() < LETTERS_IN_A_LINE;
            lines.append(length == 0 ? "" : fits ? " " : "\n").append(word);
            length = fits ? length + word.length() + 1 : word.length();
        }
        return lines.toString();
    }

    /** Puts the controls between the name and the reset; the first takes the room that there is. */
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

    /** Puts a control of its own before the reset. */
    final void addControl(Region control) {
        control.setMinWidth(USE_PREF_SIZE);
        getChildren().add(getChildren().size() - 1, control);
    }

    /** Runs a command whose key it is, which the row's control would keep for itself. */
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

    /** Whether there is something to reset, and how. */
    final void setReset(boolean differs, Runnable action) {
        reset.setDisable(!differs);
        reset.setOnAction(_ -> action.run());
    }

    final Label nameLabel() {
        return nameLabel;
    }

    final String name() {
        return nameLabel.getText();
    }

    final KeyCombination keys() {
        return keys;
    }

    /** What takes the focus when the row's key is pressed. */
    abstract Node firstControl();
}
