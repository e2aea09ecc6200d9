package dev.twister.gui;

import dev.twister.gui.drawing.DrawnPicture;
import javafx.scene.control.Label;
import javafx.scene.layout.HBox;

/** One line under the picture: scene, engine, size, bodies. */
final class StatusLine extends HBox {
    private final Label facts = new Label("starting…");

    StatusLine(Studio studio) {
        getStyleClass().add("status");
        getChildren().add(facts);
        studio.pictureProperty()
                .subscribe(picture -> picture.map(StatusLine::describe).ifPresent(facts::setText));
    }

    private static String describe(DrawnPicture picture) {
        return "%s · %s (%s) · %d × %d · %d bodies"
                .formatted(
                        picture.request().scene().name(),
                        picture.engine(),
                        picture.device(),
                        picture.frame().width(),
                        picture.frame().height(),
                        picture.request().scene().spheres().size() + 2);
    }
}
