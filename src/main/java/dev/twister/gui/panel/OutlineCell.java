package dev.twister.gui.panel;

import dev.twister.gui.edit.BodyNumber;
import java.util.Optional;
import javafx.css.PseudoClass;
import javafx.event.ActionEvent;
import javafx.scene.control.Label;
import javafx.scene.control.ListCell;
import javafx.scene.control.TextField;
import javafx.scene.input.KeyCode;
import javafx.scene.input.KeyEvent;
import javafx.scene.input.MouseEvent;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Priority;
import javafx.scene.layout.Region;
import javafx.scene.layout.StackPane;

/** A line of the list of bodies: its name, or the field that it is typed in, a lock and an eye. */
final class OutlineCell extends ListCell<OutlineLine> {
    /** What a cell is told to do. */
    interface Owner {
        boolean isRenamed(OutlineLine line);

        boolean isFolded(OutlineLine heading);

        void startRenaming(OutlineLine line);

        /** Takes a name; empty to leave the old one. */
        void endRenaming(Optional<String> name);

        void toggleHidden(OutlineLine line);

        void toggleLocked(OutlineLine line);

        void fold(OutlineLine heading, boolean isFolded);
    }

    private static final PseudoClass ON = PseudoClass.getPseudoClass("on");
    /** The id of the field that a name is typed in. */
    static final String FIELD = "body-name";

    private static final double HIDDEN_OPACITY = 0.5;

    private final Owner owner;
    private final Label fold = new Label();
    private final Label name = new Label();
    private final StackPane lock = button("lock");
    private final StackPane eye = button("eye");
    private final HBox line = new HBox(fold, name, lock, eye);

    OutlineCell(Owner owner) {
        this.owner = owner;
        line.getStyleClass().add("outline-line");
        HBox.setHgrow(name, Priority.ALWAYS);
        name.setMaxWidth(Double.MAX_VALUE);
        // A long name is cut, and does not make the list scroll sideways.
        setPrefWidth(0);
        setOnMouseClicked(event -> {
            if (event.getClickCount() == 2 && !isEmpty() && !owner.isRenamed(getItem())) {
                owner.startRenaming(getItem());
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
        on(lock, () -> owner.toggleLocked(getItem()));
        on(eye, () -> owner.toggleHidden(getItem()));
        on(fold, () -> owner.fold(getItem(), !owner.isFolded(getItem())));
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
        } else if (owner.isRenamed(item)) {
            setGraphic(field(item));
        } else {
            show(item);
            setGraphic(line);
        }
    }

    private void show(OutlineLine item) {
        boolean tagged = item.isHeading() || item.body() != BodyNumber.PLANE;
        String arrow = owner.isFolded(item) ? "▸ " : "▾ ";
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
        TextField field =
                new TextField(item.isHeading() ? item.tag().group() : item.tag().name());
        field.setPromptText(item.text());
        field.setId(FIELD);
        field.addEventHandler(ActionEvent.ACTION, event -> {
            owner.endRenaming(Optional.of(field.getText()));
            event.consume();
        });
        field.addEventFilter(KeyEvent.KEY_PRESSED, event -> {
            if (event.getCode() == KeyCode.ESCAPE) {
                owner.endRenaming(Optional.empty());
                event.consume();
            }
        });
        field.focusedProperty().subscribe((_, focused) -> {
            if (!focused && owner.isRenamed(item)) {
                owner.endRenaming(Optional.of(field.getText()));
            }
        });
        return field;
    }
}
