package dev.twister.gui.camera;

import dev.twister.gui.controls.Command;
import dev.twister.gui.controls.CommandActions;
import dev.twister.gui.controls.Ids;
import dev.twister.gui.controls.NumberField;
import dev.twister.gui.controls.PlainBox;
import dev.twister.gui.controls.Tooltips;
import dev.twister.gui.edit.KeyframeEdits;
import dev.twister.gui.studio.Film;
import dev.twister.gui.studio.Studio;
import dev.twister.scene.CameraKeyframe;
import dev.twister.scene.Scene;
import dev.twister.scene.property.SceneLimits;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import javafx.beans.property.ReadOnlyDoubleProperty;
import javafx.css.PseudoClass;
import javafx.geometry.Pos;
import javafx.scene.control.Button;
import javafx.scene.control.Label;
import javafx.scene.control.Slider;
import javafx.scene.control.TextField;
import javafx.scene.input.KeyCode;
import javafx.scene.input.KeyEvent;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Priority;
import javafx.scene.layout.Region;
import javafx.scene.layout.VBox;

/** The bar with the camera's keyframes on a time line, the present time, and buttons to set, delete and play. */
public final class FilmBar extends HBox {
    private static final PseudoClass WRONG = PseudoClass.getPseudoClass("wrong");
    private static final double SHORTEST_SECONDS = 10;

    /** Length of the time line relative to the last keyframe's time, to leave room for another one. */
    private static final double ROOM = 1.25;

    private static final int TIME_COLUMNS = 4;

    private final Studio studio;
    private final Film film;
    private final Button play;
    private final Button delete;
    private final TextField time = new TextField();
    private final Slider slider = new Slider(0, SHORTEST_SECONDS, 0);
    private final KeyframeMarks marks;
    private final VBox line;
    private final PlainBox<Listed> list;
    private List<CameraKeyframe> shown = List.of();
    private boolean showing;
    private boolean held;

    /** The time of the last keyframe of all; 0 if there is none. */
    private double lastSeconds;

    /** The text that the bar has set; any other was typed. */
    private String timeText = "";

    /** An item of the list; its index is below 0 if there is no keyframe at the present time. */
    private record Listed(int index, String label) {
        static Listed of(int index, int count, double seconds) {
            return new Listed(index, (index + 1) + " of " + count + ": " + KeyframeEdits.text(seconds) + " s");
        }

        static Listed none(int count) {
            return new Listed(-1, count == 0 ? "No keyframes" : count + (count == 1 ? " keyframe" : " keyframes"));
        }
    }

    /** @param leave moves the focus to the picture */
    public FilmBar(Studio studio, CommandActions actions, Runnable leave) {
        this.studio = studio;
        film = studio.film();
        setId("film");
        getStyleClass().add("film");
        setAlignment(Pos.CENTER_LEFT);
        visibleProperty().bind(film.shownProperty());
        managedProperty().bind(visibleProperty());
        play = button(Command.PLAY, actions);
        delete = button(Command.DELETE_KEYFRAME, actions);
        marks = new KeyframeMarks(studio, slider);
        line = new VBox(marks, slider);
        line.setMinWidth(0);
        setHgrow(line, Priority.ALWAYS);
        time.setId("film-time");
        time.setAccessibleText("Time in the film, in seconds");
        NumberField.stopCaret(time);
        time.setPrefColumnCount(TIME_COLUMNS);
        time.setMinWidth(USE_PREF_SIZE);
        time.setTooltip(Tooltips.of("Time in the film, in seconds. Between keyframes the camera goes there."));
        time.setOnAction(_ -> {
            if (takeTyped()) {
                leave.run();
            }
        });
        time.focusedProperty().subscribe(focused -> {
            if (!focused) {
                takeTyped();
            }
        });
        time.addEventFilter(KeyEvent.KEY_PRESSED, event -> {
            if (event.getCode() == KeyCode.ESCAPE) {
                showTime();
            }
        });
        slider.setId("film-slider");
        slider.setAccessibleText("Time in the film, in seconds");
        slider.setTooltip(Tooltips.of("Time in the film. Between keyframes the camera goes along."));
        slider.valueProperty().subscribe((_, value) -> {
            if (!showing) {
                film.goTo(value.doubleValue());
            }
        });
        slider.valueChangingProperty().subscribe(_ -> showRange());
        list = new PlainBox<>("film-list", Listed::label, this::goToListed);
        list.setAccessibleText("Keyframes");
        list.setTooltip(Tooltips.of("The keyframes. Choose one to go to it."));
        HBox present = new HBox(play, time, new Label("s"));
        present.getStyleClass().add("film-present");
        present.setAlignment(Pos.CENTER_LEFT);
        getChildren().addAll(present, line, list, button(Command.SET_KEYFRAME, actions), delete);
        getChildren().stream()
                .filter(Button.class::isInstance)
                .map(Button.class::cast)
                .forEach(button -> button.setMinWidth(USE_PREF_SIZE));
        film.secondsProperty().subscribe(_ -> show());
        film.playingProperty().subscribe(playing -> play.setText(playing ? "Stop" : Command.PLAY.label()));
        studio.sceneProperty().subscribe(this::follow);
        // The length of an animation is known once its file has been read.
        studio.pictureProperty().subscribe(_ -> follow(studio.scene()));
    }

    /** The time line, which is in this bar. */
    Region line() {
        return line;
    }

    /** Seconds from the left to the right end of the time line. */
    ReadOnlyDoubleProperty lengthProperty() {
        return slider.maxProperty();
    }

    /** Keeps the length of the time line, or lets it follow the keyframes again. */
    void hold(boolean kept) {
        held = kept;
        showRange();
    }

    private void goToListed() {
        list.choice().map(Listed::index).filter(index -> index >= 0).ifPresent(film::goToKeyframe);
    }

    private void follow(Scene scene) {
        if (!scene.camera().keyframes().equals(shown) || film.length() != lastSeconds) {
            show();
        }
    }

    private void show() {
        shown = film.keyframes();
        lastSeconds = film.length();
        showing = true;
        showRange();
        slider.setValue(film.secondsProperty().get());
        // The text does not change while it is being edited.
        if (!time.isFocused()) {
            showTime();
        }
        OptionalInt present = film.present();
        List<Listed> keyframes = IntStream.range(0, shown.size())
                .mapToObj(
                        index -> Listed.of(index, shown.size(), shown.get(index).seconds()))
                .toList();
        Listed chosen = present.isPresent() ? keyframes.get(present.getAsInt()) : Listed.none(shown.size());
        List<Listed> all = Stream.concat(Stream.of(Listed.none(shown.size())), keyframes.stream())
                .toList();
        list.offer(all, Optional.of(chosen));
        list.show(chosen);
        delete.setDisable(present.isEmpty());
        marks.show(shown, present);
        showing = false;
    }

    /** Not while the slider or a keyframe is held. */
    private void showRange() {
        if (!held && !slider.isValueChanging() && !marks.isHeld()) {
            slider.setMax(Math.max(
                    SHORTEST_SECONDS,
                    Math.max(ROOM * lastSeconds, film.secondsProperty().get())));
        }
    }

    private void showTime() {
        timeText = KeyframeEdits.text(film.secondsProperty().get());
        time.pseudoClassStateChanged(WRONG, false);
        time.setText(timeText);
    }

    /** Enters what was typed; returns whether it is a time, or nothing was typed. */
    private boolean takeTyped() {
        String typed = time.getText();
        if (typed.equals(timeText)) {
            return true;
        }
        Optional<Double> seconds = KeyframeEdits.parse(typed);
        time.pseudoClassStateChanged(WRONG, seconds.isEmpty());
        seconds.ifPresentOrElse(
                film::goTo,
                () -> studio.notice(
                        "Time is '" + typed.strip() + "', but must be a number " + SceneLimits.KEYFRAME_TIME));
        if (seconds.isPresent() || !time.isFocused()) {
            showTime();
        }
        return seconds.isPresent();
    }

    private static Button button(Command command, CommandActions actions) {
        return actions.button("film-" + Ids.of(command.label()), command);
    }
}
