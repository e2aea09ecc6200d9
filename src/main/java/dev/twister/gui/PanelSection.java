package dev.twister.gui;

import javafx.scene.Node;
import javafx.scene.control.Label;
import javafx.scene.layout.VBox;

/** Rows that belong together, under a heading. */
final class PanelSection extends VBox {
    PanelSection(String heading, Node... rows) {
        getStyleClass().add("section");
        Label label = new Label(heading);
        label.getStyleClass().add("heading");
        getChildren().add(label);
        getChildren().addAll(rows);
    }
}
