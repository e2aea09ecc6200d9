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
import javafx.css.PseudoClass;
import javafx.event.ActionEvent;
import javafx.scene.Node;
import javafx.scene.control.Label;
import javafx.scene.control.ListCell;
import javafx.scene.control.ListView;
import javafx.scene.control.MultipleSelectionModel;
import javafx.scene.control.SelectionMode;
import javafx.scene.control.TextField;
import javafx.scene.input.KeyCode;
import javafx.scene.input.KeyEvent;
import javafx.scene.input.MouseEvent;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Priority;
import javafx.scene.layout.Region;
import javafx.scene.layout.StackPane;

/** The list of bodies in their groups; several can be selected, named, hidden and locked. */
final class BodiesRow extends PanelRow {
    private static final PseudoClass ON = PseudoClass.getPseudoClass("on");

    /** The id of the field that a name is typed in. */
    private static final String FIELD = "body-name";

    private static final double HIDDEN_OPACITY = 0.5;

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
        list.setCellFactory(_ -> new Cell());
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

    private boolean isRenamed(OutlineLine line) {
        return renamed.filter(line::equals).isPresent();
    }

    private boolean isFolded(OutlineLine heading) {
        return folded.contains(heading.tag().group());
    }

    private void startRenaming(OutlineLine line) {
        if (line.isHeading() || (line.body() != BodyNumber.NONE && line.body() != BodyNumber.PLANE)) {
            renamed = Optional.of(line);
            list.refresh();
            list.applyCss();
            list.layout();
            // The cell has its field by now.
            list.lookup("#" + FIELD).requestFocus();
        }
    }

    /** Takes a name; empty to leave the old one. */
    private void endRenaming(Optional<String> name) {
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

    private void fold(OutlineLine heading, boolean isFolded) {
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

    /** A line of the list of bodies: its name, or the field that it is typed in, a lock and an eye. */
    private final class Cell extends ListCell<OutlineLine> {
        private final Label fold = new Label();
        private final Label name = new Label();
        private final StackPane lock = button("lock");
        private final StackPane eye = button("eye");
        private final HBox line = new HBox(fold, name, lock, eye);

        Cell() {
            line.getStyleClass().add("outline-line");
            HBox.setHgrow(name, Priority.ALWAYS);
            name.setMaxWidth(Double.MAX_VALUE);
            // A long name is cut, and does not make the list scroll sideways.
            setPrefWidth(0);
            setOnMouseClicked(event -> {
                if (event.getClickCount() == 2 && !isEmpty() && !isRenamed(getItem())) {
                    startRenaming(getItem());
                }
            });
            // What the field leaves of plain keys is no command.
            addEventHandler(KeyEvent.KEY_PRESSED, event -> {
                if (!event.isShortcutDown()
                        && !event.isAltDown()
                        && !event.getCode().isFunctionKey()) {
                    event.consume();
                }
            });
            on(lock, () -> tags.setLocked(getItem().bodies(), !getItem().tag().locked()));
            on(eye, () -> tags.setHidden(getItem().bodies(), !getItem().tag().hidden()));
            on(fold, () -> BodiesRow.this.fold(getItem(), !isFolded(getItem())));
        }

        private static StackPane button(String style) {
            Region icon = new Region();
            icon.getStyleClass().add(style);
            StackPane button = new StackPane(icon);
            button.getStyleClass().add("outline-button");
            return button;
        }

        /** A click on the part does that, and selects nothing. */
        private void on(Region part, Runnable action) {
            part.addEventFilter(MouseEvent.ANY, event -> {
                boolean button = !part.equals(fold) || getItem().isHeading();
                if (button && event.getEventType() == MouseEvent.MOUSE_PRESSED) {
                    action.run();
                }
                if (button) {
                    event.consume();
                }
            });
        }

        @Override
        protected void updateItem(OutlineLine item, boolean empty) {
            super.updateItem(item, empty);
            if (empty || item == null) {
                setGraphic(null);
            } else if (isRenamed(item)) {
                setGraphic(field(item));
            } else {
                show(item);
                setGraphic(line);
            }
        }

        private void show(OutlineLine item) {
            boolean tagged = item.isHeading() || item.body() != BodyNumber.PLANE;
            String arrow = isFolded(item) ? "▸ " : "▾ ";
            String indent = item.isInGroup() ? "    " : "";
            fold.setText(item.isHeading() ? arrow : indent);
            name.setText(item.text());
            name.setOpacity(item.tag().hidden() ? HIDDEN_OPACITY : 1);
            lock.setVisible(tagged);
            eye.setVisible(tagged);
            lock.pseudoClassStateChanged(ON, item.tag().locked());
            eye.pseudoClassStateChanged(ON, !item.tag().hidden());
            lock.setAccessibleText("Lock " + item.text());
            eye.setAccessibleText("Hide " + item.text());
        }

        private TextField field(OutlineLine item) {
            TextField field = new TextField(
                    item.isHeading() ? item.tag().group() : item.tag().name());
            field.setPromptText(item.text());
            field.setId(FIELD);
            field.addEventHandler(ActionEvent.ACTION, event -> {
                endRenaming(Optional.of(field.getText()));
                event.consume();
            });
            field.addEventFilter(KeyEvent.KEY_PRESSED, event -> {
                if (event.getCode() == KeyCode.ESCAPE) {
                    endRenaming(Optional.empty());
                    event.consume();
                }
            });
            field.focusedProperty().subscribe((_, focused) -> {
                if (!focused && isRenamed(item)) {
                    endRenaming(Optional.of(field.getText()));
                }
            });
            return field;
        }
    }
}
