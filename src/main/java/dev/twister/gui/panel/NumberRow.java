package dev.twister.gui.panel;

import dev.twister.gui.controls.Command;
import dev.twister.gui.model.NumberSetting;
import dev.twister.gui.studio.Studio;
import dev.twister.scene.Scene;
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

/** A number as a slider and a field to type in. */
public final class NumberRow extends PanelRow {
    private static final PseudoClass WRONG = PseudoClass.getPseudoClass("wrong");
    private static final int PAGE = 10;
    private static final double FINE = 0.1;
    private static final double FINEST = 0.01;
    private static final String FINER =
            "Drag the name to change it. Shift makes drags and arrow keys 10 times finer, Ctrl 100 times.";

    /** That a drag on the name goes for as much as the slider's whole range. */
    private static final double PIXELS_A_WIDTH = 400;

    /** The widest letter's width each: digits are narrower. */
    private static final int FIELD_COLUMNS = 4;

    private static final int MOST_FIELD_COLUMNS = 10;

    /** Of the widest letter's, a little more than it is. */
    private static final float DIGITS_WIDTH = 0.7f;

    private final NumberSetting setting;
    private final Studio studio;
    private final Slider slider = new Slider(0, 1, 0);
    private final TextField field = new TextField();
    private final Label unit = new Label();
    private NumberSetting sliding;
    private double shown = Double.NaN;

    /** As the field was set last: another one is typed. */
    private String fieldText = "";

    private Optional<String> complaint = Optional.empty();
    private Optional<Drag> drag = Optional.empty();
    private boolean showing;
    private boolean taking;

    /**
     * A drag on the name.
     *
     * @param x where the pointer is, in pixels
     * @param number not rounded
     */
    private record Drag(double x, double number) {}

    /**
     * A row that shows nothing until {@link #show}.
     *
     * @param key what leads here, such as "Alt+S"
     */
    NumberRow(NumberSetting setting, String key, Studio studio) {
        super(setting.label(), setting.hint() + "\n" + FINER, key);
        this.setting = setting;
        this.studio = studio;
        sliding = setting;
        // The slider gives way first: a number that is cut off is a wrong one.
        field.setMinWidth(USE_PREF_SIZE);
        slider.valueProperty().subscribe((_, place) -> {
            if (!showing) {
                write(sliding.numberAt(place.doubleValue()));
            }
        });
        slider.addEventFilter(KeyEvent.KEY_PRESSED, this::slideByKey);
        slider.addEventFilter(KeyEvent.KEY_RELEASED, this::endSlideByKey);
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
                // A field takes back what was typed in it, and keeps the keys for it even where nothing was.
                leaveToTheWindow(event, Command.UNDO, Command.REDO, Command.REDO_ALSO);
            }
        });
        // In the widest letter's widths: what is longer is cut off, which makes another number of it.
        field.textProperty()
                .subscribe(text -> field.setPrefColumnCount(
                        Math.clamp(Math.round(text.length() * DIGITS_WIDTH), FIELD_COLUMNS, MOST_FIELD_COLUMNS)));
        unit.setText(setting.unit());
        unit.getStyleClass().add("unit");
        addControls(slider, field, unit);
    }

    /** Shows the scene's number; a reset leads to the usual scene's. */
    void show(Scene scene, Scene usual) {
        double number = setting.read(scene);
        double usualNumber = setting.read(usual);
        setReset(number != usualNumber, () -> {
            write(usualNumber);
            studio.endGesture();
        });
        if (number != shown) {
            showNumber(number);
        }
    }

    /** Shows a text behind the field where the unit is. */
    void showUnit(String text) {
        // Style sheets give units one width, which is too small for a text.
        unit.getStyleClass().setAll("label", "text-unit");
        unit.setMinWidth(USE_PREF_SIZE);
        unit.setText(text);
    }

    /** Whether a person is at it: what they read in order to type, or hold, is not to be changed under their hands. */
    boolean isInHand() {
        return slider.isPressed() || isRead() || drag.isPresent();
    }

    /** Whether the field has the focus, so that its text is to stay while bodies move by themselves. */
    boolean isRead() {
        return field.isFocused() && !taking;
    }

    /** Whether a person is at the field, and nothing has been made yet of what they typed. */
    boolean isBeingTyped() {
        return field.isFocused() && isTyped();
    }

    /** Nothing is made of what was typed and not entered. */
    void forgetTyped() {
        showText(setting.text(shown));
        mended();
    }

    /** Whether the field has a text of which nothing has been made yet. */
    private boolean isTyped() {
        return !field.getText().equals(fieldText);
    }

    @Override
    public Node firstControl() {
        return slider;
    }

    private void showNumber(double number) {
        shown = number;
        showSlider(number);
        if (!isBeingTyped()) {
            showText(setting.text(number));
        }
    }

    private void showSlider(double number) {
        showing = true;
        if (!slider.isPressed()) {
            sliding = setting.around(number);
        }
        slider.setValue(sliding.placeOf(number));
        showing = false;
    }

    /** Leaves the caret where it is, and selects all where all was. */
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
            double number = setting.movedBy(held.number(), widths);
            drag = Optional.of(new Drag(event.getScreenX(), number));
            write(setting.rounded(number));
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

    private void endSlideByKey(KeyEvent event) {
        studio.endGesture();
        if (event.getCode() == KeyCode.HOME || event.getCode() == KeyCode.END) {
            // JavaFX slides to the end when these are let go, though they were the window's when they were pressed.
            event.consume();
        }
    }

    /** Makes an edit of what was typed; false where that is no number that is allowed, of which it complains. */
    boolean takeTyped() {
        String typed = field.getText();
        if (!isTyped()) {
            return true;
        }
        Optional<Double> number = setting.parse(typed);
        field.pseudoClassStateChanged(WRONG, number.isEmpty());
        if (number.isPresent()) {
            taking = true;
            write(number.get());
            taking = false;
            studio.endGesture();
            // The scene may have rounded it, or had it already.
            forgetTyped();
        } else {
            complaint = Optional.of(setting.complaint(typed));
            studio.notice(complaint.get());
            if (!field.isFocused()) {
                showText(setting.text(shown));
            }
        }
        return number.isPresent();
    }

    private void mended() {
        complaint.ifPresent(studio::retract);
        complaint = Optional.empty();
    }

    private void write(double number) {
        studio.edit(setting.label().toLowerCase(Locale.ROOT), scene -> setting.write(scene, number));
    }
}
