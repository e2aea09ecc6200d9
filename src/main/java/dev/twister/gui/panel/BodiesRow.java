package dev.twister.gui.panel;

import dev.twister.gui.controls.Command;
import dev.twister.gui.edit.BodyNumber;
import dev.twister.gui.edit.SelectedBodies;
import dev.twister.gui.studio.Studio;
import dev.twister.gui.studio.TagActions;
import dev.twister.scene.Scene;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.IntStream;
import javafx.application.Platform;
import javafx.collections.ListChangeListener;
import javafx.scene.Node;
import javafx.scene.control.ListView;
import javafx.scene.control.MultipleSelectionModel;
import javafx.scene.control.SelectionMode;
import javafx.scene.input.KeyCode;
import javafx.scene.input.KeyEvent;

/** The list of bodies in their groups; several can be selected, named, hidden and locked. */
final class BodiesRow extends PanelRow implements OutlineCell.Owner {
    private final Studio studio;
    private final TagActions tags;
    private final ListView<OutlineLine> list = new ListView<>();
    private final Set<String> folded = new HashSet<>();
    private Optional<OutlineLine> renamed = Optional.empty();
    private boolean showing;
    private boolean taking;
    private int shownActive = BodyNumber.NONE;

    BodiesRow(Studio studio, TagActions tags) {
        super(
                "Bodies",
                "The selected bodies. Shift and Ctrl select several, here and by clicks in the picture. A double click "
                        + "or F2 here renames; the eye hides, the lock keeps from clicks and moves. Left and Right "
                        + "fold a group.",
                "Alt+Shift+O");
        this.studio = studio;
        this.tags = tags;
        list.getStyleClass().add("bodies");
        list.getSelectionModel().setSelectionMode(SelectionMode.MULTIPLE);
        list.setCellFactory(_ -> new OutlineCell(this));
        list.getSelectionModel().getSelectedIndices().addListener((ListChangeListener<Integer>) _ -> takeSoon());
        list.addEventFilter(KeyEvent.KEY_PRESSED, this::pressed);
        addControls(list);
    }

    /** Shows the scene's bodies and marks the selected ones. */
    void show(Scene scene, SelectedBodies selected) {
        showing = true;
        List<OutlineLine> lines = OutlineLine.of(scene, selected, folded);
        MultipleSelectionModel<OutlineLine> marks = list.getSelectionModel();
        if (!list.getItems().equals(lines)) {
            marks.clearSelection();
            list.getItems().setAll(lines);
        }
        int[] wanted = IntStream.range(0, lines.size())
                .filter(line -> selected.contains(lines.get(line).body()))
                .toArray();
        if (!marks.getSelectedIndices().equals(IntStream.of(wanted).boxed().toList())) {
            marks.clearSelection();
            if (wanted.length > 0) {
                marks.selectIndices(wanted[0], wanted);
            }
        }
        if (selected.active() != shownActive) {
            shownActive = selected.active();
            focus(IntStream.range(0, lines.size())
                    .filter(line -> lines.get(line).body() == shownActive)
                    .findFirst()
                    .orElse(-1));
        }
        showing = false;
        setReset(selected.count() > 0, () -> studio.selection().select(BodyNumber.NONE));
    }

    @Override
    public Node firstControl() {
        return list;
    }

    @Override
    public boolean isRenamed(OutlineLine line) {
        return renamed.filter(line::equals).isPresent();
    }

    @Override
    public boolean isFolded(OutlineLine heading) {
        return folded.contains(heading.tag().group());
    }

    @Override
    public void startRenaming(OutlineLine line) {
        if (line.isHeading() || (line.body() != BodyNumber.NONE && line.body() != BodyNumber.PLANE)) {
            renamed = Optional.of(line);
            list.refresh();
            list.applyCss();
            list.layout();
            // The cell has its field by now.
            list.lookup("#" + OutlineCell.FIELD).requestFocus();
        }
    }

    @Override
    public void endRenaming(Optional<String> name) {
        Optional<OutlineLine> line = renamed;
        renamed = Optional.empty();
        line.ifPresent(of -> name.map(String::strip).ifPresent(typed -> {
            if (!of.isHeading()) {
                tags.rename(of.body(), typed);
            } else if (!typed.isEmpty()) {
                tags.renameGroup(of.tag().group(), typed);
            }
        }));
        list.refresh();
        list.requestFocus();
    }

    @Override
    public void toggleHidden(OutlineLine line) {
        tags.setHidden(line.bodies(), !line.tag().hidden());
    }

    @Override
    public void toggleLocked(OutlineLine line) {
        tags.setLocked(line.bodies(), !line.tag().locked());
    }

    @Override
    public void fold(OutlineLine heading, boolean isFolded) {
        String group = heading.tag().group();
        boolean changed = isFolded ? folded.add(group) : folded.remove(group);
        if (changed) {
            show(studio.scene(), studio.selection().bodies());
        }
    }

    private void pressed(KeyEvent event) {
        OutlineLine line = list.getFocusModel().getFocusedItem();
        boolean plain = !event.isShortcutDown() && !event.isAltDown() && !event.isShiftDown();
        if (renamed.isPresent() || !plain || line == null) {
            leave(event);
        } else if (event.getCode() == KeyCode.F2) {
            startRenaming(line);
            event.consume();
        } else if (line.isHeading() && (event.getCode() == KeyCode.LEFT || event.getCode() == KeyCode.RIGHT)) {
            fold(line, event.getCode() == KeyCode.LEFT);
            event.consume();
        } else {
            leave(event);
        }
    }

    private void leave(KeyEvent event) {
        if (renamed.isEmpty()) {
            leaveToTheWindow(event, Command.DESELECT, Command.RESET, Command.SELECT_ALL);
        }
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
        Set<Integer> chosen = new LinkedHashSet<>();
        for (OutlineLine line : new ArrayList<>(list.getSelectionModel().getSelectedItems())) {
            chosen.addAll(line.bodies());
        }
        OutlineLine clicked = list.getFocusModel().getFocusedItem();
        if (clicked != null && chosen.remove(clicked.body())) {
            chosen.add(clicked.body());
        }
        studio.selection().select(chosen);
        // The plane can only be selected alone: it loses its mark among others.
        show(studio.scene(), studio.selection().bodies());
    }
}
