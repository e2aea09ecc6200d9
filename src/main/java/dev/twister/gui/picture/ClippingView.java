package dev.twister.gui.picture;

import dev.twister.gui.drawing.DrawnPicture;
import dev.twister.gui.studio.Studio;
import dev.twister.image.Histogram;
import java.nio.IntBuffer;
import java.util.stream.IntStream;
import javafx.beans.property.BooleanProperty;
import javafx.beans.property.SimpleBooleanProperty;
import javafx.scene.image.ImageView;
import javafx.scene.image.PixelBuffer;
import javafx.scene.image.PixelFormat;
import javafx.scene.image.WritableImage;
import javafx.scene.layout.Pane;

/** Marks the clipped pixels: red if a channel is at its highest level, blue if all are 0. */
public final class ClippingView extends Pane {
    public static final int WHITE = 0xFFFF2020;
    public static final int BLACK = 0xFF2040FF;
    private static final int CLEAR = 0;

    private final Studio studio;
    private final BooleanProperty shown = new SimpleBooleanProperty();
    private final ImageView image = new ImageView();

    public ClippingView(PictureView picture, Studio studio) {
        this.studio = studio;
        setId("clipping");
        setMouseTransparent(true);
        image.setManaged(false);
        getChildren().add(image);
        visibleProperty().bind(shown);
        shown.subscribe(_ -> refresh());
        studio.pictureProperty().subscribe(_ -> refresh());
        picture.image().boundsInParentProperty().subscribe(place -> {
            image.setFitWidth(place.getWidth());
            image.setFitHeight(place.getHeight());
            image.relocate(place.getMinX(), place.getMinY());
        });
        // A mark of one pixel must not fade when pixels are small.
        image.setSmooth(false);
    }

    public BooleanProperty shownProperty() {
        return shown;
    }

    private void refresh() {
        if (shown.get()) {
            studio.pictureProperty().get().ifPresent(this::mark);
        } else {
            // As large as the picture.
            image.setImage(null);
        }
    }

    private void mark(DrawnPicture picture) {
        int width = picture.frame().width();
        int height = picture.frame().height();
        if (!picture.request().shown().isColor()) {
            image.setImage(null);
            return;
        }
        int[] argb = picture.frame().argb();
        int[] marks = new int[width * height];
        IntStream.range(0, height).parallel().forEach(row -> {
            for (int at = width * row; at < width * (row + 1); at++) {
                marks[at] = mark(argb[at]);
            }
        });
        image.setImage(new WritableImage(
                new PixelBuffer<>(width, height, IntBuffer.wrap(marks), PixelFormat.getIntArgbPreInstance())));
    }

    private static int mark(int argb) {
        return Histogram.isWhite(argb) ? WHITE : Histogram.isBlack(argb) ? BLACK : CLEAR;
    }
}
