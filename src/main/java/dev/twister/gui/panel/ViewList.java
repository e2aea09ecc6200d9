package dev.twister.gui.panel;

import dev.twister.gui.controls.Ids;
import dev.twister.gui.controls.NumberField;
import dev.twister.gui.controls.Tooltips;
import dev.twister.gui.edit.ViewEdits;
import dev.twister.gui.studio.CameraControl;
import dev.twister.gui.studio.Studio;
import dev.twister.scene.CameraView;
import dev.twister.scene.Scene;
import java.util.List;
import java.util.Optional;
import java.util.function.UnaryOperator;
import javafx.css.PseudoClass;
import javafx.event.ActionEvent;
import javafx.scene.control.Button;
import javafx.scene.control.Label;
import javafx.scene.control.ListCell;
import javafx.scene.control.ListView;
import javafx.scene.control.TextField;
import javafx.scene.input.KeyCode;
import javafx.scene.input.KeyEvent;
import javafx.scene.layout.HBox;
import javafx.scene.layout.VBox;

/** The views that the scene keeps: a list to go to them, and buttons that edit it. */
final class ViewList extends VBox {
    private static final PseudoClass WRONG = PseudoClass.getPseudoClass("wrong");
    private static final int MOST_LINES = 6;
    private static final double LINE_EM = 2;
    private static final int NONE = -1;

    private final Studio studio;
    private final ListView<CameraView> list = new ListView<>();
    private final TextField name = new TextField();

    /** The place of the view whose name is typed. */
    private int renaming = NONE;

    ViewList(Studio studio) {
        this.studio = studio;
        getStyleClass().add("rows");
        Label none = new Label("The scene has no views");
        none.getStyleClass().add("hint");
        list.setId("views");
        list.setPlaceholder(none);
        list.setCellFactory(_ -> new Cell());
        list.setTooltip(Tooltips.of("Cameras that are saved with the scene. Double-click or Enter goes to one, and"
                + " so do the keys 1 to 9 and 0; with Ctrl they keep the camera there."));
        list.fixedCellSizeProperty().bind(none.fontProperty().map(font -> LINE_EM * font.getSize()));
        list.fixedCellSizeProperty().subscribe(_ -> fitHeight());
        list.addEventHandler(KeyEvent.KEY_PRESSED, this::pressed);
        name.setId("view-name");
        NumberField.stopCaret(name);
        name.setOnAction(_ -> {
            if (takeName()) {
                list.requestFocus();
            }
        });
        name.addEventHandler(ActionEvent.ACTION, ActionEvent::consume);
        name.addEventFilter(KeyEvent.KEY_PRESSED, event -> {
            if (event.getCode() == KeyCode.ESCAPE) {
                stopRenaming();
                list.requestFocus();
                event.consume();
            }
        });
        name.focusedProperty().subscribe(focused -> {
            if (!focused && !takeName()) {
                stopRenaming();
            }
        });
        Button goTo = button("Go to", "Moves the camera to the selected view.", this::goTo);
        Button rename = button("Rename", "Changes the name of the selected view.", this::startRenaming);
        Button update = button("Update", "Puts the selected view where the camera is now.", this::update);
        Button delete = button("Delete", "Deletes the selected view.\nKey: Delete, in the list", this::delete);
        Button add = button("Add", "Keeps the camera as it is now as another view.", this::add);
        List.of(goTo, rename, update, delete)
                .forEach(button -> button.disableProperty()
                        .bind(list.getSelectionModel().selectedItemProperty().isNull()));
        HBox buttons = new HBox(add, goTo, rename, update, delete);
        buttons.getStyleClass().add("buttons");
        getChildren().addAll(list, buttons);
        studio.sceneProperty().subscribe(scene -> show(scene.views()));
    }

    private static Button button(String text, String hint, Runnable action) {
        Button button = new Button(text);
        button.setId(Ids.of("view " + text));
        button.setTooltip(Tooltips.of(hint));
        button.setMinWidth(USE_PREF_SIZE);
        button.setOnAction(_ -> action.run());
        return button;
    }

    private void show(List<CameraView> views) {
        if (!list.getItems().equals(views)) {
            int selected = selected();
            stopRenaming();
            list.getSelectionModel().clearSelection();
            list.getItems().setAll(views);
            list.getSelectionModel().select(Math.min(selected, views.size() - 1));
            fitHeight();
        }
    }

    private void fitHeight() {
        double border = list.snappedTopInset() + list.snappedBottomInset();
        int lines = Math.clamp(list.getItems().size(), 1, MOST_LINES);
        list.setPrefHeight(lines * list.getFixedCellSize() + Math.max(2, border));
        list.setMinHeight(USE_PREF_SIZE);
    }

    private int selected() {
        return list.getSelectionModel().getSelectedIndex();
    }

    private void pressed(KeyEvent event) {
        boolean plain = !event.isShortcutDown() && !event.isAltDown() && !event.isShiftDown();
        if (plain && event.getCode() == KeyCode.ENTER) {
            goTo();
            event.consume();
        } else if (plain && event.getCode() == KeyCode.DELETE) {
            delete();
            event.consume();
        }
    }

    private void goTo() {
        Optional.ofNullable(list.getSelectionModel().getSelectedItem()).ifPresent(studio.cameraControl()::goTo);
    }

    private void add() {
        if (ViewEdits.isFull(studio.scene())) {
            studio.notice(CameraControl.FULL);
            return;
        }
        edit("add view", scene -> ViewEdits.added(scene, scene.camera()));
        list.getSelectionModel().selectLast();
        list.scrollTo(selected());
        startRenaming();
    }

    private void update() {
        edit("update view", scene -> ViewEdits.updated(scene, selected(), scene.camera()));
        studio.notice(
                "View updated: " + list.getSelectionModel().getSelectedItem().name());
    }

    private void delete() {
        if (selected() != NONE) {
            edit("delete view", scene -> ViewEdits.deleted(scene, selected()));
        }
    }

    private void edit(String what, UnaryOperator<Scene> change) {
        studio.endGesture();
        studio.editOnce(what, change);
    }

    private void startRenaming() {
        renaming = selected();
        name.setText(list.getSelectionModel().getSelectedItem().name());
        name.pseudoClassStateChanged(WRONG, false);
        list.refresh();
        list.applyCss();
        list.layout();
        name.requestFocus();
        name.selectAll();
    }

    private void stopRenaming() {
        if (renaming != NONE) {
            renaming = NONE;
            list.refresh();
        }
    }

    /** Renames the view as typed, if anything is; returns false, with a message, if it cannot have that name. */
    private boolean takeName() {
        if (renaming == NONE) {
            return true;
        }
        int index = renaming;
        String typed = name.getText().strip();
        Optional<String> complaint = ViewEdits.complaint(studio.scene(), index, typed);
        name.pseudoClassStateChanged(WRONG, complaint.isPresent());
        complaint.ifPresentOrElse(studio::notice, () -> {
            stopRenaming();
            edit("rename view", scene -> ViewEdits.renamed(scene, index, typed));
        });
        return complaint.isEmpty();
    }

    /** A view with the key that leads to it; or the field that its name is typed in. */
    private final class Cell extends ListCell<CameraView> {
        Cell() {
            // What the field leaves of plain keys is no command.
            addEventHandler(KeyEvent.KEY_PRESSED, event -> {
                if (!event.isShortcutDown()
                        && !event.isAltDown()
                        && !event.getCode().isFunctionKey()) {
                    event.consume();
                }
            });
            setOnMouseClicked(event -> {
                if (event.getClickCount() == 2 && !isEmpty() && getIndex() != renaming) {
                    goTo();
                }
            });
        }

        @Override
        protected void updateItem(CameraView view, boolean empty) {
            super.updateItem(view, empty);
            boolean typed = !empty && getIndex() == renaming;
            setGraphic(typed ? name : null);
            setText(
                    empty || typed
                            ? null
                            : ViewEdits.key(getIndex()).map(key -> key + "   ").orElse("     ") + view.name());
        }
    }
}
