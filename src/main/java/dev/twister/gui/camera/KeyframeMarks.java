package dev.twister.gui.camera;

import dev.twister.gui.edit.KeyframeEdits;
import dev.twister.gui.studio.Studio;
import dev.twister.scene.CameraKeyframe;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import javafx.css.PseudoClass;
import javafx.scene.AccessibleRole;
import javafx.scene.control.Slider;
import javafx.scene.input.KeyCode;
import javafx.scene.input.MouseEvent;
import javafx.scene.layout.Pane;
import javafx.scene.shape.Polygon;

/** Marks of the keyframes on the slider: a click goes to one, a drag changes its time. */
public final class KeyframeMarks extends Pane {
    private static final PseudoClass PRESENT = PseudoClass.getPseudoClass("present");
    private static final double HALF = 6;

    /** Radius of the slider's thumb, by which the track is shorter than the slider. */
    private static final double INSET = 8;

    private final Studio studio;
    private final Slider slider;
    private final List<Polygon> marks = new ArrayList<>();
    private List<CameraKeyframe> keyframes = List.of();
    private Optional<Integer> held = Optional.empty();

    KeyframeMarks(Studio studio, Slider slider) {
        this.studio = studio;
        this.slider = slider;
        setMinHeight(2 * HALF);
        setPrefHeight(2 * HALF);
        setId("film-marks");
        widthProperty().subscribe(_ -> place());
        heightProperty().subscribe(_ -> place());
        slider.maxProperty().subscribe(_ -> place());
    }

    void show(List<CameraKeyframe> now, OptionalInt present) {
        keyframes = now;
        while (marks.size() > now.size()) {
            getChildren().remove(marks.removeLast());
        }
        while (marks.size() < now.size()) {
            marks.add(mark(marks.size()));
            getChildren().add(marks.getLast());
        }
        for (int index = 0; index < marks.size(); index++) {
            marks.get(index).pseudoClassStateChanged(PRESENT, present.equals(OptionalInt.of(index)));
            marks.get(index)
                    .setAccessibleText(
                            "Keyframe at " + KeyframeEdits.text(now.get(index).seconds()) + " s");
        }
        place();
    }

    /** Whether a mark is being dragged. */
    boolean isHeld() {
        return held.isPresent();
    }

    private Polygon mark(int index) {
        Polygon mark = new Polygon(0, -HALF, HALF, 0, 0, HALF, -HALF, 0);
        mark.setManaged(false);
        mark.getStyleClass().add("keyframe");
        mark.setFocusTraversable(true);
        mark.setAccessibleRole(AccessibleRole.BUTTON);
        mark.setOnKeyPressed(event -> {
            if (event.getCode() == KeyCode.ENTER || event.getCode() == KeyCode.SPACE) {
                studio.film().goToKeyframe(index);
                event.consume();
            }
        });
        mark.setOnMousePressed(event -> {
            studio.film().goToKeyframe(index);
            event.consume();
        });
        mark.setOnMouseDragged(event -> drag(index, event));
        mark.setOnMouseReleased(event -> {
            held = Optional.empty();
            studio.endGesture();
            // The track must have room for its present time.
            studio.film().goToKeyframe(index);
            event.consume();
        });
        return mark;
    }

    private void drag(int index, MouseEvent event) {
        held = Optional.of(index);
        double part = (sceneToLocal(event.getSceneX(), event.getSceneY()).getX() - INSET) / length();
        studio.film().moveKeyframe(index, Math.clamp(part, 0, 1) * slider.getMax());
        event.consume();
    }

    private double length() {
        return Math.max(1, getWidth() - 2 * INSET);
    }

    private void place() {
        for (int index = 0; index < marks.size(); index++) {
            marks.get(index)
                    .relocate(
                            INSET + keyframes.get(index).seconds() / slider.getMax() * length() - HALF,
                            getHeight() / 2 - HALF);
        }
    }
}
