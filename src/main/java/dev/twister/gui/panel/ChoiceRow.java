package dev.twister.gui.panel;

import dev.twister.gui.controls.DropDownKeys;
import dev.twister.gui.controls.Tooltips;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Function;
import javafx.beans.value.ObservableValue;
import javafx.scene.Node;
import javafx.scene.control.ComboBox;
import javafx.scene.control.ListCell;

/** A row to choose one of several items; unavailable ones are gray and say why. */
public final class ChoiceRow<T> extends PanelRow {
    private final ComboBox<T> box = new ComboBox<>();
    private final Consumer<T> choose;
    private final Consumer<String> complain;
    private final Function<T, Look> look;
    private Optional<T> shown = Optional.empty();
    private boolean showing;

    /**
     * How an item is shown.
     *
     * @param label in the list
     * @param name in the closed box, which is narrow
     * @param hint for the tooltip; may be empty
     * @param obstacle why it is unavailable; empty if it is available
     */
    public record Look(String label, String name, String hint, Optional<String> obstacle) {
        public Look(String label) {
            this(label, label, "", Optional.empty());
        }
    }

    /**
     * A row that is empty until {@link #show}.
     *
     * @param choose called when the user has chosen an available item
     * @param complain called with the obstacle of an unavailable one
     */
    public ChoiceRow(
            String label,
            String hint,
            String key,
            Function<T, Look> look,
            Consumer<T> choose,
            Consumer<String> complain) {
        super(label, hint, key);
        this.look = look;
        this.choose = choose;
        this.complain = complain;
        box.setButtonCell(new LookCell(Look::name));
        box.setCellFactory(_ -> new LookCell(Look::label));
        box.valueProperty().subscribe((_, chosen) -> {
            if (!showing && chosen != null) {
                take(chosen);
            }
        });
        DropDownKeys.install(box);
        addControls(box);
    }

    /** Shows the items, the chosen one and the one that a reset leads to; items are compared by equality. */
    public void show(List<T> things, T chosen, T usual) {
        showing = true;
        // An open list keeps the height for the items that it was opened with.
        boolean reopens = box.isShowing() && !box.getItems().equals(things);
        if (reopens) {
            box.hide();
        }
        if (!box.getItems().equals(things)) {
            // Otherwise the box keeps the line's number, whatever item is there now.
            box.getSelectionModel().clearSelection();
            box.getItems().setAll(things);
        }
        box.getSelectionModel().select(chosen);
        shown = Optional.of(chosen);
        showing = false;
        if (reopens) {
            box.show();
        }
        setReset(!chosen.equals(usual), () -> choose.accept(usual));
    }

    /** Shows a value among these items from now on, whenever it changes. */
    void follow(ObservableValue<T> value, List<T> things, T usual) {
        value.subscribe(now -> show(things, now, usual));
    }

    @Override
    public Node firstControl() {
        return box;
    }

    private void take(T chosen) {
        Optional<String> obstacle = look.apply(chosen).obstacle();
        if (obstacle.isEmpty()) {
            choose.accept(chosen);
        } else {
            complain.accept(look.apply(chosen).label() + ": " + obstacle.get());
            showing = true;
            shown.ifPresent(box.getSelectionModel()::select);
            showing = false;
        }
    }

    /** A line of the list, or the content of the closed box. */
    private final class LookCell extends ListCell<T> {
        private final Function<Look, String> text;

        LookCell(Function<Look, String> text) {
            this.text = text;
        }

        @Override
        protected void updateItem(T item, boolean empty) {
            super.updateItem(item, empty);
            if (empty || item == null) {
                setText("");
                setTooltip(null);
                setDisable(false);
            } else {
                Look shownAs = look.apply(item);
                // A disabled line gets no mouse events, so it would show no tooltip.
                setText(shownAs.obstacle()
                        .map(why -> text.apply(shownAs) + "\n" + Tooltips.wrap(why))
                        .orElse(text.apply(shownAs)));
                setTooltip(shownAs.hint().isEmpty() ? null : Tooltips.of(shownAs.hint()));
                setDisable(shownAs.obstacle().isPresent());
            }
        }
    }
}
