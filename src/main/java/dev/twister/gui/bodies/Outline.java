package dev.twister.gui.bodies;

import java.util.List;
import javafx.scene.Group;
import javafx.scene.shape.Polygon;

/** The outline of a body, readable over any picture. */
final class Outline extends Group {
    private final Polygon shade = new Polygon();
    private final Polygon line = new Polygon();

    Outline(String... styles) {
        setManaged(false);
        shade.getStyleClass().addAll("outline", "outline-shade");
        line.getStyleClass().add("outline");
        line.getStyleClass().addAll(styles);
        getChildren().addAll(shade, line);
    }

    Polygon line() {
        return line;
    }

    /** Sets the corners: x and y of each in turn. */
    void show(List<Double> points) {
        // Setting the same points would make JavaFX paint again.
        if (!line.getPoints().equals(points)) {
            line.getPoints().setAll(points);
            shade.getPoints().setAll(points);
        }
    }
}
