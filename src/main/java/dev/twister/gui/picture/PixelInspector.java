package dev.twister.gui.picture;

import dev.twister.gui.drawing.DrawnPicture;
import dev.twister.gui.studio.BackgroundTasks;
import dev.twister.gui.studio.Studio;
import java.util.Optional;
import javafx.geometry.Point2D;
import javafx.geometry.Pos;
import javafx.scene.control.Label;
import javafx.scene.input.MouseEvent;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Region;
import javafx.scene.paint.Color;
import javafx.scene.shape.Rectangle;

/** Says what the pixel under the pointer is, over a corner of the picture. */
public final class PixelInspector extends HBox {
    private static final double SWATCH = 36;

    private final PictureView view;
    private final Studio studio;
    private final BackgroundTasks tasks;
    private final Rectangle swatch = new Rectangle(SWATCH, SWATCH);
    private final Label text = new Label();
    private Optional<Point2D> pointer = Optional.empty();
    private Optional<Asked> asked = Optional.empty();
    private boolean reading;

    /** A pixel of a picture. */
    private record Asked(long picture, int x, int y) {}

    public PixelInspector(PictureView view, Studio studio, BackgroundTasks tasks) {
        this.view = view;
        this.studio = studio;
        this.tasks = tasks;
        getStyleClass().add("inspector");
        setId("inspector");
        text.setId("inspector-text");
        text.setMinWidth(Region.USE_PREF_SIZE);
        setAlignment(Pos.CENTER_LEFT);
        setMouseTransparent(true);
        setMaxSize(USE_PREF_SIZE, USE_PREF_SIZE);
        setVisible(false);
        getChildren().addAll(swatch, text);
        text.setText("Point at a pixel");
        view.addEventFilter(MouseEvent.MOUSE_MOVED, this::moved);
        view.addEventFilter(MouseEvent.MOUSE_DRAGGED, this::moved);
        view.addEventFilter(MouseEvent.MOUSE_EXITED, _ -> pointer = Optional.empty());
    }

    /** Called in every pulse. */
    public void pulse() {
        if (isVisible() && !reading) {
            studio.pictureProperty().get().ifPresent(this::read);
        }
    }

    private void moved(MouseEvent event) {
        pointer = Optional.of(new Point2D(event.getX(), event.getY()));
    }

    private void read(DrawnPicture picture) {
        pointer.filter(place -> view.place().contains(place.getX(), place.getY()))
                .map(place -> view.place().toPicture(place.getX(), place.getY()))
                .ifPresent(place -> read(
                        picture,
                        Math.clamp((int) place.getX(), 0, picture.frame().width() - 1),
                        Math.clamp((int) place.getY(), 0, picture.frame().height() - 1)));
    }

    private void read(DrawnPicture picture, int x, int y) {
        Asked wanted = new Asked(picture.number(), x, y);
        if (!asked.equals(Optional.of(wanted))) {
            asked = Optional.of(wanted);
            reading = true;
            int argb = picture.frame().argb()[y * picture.frame().width() + x];
            tasks.run(
                    () -> PixelReading.of(picture.input(), picture.samples(), x, y, argb),
                    pixel -> show(pixel, picture),
                    problem -> show(problem.toString()));
        }
    }

    private void show(PixelReading pixel, DrawnPicture picture) {
        swatch.setFill(Color.rgb(pixel.argb() >> 16 & 255, pixel.argb() >> 8 & 255, pixel.argb() & 255));
        show(pixel.text(picture.sceneBody(pixel.body()), picture.request().shown()));
    }

    private void show(String said) {
        text.setText(said);
        reading = false;
    }
}
