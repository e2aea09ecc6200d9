package dev.twister.gui.rendering;

import java.util.List;
import java.util.function.IntConsumer;
import javafx.geometry.Pos;
import javafx.scene.control.Button;
import javafx.scene.control.Label;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Priority;
import javafx.scene.layout.VBox;

/** The renderings that wait for the present one, each with a button to remove it. */
final class WaitingRenders extends VBox {
    private List<String> shown = List.of();

    WaitingRenders() {
        setId("render-waiting");
        managedProperty().bind(visibleProperty());
        setVisible(false);
    }

    /** @param remove gets the place in the queue */
    void show(List<String> names, IntConsumer remove) {
        if (!names.equals(shown)) {
            shown = List.copyOf(names);
            getChildren().clear();
            for (int place = 0; place < shown.size(); place++) {
                getChildren().add(row(shown.get(place), place, remove));
            }
            setVisible(!shown.isEmpty());
        }
    }

    private static HBox row(String name, int place, IntConsumer remove) {
        Label label = new Label("Waiting: " + name);
        label.setMaxWidth(Double.MAX_VALUE);
        HBox.setHgrow(label, Priority.ALWAYS);
        Button button = new Button("Remove");
        button.setAccessibleText("Remove " + name + " from the queue");
        button.setOnAction(_ -> remove.accept(place));
        HBox row = new HBox(label, button);
        row.setAlignment(Pos.CENTER_LEFT);
        row.getStyleClass().add("render-fields");
        return row;
    }
}
