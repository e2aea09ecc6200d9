package dev.twister.gui.controls;

import dev.twister.scene.Range;
import java.math.BigDecimal;
import java.util.Optional;
import javafx.css.PseudoClass;
import javafx.scene.control.TextField;

/** A number to type in, red while it is none that is allowed. */
public final class NumberField extends TextField {
    private static final PseudoClass WRONG = PseudoClass.getPseudoClass("wrong");
    private static final int COLUMNS = 5;

    private final String label;
    private final Range allowed;
    private final boolean whole;

    /**
     * An empty field.
     *
     * @param label what it is, for complaints
     * @param whole whether the number has no places after the point
     * @param changed called when the text is another one
     */
    public NumberField(String label, Range allowed, boolean whole, Runnable changed) {
        this.label = label;
        this.allowed = allowed;
        this.whole = whole;
        setId("render-" + Ids.of(label));
        setPrefColumnCount(COLUMNS);
        setMinWidth(USE_PREF_SIZE);
        setMaxWidth(USE_PREF_SIZE);
        textProperty().subscribe((_, _) -> {
            pseudoClassStateChanged(WRONG, parsed().isEmpty());
            changed.run();
        });
    }

    /** Shows a number. */
    public void show(double number) {
        setText(BigDecimal.valueOf(number).stripTrailingZeros().toPlainString());
    }

    /** The number; the nearest that is allowed to 0 where what is typed is none. */
    public double number() {
        return parsed().orElse(allowed.clamp(0));
    }

    /** The same without places after the point. */
    public int wholeNumber() {
        return (int) number();
    }

    /** What is wrong with what is typed. */
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
}
