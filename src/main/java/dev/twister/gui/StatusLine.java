package dev.twister.gui;

import javafx.geometry.Pos;
import javafx.scene.control.Label;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Priority;
import javafx.scene.layout.Region;

/** One line under the picture: what is drawn, and what is going on. */
final class StatusLine extends HBox {
    StatusLine(Studio studio) {
        getStyleClass().add("status");
        setAlignment(Pos.CENTER_LEFT);
        Label facts = new Label("starting…");
        facts.setId("facts");
        facts.setMinWidth(0);
        Label message = new Label();
        message.setId("message");
        message.setMinWidth(0);
        Region gap = new Region();
        setHgrow(gap, Priority.ALWAYS);
        getChildren().addAll(facts, gap, message);
        studio.pictureProperty()
                .subscribe(picture -> picture.map(StatusText::facts).ifPresent(facts::setText));
        studio.drawingProperty().subscribe(status -> message.setText(StatusText.message(status)));
    }
}
