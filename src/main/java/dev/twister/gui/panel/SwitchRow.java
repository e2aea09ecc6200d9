package dev.twister.gui.panel;

import java.util.function.Consumer;
import javafx.beans.value.ObservableValue;
import javafx.scene.Node;
import javafx.scene.control.CheckBox;

/** Something that is on or off. */
final class SwitchRow extends PanelRow {
    private final CheckBox box = new CheckBox();
    private final Consumer<Boolean> choose;

    /**
     * A row that is off until {@link #show}.
     *
     * @param choose called when a person has switched
     */
    SwitchRow(String label, String hint, String key, Consumer<Boolean> choose) {
        super(label, hint, key);
        this.choose = choose;
        box.setOnAction(_ -> choose.accept(box.isSelected()));
        addControls(box);
    }

    /** Shows what is, and what a reset would lead to. */
    void show(boolean on, boolean usual) {
        box.setSelected(on);
        box.setText(on ? "on" : "off");
        setReset(on != usual, () -> choose.accept(usual));
    }

    /** Shows from now on whether it is on, whenever that changes. */
    void follow(ObservableValue<Boolean> on, boolean usual) {
        on.subscribe(now -> show(now, usual));
    }

    @Override
    public Node firstControl() {
        return box;
    }
}
