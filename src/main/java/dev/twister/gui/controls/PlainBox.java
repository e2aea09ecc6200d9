package dev.twister.gui.controls;

import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import javafx.scene.control.ComboBox;
import javafx.util.StringConverter;

/** A box to choose one of several items. */
public final class PlainBox<T> extends ComboBox<T> {
    private final Runnable chosen;
    private boolean showing;

    /**
     * An empty box.
     *
     * @param label of an item
     * @param chosen called when the user has chosen another item
     */
    public PlainBox(String id, Function<T, String> label, Runnable chosen) {
        this.chosen = chosen;
        setId(id);
        setMaxWidth(Double.MAX_VALUE);
        setConverter(new StringConverter<>() {
            @Override
            public String toString(T thing) {
                return thing == null ? "" : label.apply(thing);
            }

            @Override
            public T fromString(String text) {
                throw new UnsupportedOperationException("nothing is typed here");
            }
        });
        DropDownKeys.install(this);
        valueProperty().subscribe((_, _) -> {
            if (!showing) {
                this.chosen.run();
            }
        });
    }

    /** Sets the items; keeps the choice if it is among them. */
    public void offer(List<T> things, Optional<T> usual) {
        showing = true;
        Optional<T> before = choice();
        if (!getItems().equals(things)) {
            getSelectionModel().clearSelection();
            getItems().setAll(things);
        }
        before.filter(things::contains).or(() -> usual).ifPresent(getSelectionModel()::select);
        showing = false;
    }

    /** Chooses an item without calling back. */
    public void show(T thing) {
        showing = true;
        getSelectionModel().select(thing);
        showing = false;
    }

    /** The chosen item; empty if there are none. */
    public Optional<T> choice() {
        return Optional.ofNullable(getValue());
    }
}
