package dev.twister.gui.panel;

import dev.twister.gui.controls.Command;
import dev.twister.gui.controls.NumberField;
import dev.twister.gui.property.NumberProperty;
import dev.twister.gui.property.NumberScale;
import dev.twister.gui.studio.Studio;
import dev.twister.scene.Scene;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import javafx.css.PseudoClass;
import javafx.scene.Cursor;
import javafx.scene.Node;
import javafx.scene.control.Label;
import javafx.scene.control.Slider;
import javafx.scene.control.TextField;
import javafx.scene.input.KeyCode;
import javafx.scene.input.KeyEvent;
import javafx.scene.input.MouseEvent;

/** A row with a slider and a text field for a number. */
public final class NumberRow extends PanelRow {
    private static final PseudoClass WRONG = PseudoClass.getPseudoClass("wrong");
    private static final int PAGE = 10;
    private static final double FINE = 0.1;
    private static final double FINEST = 0.01;
    private static final String FINER =
            "Drag the name to change it. Shift makes drags and arrow keys 10 times finer, Ctrl 100 times.";

    /** The length of a drag on the name that equals the slider's whole range. */
    private static final double PIXELS_A_WIDTH = 400;

    /** In widths of the widest letter; digits are narrower. */
    private static final int FIELD_COLUMNS = 4;

    private static final int MOST_FIELD_COLUMNS = 10;

    /** Width of a digit relative to the widest letter, rounded up. */
    private static final float DIGITS_WIDTH = 0.7f;

    private final NumberProperty<Scene> number;
    private final NumberScale scale;
    private final Studio studio;
    private final Slider slider = new Slider(0, 1, 0);
    private final TextField field = new TextField();
    private final Label unit = new Label();
    private NumberScale sliding;
    private double shown = Double.NaN;

    /** The text that the row has set; any other was typed. */
    private String fieldText = "";

    private Optional<String> complaint = Optional.empty();
    private Optional<Drag> drag = Optional.empty();
    private boolean showing;
    private boolean taking;

    /**
     * A drag on the name.
     *
     * @param x of the pointer, in pixels
     * @param number not rounded
     */
    private record Drag(double x, double number) {}

    /** A row that is empty until {@link #show}. */
    NumberRow(NumberProperty<Scene> number, Studio studio) {
        super(number.label(), number.hint() + "\n" + FINER, number.key());
        this.number = number;
        this.studio = studio;
        scale = number.scale();
        sliding = scale;
        // The slider shrinks first: a clipped number would be misread.
        field.setMinWidth(USE_PREF_SIZE);
        slider.valueProperty().subscribe((_, place) -> {
            if (!showing) {
                write(sliding.numberAt(place.doubleValue()));
            }
        });
        slider.addEventFilter(KeyEvent.KEY_PRESSED, this::slideByKey);
        slider.addEventFilter(KeyEvent.KEY_RELEASED, NumberRow::leaveReleasedKeys);
        slider.addEventFilter(MouseEvent.MOUSE_PRESSED, _ -> studio.endGesture());
        // Steps by keys are undone together.
        slider.focusedProperty().subscribe((_, focused) -> {
            if (!focused) {
                studio.endGesture();
            }
        });
        slider.addEventHandler(MouseEvent.MOUSE_RELEASED, _ -> {
            studio.endGesture();
            showSlider(shown);
        });
        nameLabel().setCursor(Cursor.H_RESIZE);
        nameLabel().setOnMousePressed(event -> drag = Optional.of(new Drag(event.getScreenX(), shown)));
        nameLabel().setOnMouseDragged(this::dragName);
        nameLabel().setOnMouseReleased(_ -> {
            drag = Optional.empty();
            studio.endGesture();
        });
        NumberField.stopCaret(field);
        field.setOnAction(_ -> takeTyped());
        field.focusedProperty().subscribe((_, focused) -> {
            if (!focused) {
                takeTyped();
            }
        });
        field.addEventFilter(KeyEvent.KEY_PRESSED, event -> {
            if (event.getCode() == KeyCode.ESCAPE) {
                forgetTyped();
            } else if (!isTyped()) {
                // A text field handles undo keys even if nothing was typed.
                leaveToTheWindow(event, Command.UNDO, Command.REDO, Command.REDO_ALSO);
            }
        });
        // A text that is too long would be clipped, and misread.
        field.textProperty()
                .subscribe(text -> field.setPrefColumnCount(
                        Math.clamp(Math.round(text.length() * DIGITS_WIDTH), FIELD_COLUMNS, MOST_FIELD_COLUMNS)));
        unit.setText(scale.unit());
        unit.getStyleClass().add("unit");
        addControls(slider, field, unit);
    }

    /** The rows of a table. */
    static List<NumberRow> of(List<NumberProperty<Scene>> table, Studio studio) {
        return table.stream().map(number -> new NumberRow(number, studio)).toList();
    }

    /** Shows the scene's number and enables a reset to the usual scene's. */
    void show(Scene scene, Scene usual) {
        double present = number.read(scene);
        double usualNumber = number.read(usual);
        setReset(present != usualNumber, () -> {
            write(usualNumber);
            studio.endGesture();
        });
        if (present != shown) {
            showNumber(present);
        }
    }

    /** Replaces the unit by a longer text. */
    void showUnit(String text) {
        // The style of units has a fixed width, which is too small.
        unit.getStyleClass().setAll("label", "text-unit");
        unit.setMinWidth(USE_PREF_SIZE);
        unit.setText(text);
    }

    /** Whether the user is using the row, so that its number must not change. */
    boolean isInHand() {
        return slider.isPressed() || isRead() || drag.isPresent();
    }

    /** Whether the field has the focus, so that its text must not follow moving bodies. */
    boolean isRead() {
        return field.isFocused() && !taking;
    }

    /** Whether the field has the focus and a text that was not entered. */
    boolean isBeingTyped() {
        return field.isFocused() && isTyped();
    }

    /** Discards what was typed. */
    void forgetTyped() {
        showText(scale.text(shown));
        mended();
    }

    /** Whether the field has a text that was not entered. */
    private boolean isTyped() {
        return !field.getText().equals(fieldText);
    }

    @Override
    public Node firstControl() {
        return slider;
    }

    private void showNumber(double present) {
        shown = present;
        showSlider(present);
        if (!isBeingTyped()) {
            showText(scale.text(present));
        }
    }

    private void showSlider(double present) {
        showing = true;
        if (!slider.isPressed()) {
            sliding = scale.around(present);
        }
        slider.setValue(sliding.placeOf(present));
        showing = false;
    }

    /** Keeps the caret, or a selection of the whole text. */
    private void showText(String text) {
        fieldText = text;
        if (!field.getText().equals(text)) {
            boolean all = field.getSelection().getLength() == field.getLength();
            int anchor = field.getAnchor();
            int caret = field.getCaretPosition();
            field.setText(text);
            if (all) {
                field.selectAll();
            } else {
                field.selectRange(anchor, caret);
            }
        }
        field.pseudoClassStateChanged(WRONG, false);
    }

    private void dragName(MouseEvent event) {
        drag.ifPresent(held -> {
            double widths = (event.getScreenX() - held.x())
                    / PIXELS_A_WIDTH
                    * fineness(event.isShiftDown(), event.isControlDown());
            double moved = scale.movedBy(held.number(), widths);
            drag = Optional.of(new Drag(event.getScreenX(), moved));
            write(scale.rounded(moved));
        });
    }

    private static double fineness(boolean shift, boolean control) {
        return control ? FINEST : shift ? FINE : 1;
    }

    private void slideByKey(KeyEvent event) {
        double step = fineness(event.isShiftDown(), event.isControlDown());
        boolean plain = !event.isShiftDown() && !event.isControlDown() && !event.isMetaDown();
        Optional<Double> next = switch (event.getCode()) {
            case LEFT -> Optional.of(sliding.stepped(shown, -step));
            case RIGHT -> Optional.of(sliding.stepped(shown, step));
            case PAGE_DOWN -> Optional.of(sliding.stepped(shown, -PAGE)).filter(_ -> plain);
            case PAGE_UP -> Optional.of(sliding.stepped(shown, PAGE)).filter(_ -> plain);
            case HOME -> Optional.of(sliding.slid().min()).filter(_ -> plain);
            case END -> Optional.of(sliding.slid().max()).filter(_ -> plain);
            default -> Optional.empty();
        };
        if (next.isPresent() && !event.isAltDown() && !event.isMetaDown()) {
            write(next.get());
            event.consume();
        }
    }

    private static void leaveReleasedKeys(KeyEvent event) {
        if (event.getCode() == KeyCode.HOME || event.getCode() == KeyCode.END) {
            // JavaFX moves the slider when these keys are released, although the window handled them when they were
            // pressed.
            event.consume();
        }
    }

    /** Enters what was typed; returns false and tells why if it is not an allowed number. */
    boolean takeTyped() {
        String typed = field.getText();
        if (!isTyped()) {
            return true;
        }
        Optional<Double> entered = scale.parse(typed);
        field.pseudoClassStateChanged(WRONG, entered.isEmpty());
        if (entered.isPresent()) {
            taking = true;
            write(entered.get());
            taking = false;
            studio.endGesture();
            // The scene may have rounded the number, or had it before.
            forgetTyped();
        } else {
            complaint = Optional.of(number.complaint(typed));
            studio.notice(complaint.get());
            if (!field.isFocused()) {
                showText(scale.text(shown));
            }
        }
        return entered.isPresent();
    }

    private void mended() {
        complaint.ifPresent(studio::retract);
        complaint = Optional.empty();
    }

    private void write(double entered) {
        studio.edit(number.label().toLowerCase(Locale.ROOT), scene -> number.write(scene, entered));
    }
}
