package dev.twister.gui.viewer;

import dev.twister.gui.controls.Ids;
import dev.twister.gui.controls.Tooltips;
import dev.twister.gui.viewer.ComparedPictures.Mode;
import javafx.beans.property.ObjectProperty;
import javafx.beans.property.SimpleObjectProperty;
import javafx.scene.control.Button;
import javafx.scene.control.Label;
import javafx.scene.control.ToggleButton;
import javafx.scene.control.ToggleGroup;
import javafx.scene.layout.FlowPane;
import javafx.scene.layout.VBox;

/** The ways to compare the picture of a file with the rendering. */
final class CompareControls extends VBox {
    private final ObjectProperty<Mode> mode = new SimpleObjectProperty<>(Mode.FIRST);
    private final ToggleGroup group = new ToggleGroup();
    private final Label result = new Label();

    /** @param take takes the present rendering */
    CompareControls(Runnable take) {
        getStyleClass().add("rows");
        FlowPane buttons = new FlowPane();
        buttons.getStyleClass().add("compare-modes");
        for (Mode one : Mode.values()) {
            ToggleButton button = new ToggleButton(one.label());
            button.setId("compare-" + Ids.of(one.label()));
            button.setTooltip(Tooltips.of(one.hint()));
            button.setToggleGroup(group);
            button.setOnAction(_ -> {
                // A click on the chosen one does not take the choice back.
                button.setSelected(true);
                mode.set(one);
            });
            mode.subscribe(now -> button.setSelected(now == one));
            buttons.getChildren().add(button);
        }
        Button again = new Button("Take the rendering again");
        again.setId("compare-again");
        again.setTooltip(Tooltips.of("Compares with the window's picture as it is now."));
        again.setOnAction(_ -> take.run());
        result.setId("compare-result");
        result.setWrapText(true);
        getChildren().addAll(new Label("Compare with the rendering"), buttons, again, result);
    }

    ObjectProperty<Mode> modeProperty() {
        return mode;
    }

    /** Goes to and fro between the two pictures. */
    void flip() {
        mode.set(mode.get() == Mode.SECOND ? Mode.FIRST : Mode.SECOND);
    }

    void tell(String text) {
        result.setText(text);
    }
}
