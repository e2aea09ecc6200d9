package dev.twister.gui.panel;

import dev.twister.gui.controls.Command;
import dev.twister.gui.model.BodyChoices;
import dev.twister.gui.model.BodyNumber;
import dev.twister.gui.model.SelectedBodies;
import dev.twister.gui.studio.Studio;
import dev.twister.scene.Scene;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.stream.IntStream;
import javafx.application.Platform;
import javafx.collections.ListChangeListener;
import javafx.scene.Node;
import javafx.scene.control.ListCell;
import javafx.scene.control.ListView;
import javafx.scene.control.MultipleSelectionModel;
import javafx.scene.control.SelectionMode;
import javafx.scene.input.KeyEvent;

/** The list of bodies; several can be selected. */
final class BodiesRow extends PanelRow {
    private final Studio studio;
    private final ListView<Named> list = new ListView<>();
    private boolean showing;
    private boolean taking;
    private int shownActive = BodyNumber.NONE;

    /** An item of the list. */
    private record Named(int body, String name) {
        static Named of(Scene scene, int body) {
            return new Named(body, BodyChoices.name(scene, body));
        }
    }

    BodiesRow(Studio studio) {
        super(
                "Bodies",
                "The selected bodies. Shift and Ctrl select several, here and by clicks in the picture; F2 selects the "
                        + "next one.",
                "Alt+Shift+O");
        this.studio = studio;
        list.getStyleClass().add("bodies");
        list.getSelectionModel().setSelectionMode(SelectionMode.MULTIPLE);
        list.setCellFactory(_ -> new NameCell());
        list.getSelectionModel().getSelectedIndices().addListener((ListChangeListener<Integer>) _ -> takeSoon());
        list.addEventFilter(
                KeyEvent.KEY_PRESSED,
                event -> leaveToTheWindow(event, Command.DESELECT, Command.RESET, Command.SELECT_ALL));
        addControls(list);
    }

    /** Shows the scene's bodies and marks the selected ones. */
    void show(Scene scene, SelectedBodies selected) {
        showing = true;
        List<Named> names = BodyChoices.of(scene, selected).stream()
                .map(body -> Named.of(scene, body))
                .toList();
        MultipleSelectionModel<Named> marks = list.getSelectionModel();
        if (!list.getItems().equals(names)) {
            marks.clearSelection();
            list.getItems().setAll(names);
        }
        if (!new LinkedHashSet<>(marked()).equals(selected.bodies())) {
            marks.clearSelection();
            int[] lines = IntStream.range(0, names.size())
                    .filter(line -> selected.contains(names.get(line).body()))
                    .toArray();
            if (lines.length > 0) {
                marks.selectIndices(lines[0], lines);
            }
        }
        if (selected.active() != shownActive) {
            shownActive = selected.active();
            focus(names.indexOf(Named.of(scene, shownActive)));
        }
        showing = false;
        setReset(selected.count() > 0, () -> studio.selection().select(BodyNumber.NONE));
    }

    @Override
    public Node firstControl() {
        return list;
    }

    private void focus(int line) {
        list.getFocusModel().focus(line);
        // The list must not change under a pointer that clicks in it.
        if (line >= 0 && !taking) {
            list.scrollTo(Math.max(0, line - 1));
        }
    }

    /** One click changes the marks several times. */
    private void takeSoon() {
        if (!showing && !taking) {
            taking = true;
            Platform.runLater(() -> {
                take();
                taking = false;
            });
        }
    }

    private void take() {
        Set<Integer> chosen = new LinkedHashSet<>(marked());
        Named clicked = list.getFocusModel().getFocusedItem();
        if (clicked != null && chosen.remove(clicked.body())) {
            chosen.add(clicked.body());
        }
        studio.selection().select(chosen);
        // The plane can only be selected alone: it loses its mark among others.
        show(studio.scene(), studio.selection().bodies());
    }

    private List<Integer> marked() {
        return new ArrayList<>(list.getSelectionModel().getSelectedItems())
                .stream().map(Named::body).toList();
    }

    private static final class NameCell extends ListCell<Named> {
        @Override
        protected void updateItem(Named item, boolean empty) {
            super.updateItem(item, empty);
            setText(empty || item == null ? "" : item.name());
        }
    }
}
