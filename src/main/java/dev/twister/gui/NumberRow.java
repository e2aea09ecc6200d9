package dev.twister.gui;

import dev.twister.gui.model.NumberSetting;
import dev.twister.scene.Scene;
import java.util.Locale;
import java.util.Objects;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.stream.Stream;
import javafx.css.PseudoClass;
import javafx.scene.Node;
import javafx.scene.control.Label;
import javafx.scene.control.Slider;
import javafx.scene.control.TextField;
import javafx.scene.input.KeyCode;
import javafx.scene.input.KeyEvent;
import javafx.scene.input.MouseEvent;

/** A number as a slider and a field to type in. */
final class NumberRow extends PanelRow {
    private static final PseudoClass WRONG = PseudoClass.getPseudoClass("wrong");
    private static final int PAGE = 10;

    /** The widest letter's width each: digits are narrower. */
    private static final int FIELD_COLUMNS = 4;

    private static final int MOST_FIELD_COLUMNS = 10;

    /** Of the widest letter's, a little more than it is. */
    private static final float DIGITS_WIDTH = 0.7f;

    private final NumberSetting setting;
    private final SceneEdit edit;
    private final Consumer<String> complain;
    private final Slider slider = new Slider(0, 1, 0);
    private final TextField field = new TextField();
    private double shown = Double.NaN;
    private boolean showing;

    /** A row of an edit of the scene. */
    static NumberRow ofScene(NumberSetting setting, String key, Studio studio) {
        return new NumberRow(setting, key, SceneEdit.ofScene(studio), studio::notice);
    }

    /**
     * A row that shows nothing until {@link #show}.
     *
     * @param key what leads here, such as "Alt+S"
     * @param complain takes the message where what was typed is no number that is allowed
     */
    NumberRow(NumberSetting setting, String key, SceneEdit edit, Consumer<String> complain) {
        super(setting.label(), setting.hint(), key);
        this.setting = setting;
        this.edit = edit;
        this.complain = complain;
        // The slider gives way first: a number that is cut off is a wrong one.
        field.setMinWidth(USE_PREF_SIZE);
        slider.valueProperty().subscribe((_, place) -> {
            if (!showing) {
                write(setting.numberAt(place.doubleValue()));
            }
        });
        slider.addEventFilter(KeyEvent.KEY_PRESSED, this::slideByKey);
        slider.addEventFilter(KeyEvent.KEY_RELEASED, this::endSlideByKey);
        slider.addEventHandler(MouseEvent.MOUSE_RELEASED, _ -> edit.endGesture());
        field.setOnAction(_ -> takeTyped());
        field.focusedProperty().subscribe((_, focused) -> {
            if (!focused) {
                takeTyped();
            }
        });
        field.addEventFilter(KeyEvent.KEY_PRESSED, event -> {
            if (event.getCode() == KeyCode.ESCAPE) {
                showNumber(shown);
            } else if (!isTyped()) {
                leaveToTheWindow(event);
            }
        });
        // In the widest letter's widths: what is longer is cut off, which makes another number of it.
        field.textProperty()
                .subscribe(text -> field.setPrefColumnCount(
                        Math.clamp(Math.round(text.length() * DIGITS_WIDTH), FIELD_COLUMNS, MOST_FIELD_COLUMNS)));
        Label unit = new Label(setting.unit());
        unit.getStyleClass().add("unit");
        addControls(slider, field, unit);
    }

    /** Shows the scene's number; a reset leads to the usual scene's. */
    void show(Scene scene, Scene usual) {
        double number = setting.read(scene);
        double usualNumber = setting.read(usual);
        setReset(number != usualNumber, () -> {
            write(usualNumber);
            edit.endGesture();
        });
        if (number != shown) {
            showNumber(number);
        }
    }

    /** Whether a person is at it: what they type, or hold, is not to be changed under their hands. */
    boolean isInHand() {
        return slider.isPressed() || isBeingTyped();
    }

    /** Whether a person is at the field, and nothing has been made yet of what they typed. */
    boolean isBeingTyped() {
        return field.isFocused() && isTyped();
    }

    /** Nothing is made of what was typed and not entered. */
    void forgetTyped() {
        showNumber(shown);
    }

    /** Whether the field has a text of which nothing has been made yet. */
    private boolean isTyped() {
        return !field.getText().equals(setting.text(shown));
    }

    @Override
    Node firstControl() {
        return slider;
    }

    private void showNumber(double number) {
        showing = true;
        shown = number;
        slider.setValue(setting.placeOf(number));
        field.setText(setting.text(number));
        field.pseudoClassStateChanged(WRONG, false);
        showing = false;
    }

    private void slideByKey(KeyEvent event) {
        Optional<Double> next = switch (event.getCode()) {
            case LEFT -> Optional.of(setting.stepped(shown, -1));
            case RIGHT -> Optional.of(setting.stepped(shown, 1));
            case PAGE_DOWN -> Optional.of(setting.stepped(shown, -PAGE));
            case PAGE_UP -> Optional.of(setting.stepped(shown, PAGE));
            case HOME -> Optional.of(setting.slid().min());
            case END -> Optional.of(setting.slid().max());
            default -> Optional.empty();
        };
        if (next.isPresent() && !event.isShortcutDown() && !event.isAltDown()) {
            write(next.get());
            event.consume();
        }
    }

    private void endSlideByKey(KeyEvent event) {
        edit.endGesture();
        if (event.getCode() == KeyCode.HOME || event.getCode() == KeyCode.END) {
            // JavaFX slides to the end when these are let go, though they were the window's when they were pressed.
            event.consume();
        }
    }

    /** A field takes back what was typed in it, and keeps the keys for it even where nothing was. */
    private void leaveToTheWindow(KeyEvent event) {
        Stream.of(Command.UNDO, Command.REDO, Command.REDO_ALSO)
                .map(Command::keys)
                .filter(keys -> keys.match(event))
                .map(keys -> getScene().getAccelerators().get(keys))
                .filter(Objects::nonNull)
                .forEach(command -> {
                    command.run();
                    event.consume();
                });
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
            write(number.get());
            edit.endGesture();
            // The scene may have rounded it, or had it already.
            showNumber(shown);
        } else {
            complain.accept(setting.complaint(typed));
            if (!field.isFocused()) {
                showNumber(shown);
            }
        }
        return number.isPresent();
    }

    private void write(double number) {
        edit.apply(setting.label().toLowerCase(Locale.ROOT), scene -> setting.write(scene, number));
    }
}
