package dev.twister.gui.camera;

import dev.twister.gui.controls.Tooltips;
import dev.twister.gui.edit.BodyTitles;
import dev.twister.gui.edit.KeyframeEdits;
import dev.twister.gui.edit.TrackEdits;
import dev.twister.gui.edit.TrackEdits.KeyMark;
import dev.twister.gui.studio.Studio;
import dev.twister.scene.Easing;
import dev.twister.scene.Keyframe;
import dev.twister.scene.Scene;
import dev.twister.scene.TrackTarget;
import dev.twister.world.Animation;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import javafx.beans.property.ReadOnlyDoubleProperty;
import javafx.beans.property.ReadOnlyStringProperty;
import javafx.beans.property.ReadOnlyStringWrapper;
import javafx.scene.AccessibleRole;
import javafx.scene.canvas.Canvas;
import javafx.scene.canvas.GraphicsContext;
import javafx.scene.control.CheckMenuItem;
import javafx.scene.control.ContextMenu;
import javafx.scene.control.MenuItem;
import javafx.scene.control.SeparatorMenuItem;
import javafx.scene.control.Tooltip;
import javafx.scene.input.KeyCode;
import javafx.scene.input.KeyEvent;
import javafx.scene.input.MouseButton;
import javafx.scene.input.MouseEvent;
import javafx.scene.layout.Pane;
import javafx.scene.paint.Color;

/** The keyframes of one thing as marks on a line: they are dragged, copied, deleted, and eased by a menu. */
final class KeyframeLane extends Pane {
    private static final double HALF = 5;
    private static final double INSET = 8;

    /** From the top and the bottom of the lane to a bar. */
    private static final double BAR = 6;

    private static final double REACH = 7;
    private static final double HEIGHT = 20;

    /** Seconds by which Shift and an arrow key move a keyframe. */
    private static final double STEP = 0.1;

    private static final Color GROUND = Color.web("#17181a");
    private static final Color LINE = Color.web("#3a3d43");
    private static final Color MARK = Color.web("#9fb7e8");
    private static final Color SELECTED = Color.web("#ffd24a");
    private static final Color PRESENT = Color.web("#5b93ff");

    private final DopeSheet sheet;
    private final Studio studio;
    private final ReadOnlyDoubleProperty seconds;
    private final TrackTarget target;
    private final Canvas canvas = new Canvas();
    private final ReadOnlyStringWrapper title = new ReadOnlyStringWrapper("");
    private Scene shown;
    private List<Double> times = List.of();
    private Optional<Held> held = Optional.empty();

    /** Marks that are dragged from a time, and the scene with them in their old places. */
    private record Held(Set<KeyMark> marks, double from, Scene scene) {}

    KeyframeLane(DopeSheet sheet, Studio studio, ReadOnlyDoubleProperty seconds, TrackTarget target) {
        this.sheet = sheet;
        this.studio = studio;
        this.seconds = seconds;
        this.target = target;
        shown = studio.scene();
        setId("lane-" + target.kind().label() + "-" + target.index());
        setPrefHeight(HEIGHT);
        setMinHeight(HEIGHT);
        setFocusTraversable(true);
        setAccessibleRole(AccessibleRole.SLIDER);
        getChildren().add(canvas);
        canvas.setHeight(HEIGHT);
        Tooltip.install(
                this,
                Tooltips.of(
                        "Keyframes. Drag one to another time; Shift selects several, Delete deletes them, Ctrl+C and"
                                + " Ctrl+V copy them to the current time. The right button has their easing."));
        widthProperty().subscribe(_ -> draw());
        focusedProperty().subscribe(_ -> draw());
        setOnMousePressed(this::pressed);
        setOnMouseDragged(this::dragged);
        setOnMouseReleased(_ -> released());
        setOnKeyPressed(this::keyPressed);
        setOnContextMenuRequested(event -> menu().show(this, event.getScreenX(), event.getScreenY()));
    }

    /** The name of what has the keyframes. */
    ReadOnlyStringProperty titleProperty() {
        return title.getReadOnlyProperty();
    }

    void follow(Scene scene) {
        shown = scene;
        times = TrackEdits.times(scene, target);
        title.set(BodyTitles.of(scene, target) + (TrackEdits.isLooped(scene, target) ? " (loops)" : ""));
        setAccessibleText("Keyframes of " + title.get() + " at "
                + times.stream().map(KeyframeEdits::text).collect(Collectors.joining(", ")) + " s");
        draw();
    }

    void draw() {
        canvas.setWidth(getWidth());
        GraphicsContext pen = canvas.getGraphicsContext2D();
        pen.setFill(GROUND);
        pen.fillRect(0, 0, getWidth(), HEIGHT);
        pen.setStroke(isFocused() ? PRESENT : LINE);
        pen.strokeLine(INSET, HEIGHT / 2, getWidth() - INSET, HEIGHT / 2);
        drawTurn(pen);
        pen.setStroke(PRESENT);
        double present = x(studio.film().secondsProperty().get());
        pen.strokeLine(present, 0, present, HEIGHT);
        for (double time : times) {
            pen.setFill(isSelected(time) ? SELECTED : MARK);
            drawMark(pen, x(time), easing(time));
        }
    }

    /** A bar as long as one turn of a mesh's animation, or what is left of it. */
    private void drawTurn(GraphicsContext pen) {
        if (target.kind() == TrackTarget.Kind.MESH
                && target.index() < shown.meshes().size()) {
            double turn = Animation.turn(
                    shown.meshes().get(target.index()), studio.bodies().meshes());
            if (turn > 0) {
                pen.setFill(LINE);
                pen.fillRect(x(0), BAR, x(Math.min(turn, seconds.get())) - x(0), HEIGHT - 2 * BAR);
            }
        }
    }

    /** A diamond; a square where the value is held; a disc where it changes at constant speed. */
    private static void drawMark(GraphicsContext pen, double x, Easing easing) {
        double y = HEIGHT / 2;
        switch (easing) {
            case SMOOTH ->
                pen.fillPolygon(new double[] {x, x + HALF, x, x - HALF}, new double[] {y - HALF, y, y + HALF, y}, 4);
            case LINEAR -> pen.fillOval(x - HALF, y - HALF, 2 * HALF, 2 * HALF);
            case HOLD -> pen.fillRect(x - HALF + 1, y - HALF + 1, 2 * HALF - 2, 2 * HALF - 2);
        }
    }

    private Easing easing(double time) {
        return shown.tracks().stream()
                .filter(track -> track.target().equals(target))
                .flatMap(track -> track.keyframes().stream())
                .filter(keyframe -> TrackEdits.isAt(keyframe.seconds(), time))
                .findFirst()
                .map(Keyframe::easing)
                .orElse(Easing.SMOOTH);
    }

    private boolean isSelected(double time) {
        return sheet.selected().contains(new KeyMark(target, time));
    }

    private double length() {
        return Math.max(1, getWidth() - 2 * INSET);
    }

    private double x(double time) {
        return INSET + time / seconds.get() * length();
    }

    private double time(double x) {
        return KeyframeEdits.time((x - INSET) / length() * seconds.get());
    }

    private Optional<KeyMark> markAt(double x) {
        return times.stream()
                .filter(time -> Math.abs(x(time) - x) <= REACH)
                .min((one, other) -> Double.compare(Math.abs(x(one) - x), Math.abs(x(other) - x)))
                .map(time -> new KeyMark(target, time));
    }

    private void pressed(MouseEvent event) {
        requestFocus();
        Optional<KeyMark> mark = markAt(event.getX());
        boolean more = event.isShiftDown() || event.isShortcutDown();
        mark.ifPresentOrElse(at -> choose(at, more), () -> {
            if (!more && event.getButton() == MouseButton.PRIMARY) {
                sheet.select(Set.of());
            }
        });
        if (event.getButton() == MouseButton.PRIMARY) {
            studio.film().goTo(mark.map(KeyMark::seconds).orElseGet(() -> time(event.getX())));
            held = mark.filter(sheet.selected()::contains)
                    .map(_ -> new Held(sheet.selected(), time(event.getX()), studio.scene()));
            sheet.hold(held.isPresent());
        }
        event.consume();
    }

    private void choose(KeyMark mark, boolean more) {
        Set<KeyMark> chosen = new LinkedHashSet<>(sheet.selected());
        if (more && !chosen.remove(mark)) {
            chosen.add(mark);
        }
        if (!more && !chosen.contains(mark)) {
            chosen = Set.of(mark);
        }
        sheet.select(chosen);
    }

    private void dragged(MouseEvent event) {
        if (event.getButton() == MouseButton.PRIMARY) {
            held.ifPresentOrElse(
                    taken -> move(taken, time(event.getX()) - taken.from()),
                    () -> studio.film().goTo(time(event.getX())));
        }
        event.consume();
    }

    private void move(Held taken, double later) {
        Scene moved = TrackEdits.moved(taken.scene(), taken.marks(), later);
        studio.film()
                .edit(
                        "move keyframes",
                        scene -> scene.withTracks(moved.tracks())
                                .withCamera(scene.camera()
                                        .withKeyframes(moved.camera().keyframes())));
        sheet.select(TrackEdits.movedMarks(taken.marks(), later));
    }

    private void released() {
        if (held.isPresent()) {
            held = Optional.empty();
            sheet.hold(false);
            studio.endGesture();
        }
    }

    private void keyPressed(KeyEvent event) {
        KeyCode key = event.getCode();
        if (key == KeyCode.DELETE || key == KeyCode.BACK_SPACE) {
            sheet.deleteSelected();
        } else if (event.isShortcutDown() && key == KeyCode.C) {
            sheet.copySelected();
        } else if (event.isShortcutDown() && key == KeyCode.V) {
            sheet.paste();
        } else if (key == KeyCode.LEFT || key == KeyCode.RIGHT) {
            step(event.isShiftDown(), key == KeyCode.RIGHT ? 1 : -1);
        } else {
            return;
        }
        event.consume();
    }

    /** Goes to the next mark, or moves the selected ones. */
    private void step(boolean moves, int direction) {
        if (moves) {
            move(new Held(sheet.selected(), 0, studio.scene()), direction * STEP);
            return;
        }
        double present = studio.film().secondsProperty().get();
        (direction > 0 ? times : times.reversed())
                .stream()
                        .filter(time -> !TrackEdits.isAt(time, present) && (time > present) == (direction > 0))
                        .findFirst()
                        .ifPresent(time -> {
                            sheet.select(Set.of(new KeyMark(target, time)));
                            studio.film().goTo(time);
                        });
    }

    private ContextMenu menu() {
        ContextMenu menu = new ContextMenu();
        for (Easing easing : Easing.values()) {
            menu.getItems().add(item(BodyTitles.property(easing.name().toLowerCase(Locale.ROOT)), () -> {
                studio.film().edit("easing", scene -> TrackEdits.eased(scene, sheet.selected(), easing));
                studio.endGesture();
            }));
        }
        CheckMenuItem loop = new CheckMenuItem("Loop");
        loop.setSelected(TrackEdits.isLooped(shown, target));
        loop.setOnAction(_ -> {
            studio.film().edit("loop", scene -> TrackEdits.looped(scene, target, loop.isSelected()));
            studio.endGesture();
        });
        menu.getItems()
                .addAll(
                        new SeparatorMenuItem(),
                        item("Copy", sheet::copySelected),
                        item("Paste at the current time", sheet::paste),
                        item("Delete", sheet::deleteSelected),
                        new SeparatorMenuItem(),
                        loop);
        return menu;
    }

    private static MenuItem item(String label, Runnable action) {
        MenuItem item = new MenuItem(label);
        item.setOnAction(_ -> action.run());
        return item;
    }
}
