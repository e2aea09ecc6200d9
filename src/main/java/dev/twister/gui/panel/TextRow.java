package dev.twister.gui.panel;

import java.util.function.Consumer;
import java.util.function.Predicate;
import javafx.scene.Node;
import javafx.scene.control.TextField;

/** A row for a short text. */
final class TextRow extends PanelRow {
    private final TextField field = new TextField();
    private final Predicate<String> allowed;
    private final String allowedText;
    private final Consumer<String> choose;
    private final Consumer<String> complain;
    private String shown = "";

    /**
     * A row that is empty until {@link #show}.
     *
     * @param allowedText what a text must be, for messages
     * @param choose called when a person has entered another, allowed text
     * @param complain called with a message about any other text
     */
    TextRow(
            String label,
            String hint,
            Predicate<String> allowed,
            String allowedText,
            Consumer<String> choose,
            Consumer<String> complain) {
        super(label, hint, "");
        this.allowed = allowed;
        this.allowedText = allowedText;
        this.choose = choose;
        this.complain = complain;
        field.setOnAction(_ -> take());
        field.focusedProperty().subscribe(focused -> {
            if (!focused) {
                take();
            }
        });
        addControls(field);
    }

    /** Shows what is, and what a reset would lead to. */
    void show(String text, String usual) {
        if (!text.equals(shown) || !field.isFocused()) {
            shown = text;
            field.setText(text);
        }
        setReset(!text.equals(usual), () -> choose.accept(usual));
    }

    @Override
    public Node firstControl() {
        return field;
    }

    private void take() {
        String typed = field.getText().strip();
        if (typed.equals(shown)) {
            return;
        }
        if (allowed.test(typed)) {
            shown = typed;
            choose.accept(typed);
        } else {
            complain.accept(name() + " is '" + typed + "', but must be " + allowedText);
            field.setText(shown);
        }
    }
}
