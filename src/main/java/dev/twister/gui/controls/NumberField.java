package dev.twister.gui.controls;

import dev.twister.scene.property.Range;
import java.math.BigDecimal;
import java.util.Optional;
import javafx.css.PseudoClass;
import javafx.scene.control.TextField;
import javafx.scene.control.skin.TextFieldSkin;

/** A text field for a number; red while the text is not an allowed one. */
public final class NumberField extends TextField {
    private static final PseudoClass WRONG = PseudoClass.getPseudoClass("wrong");
    private static final int COLUMNS = 5;

    private final String label;
    private final Range allowed;
    private final boolean whole;

    /**
     * An empty field.
     *
     * @param label names the number in error messages
     * @param whole whether only whole numbers are allowed
     * @param changed called when the text changes
     */
    public NumberField(String label, Range allowed, boolean whole, Runnable changed) {
        this.label = label;
        this.allowed = allowed;
        this.whole = whole;
        setId("render-" + Ids.of(label));
        stopCaret(this);
        setPrefColumnCount(COLUMNS);
        setMinWidth(USE_PREF_SIZE);
        setMaxWidth(USE_PREF_SIZE);
        textProperty().subscribe((_, _) -> {
            pseudoClassStateChanged(WRONG, parsed().isEmpty());
            changed.run();
        });
    }

    public void show(double number) {
        setText(BigDecimal.valueOf(number).stripTrailingZeros().toPlainString());
    }

    /** The number; if the text is not allowed, the allowed number nearest to 0. */
    public double number() {
        return parsed().orElse(allowed.clamp(0));
    }

    /** The number as an int. */
    public int wholeNumber() {
        return (int) number();
    }

    /** The error message; empty if the text is allowed. */
    public Optional<String> complaint() {
        return parsed().isPresent()
                ? Optional.empty()
                : Optional.of(label + " is '" + getText().strip() + "', but must be a " + (whole ? "whole " : "")
                        + "number " + allowed);
    }

    private Optional<Double> parsed() {
        try {
            return Optional.of(new BigDecimal(getText().strip().replace(',', '.')).doubleValue())
                    .filter(allowed::contains)
                    .filter(number -> !whole || number == Math.rint(number));
        } catch (NumberFormatException _) {
            return Optional.empty();
        }
    }

    /**
     * Stops the caret of a text field without the focus. JavaFX starts its blinking whenever a text is set, and then
     * asks for 60 pulses per second for as long as the program runs.
     */
    public static void stopCaret(TextField field) {
        // After the skin's own listener, which starts it.
        field.skinProperty().subscribe(skin -> {
            if (skin instanceof TextFieldSkin drawn) {
                field.caretPositionProperty().subscribe(_ -> stop(field, drawn));
            }
        });
    }

    private static void stop(TextField field, TextFieldSkin skin) {
        if (!field.isFocused()) {
            skin.setCaretAnimating(false);
        }
    }
}
