package dev.twister.gui.camera;

import dev.twister.gui.controls.Tooltips;
import dev.twister.gui.edit.BodyNumber;
import dev.twister.gui.edit.TrackEdits;
import dev.twister.gui.edit.TrackEdits.KeyMark;
import dev.twister.gui.studio.Studio;
import dev.twister.scene.Scene;
import dev.twister.scene.TrackTarget;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import javafx.beans.property.DoubleProperty;
import javafx.beans.property.SimpleDoubleProperty;
import javafx.geometry.Insets;
import javafx.geometry.Pos;
import javafx.scene.control.Label;
import javafx.scene.control.ScrollPane;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Priority;
import javafx.scene.layout.Region;
import javafx.scene.layout.VBox;

/** The keyframes of everything as marks, one row for each thing that has some. */
public final class DopeSheet extends ScrollPane {
    private final Studio studio;
    private final FilmBar film;
    private final VBox rows = new VBox();
    private final List<KeyframeLane> lanes = new ArrayList<>();
    private final DoubleProperty titleWidth = new SimpleDoubleProperty();
    private Set<KeyMark> selected = Set.of();
    private Set<KeyMark> copied = Set.of();
    private List<TrackTarget> shown = List.of();

    /** Rows below a film bar, under its time line. */
    public DopeSheet(Studio studio, FilmBar film) {
        this.studio = studio;
        this.film = film;
        setId("dope-sheet");
        getStyleClass().add("dope-sheet");
        setFitToWidth(true);
        setFocusTraversable(false);
        setHbarPolicy(ScrollBarPolicy.NEVER);
        setContent(rows);
        showRows(false);
        studio.sceneProperty().subscribe(this::follow);
        studio.film().shownProperty().subscribe(_ -> follow(studio.scene()));
        studio.film().secondsProperty().subscribe(_ -> draw());
        film.lengthProperty().subscribe(_ -> draw());
        film.line().layoutXProperty().subscribe(_ -> align());
        film.line().widthProperty().subscribe(_ -> align());
        rows.widthProperty().subscribe(_ -> align());
    }

    /** Puts the rows' marks under those of the time line. */
    private void align() {
        Region line = film.line();
        double left = film.sceneToLocal(rows.localToScene(0, 0)).getX();
        titleWidth.set(Math.max(0, line.getLayoutX() - left));
        rows.setPadding(new Insets(0, Math.max(0, left + rows.getWidth() - line.getLayoutX() - line.getWidth()), 0, 0));
    }

    /** The marks that are moved, copied and deleted together. */
    Set<KeyMark> selected() {
        return selected;
    }

    void select(Set<KeyMark> marks) {
        selected = Set.copyOf(marks);
        draw();
    }

    /** Keeps the rows' length while keyframes are dragged. */
    void hold(boolean held) {
        film.hold(held);
    }

    void copySelected() {
        copied = selected;
        studio.notice(copied.isEmpty() ? "Select keyframes to copy them" : count(copied) + " copied");
    }

    /** Adds copies of the copied keyframes, the first of them at the present time. */
    void paste() {
        double present = studio.film().secondsProperty().get();
        Scene before = studio.scene();
        studio.film().edit("paste keyframes", scene -> TrackEdits.copied(scene, copied, present));
        studio.endGesture();
        if (studio.scene().equals(before)) {
            studio.notice("No keyframes have been copied");
        }
    }

    void deleteSelected() {
        studio.film().edit("delete keyframes", scene -> TrackEdits.deleted(scene, selected));
        studio.endGesture();
        select(Set.of());
    }

    private static String count(Set<KeyMark> marks) {
        return marks.size() + (marks.size() == 1 ? " keyframe" : " keyframes");
    }

    private void follow(Scene scene) {
        List<TrackTarget> targets = studio.film().shownProperty().get() ? TrackEdits.targets(scene) : List.of();
        if (!targets.equals(shown)) {
            shown = targets;
            rows.getChildren().clear();
            lanes.clear();
            targets.forEach(this::addRow);
            showRows(!targets.isEmpty());
        }
        lanes.forEach(lane -> lane.follow(scene));
    }

    private void showRows(boolean any) {
        setVisible(any);
        setManaged(any);
    }

    private void addRow(TrackTarget target) {
        KeyframeLane lane = new KeyframeLane(this, studio, film.lengthProperty(), target);
        lanes.add(lane);
        Label title = new Label();
        title.getStyleClass().add("dope-title");
        title.textProperty().bind(lane.titleProperty());
        title.minWidthProperty().bind(titleWidth);
        title.prefWidthProperty().bind(titleWidth);
        title.setTooltip(Tooltips.of("Click to select it; double-click to select all of its keyframes."));
        title.setOnMouseClicked(event -> {
            if (event.getClickCount() > 1) {
                Set<KeyMark> all = new LinkedHashSet<>();
                TrackEdits.times(studio.scene(), target).forEach(time -> all.add(new KeyMark(target, time)));
                select(all);
            } else if (BodyNumber.of(target) != BodyNumber.NONE) {
                studio.selection().select(BodyNumber.of(target));
            }
        });
        HBox.setHgrow(lane, Priority.ALWAYS);
        HBox row = new HBox(title, lane);
        row.setAlignment(Pos.CENTER_LEFT);
        rows.getChildren().add(row);
    }

    private void draw() {
        lanes.forEach(KeyframeLane::draw);
    }
}
