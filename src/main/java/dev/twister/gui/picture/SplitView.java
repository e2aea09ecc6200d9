package dev.twister.gui.picture;

import dev.twister.gui.drawing.DrawnPicture;
import dev.twister.gui.drawing.StagesAndViews;
import dev.twister.gui.picture.Comparison.Mode;
import dev.twister.gui.picture.Comparison.Other;
import dev.twister.gui.studio.Studio;
import java.util.Locale;
import java.util.Optional;
import javafx.geometry.Bounds;
import javafx.scene.Cursor;
import javafx.scene.control.Label;
import javafx.scene.image.ImageView;
import javafx.scene.image.PixelFormat;
import javafx.scene.image.WritableImage;
import javafx.scene.input.MouseEvent;
import javafx.scene.layout.Pane;
import javafx.scene.layout.Region;
import javafx.scene.shape.Rectangle;

/**
 * The second picture of a comparison to the right of a divider that can be moved, or the difference of both pictures.
 */
public final class SplitView extends Pane {
    private static final double GRIP = 11;
    private static final double MARGIN = 8;

    private final PictureView view;
    private final Studio studio;
    private final Comparison comparison;
    private final ImageView image = new ImageView();
    private final Pane imagePane = new Pane(image);
    private final Rectangle clip = new Rectangle();
    private final Region divider = new Region();
    private final Label left = label("split-left");
    private final Label right = label("split-right");
    private final Label difference = label("difference");
    private double share = 0.5;

    public SplitView(PictureView view, Studio studio, Comparison comparison) {
        this.view = view;
        this.studio = studio;
        this.comparison = comparison;
        setPickOnBounds(false);
        // Text that does not fit makes no room for itself.
        setMinSize(0, 0);
        imagePane.setMouseTransparent(true);
        imagePane.setClip(clip);
        image.setManaged(false);
        view.addOverlay(imagePane);
        divider.setId("divider");
        divider.getStyleClass().add("divider");
        divider.setCursor(Cursor.H_RESIZE);
        divider.setManaged(false);
        divider.setOnMouseDragged(this::dragged);
        getChildren().addAll(left, right, difference, divider);
        comparison.modeProperty().subscribe(_ -> refresh());
        comparison.otherProperty().subscribe(_ -> refresh());
        comparison.differenceProperty().subscribe(_ -> refresh());
        studio.pictureProperty().subscribe(_ -> label());
        view.image().boundsInParentProperty().subscribe(_ -> requestLayout());
    }

    private static Label label(String id) {
        Label label = new Label();
        label.setId(id);
        label.getStyleClass().add("split-label");
        label.setMouseTransparent(true);
        return label;
    }

    private void dragged(MouseEvent event) {
        share = Math.clamp((event.getX() + divider.getLayoutX()) / Math.max(1, getWidth()), 0, 1);
        requestLayout();
        event.consume();
    }

    private void refresh() {
        boolean on = comparison.isOn();
        setVisible(on);
        imagePane.setVisible(on);
        divider.setVisible(comparison.modeProperty().get() == Mode.SPLIT);
        comparison.otherProperty().get().ifPresentOrElse(this::show, () -> image.setImage(null));
        difference.setText(comparison
                .differenceProperty()
                .get()
                .map(SplitView::text)
                .orElse("The second picture is being rendered…"));
        label();
        requestLayout();
    }

    private void show(Other other) {
        int width = other.picture().frame().width();
        int height = other.picture().frame().height();
        int[] argb = pixels(other);
        if (!(image.getImage() instanceof WritableImage old) || old.getWidth() != width || old.getHeight() != height) {
            image.setImage(new WritableImage(width, height));
        }
        ((WritableImage) image.getImage())
                .getPixelWriter()
                .setPixels(0, 0, width, height, PixelFormat.getIntArgbInstance(), argb, 0, width);
    }

    private int[] pixels(Other other) {
        Optional<int[]> first = studio.pictureProperty()
                .get()
                .map(picture -> picture.frame().argb())
                .filter(argb -> argb.length == other.argb().length);
        return comparison.modeProperty().get() == Mode.DIFFERENCE && first.isPresent()
                ? PictureDifference.picture(first.get(), other.argb())
                : other.argb();
    }

    private void label() {
        boolean split = comparison.modeProperty().get() == Mode.SPLIT;
        left.setText(split ? studio.pictureProperty().get().map(SplitView::name).orElse("") : "");
        right.setText(
                split
                        ? comparison
                                .otherProperty()
                                .get()
                                .map(other -> name(other.picture()))
                                .orElse("")
                        : "");
    }

    /** Engine, what is shown, samples: how one tells the halves apart. */
    private static String name(DrawnPicture picture) {
        return picture.engine() + " · "
                + StagesAndViews.label(picture.request().shown()) + " · " + picture.samples()
                + (picture.samples() == 1 ? " sample" : " samples");
    }

    private static String text(PictureDifference difference) {
        if (difference.largest() == 0) {
            return "No difference";
        }
        return String.format(
                Locale.ROOT,
                "Largest difference: %d of 255 at x %d, y %d. %,d of %,d pixels differ by more than 1",
                difference.largest(),
                difference.x(),
                difference.y(),
                difference.differing(),
                difference.pixels());
    }

    @Override
    protected void layoutChildren() {
        Bounds bounds = view.image().getBoundsInParent();
        image.setFitWidth(bounds.getWidth());
        image.setFitHeight(bounds.getHeight());
        image.setSmooth(view.image().isSmooth());
        image.relocate(bounds.getMinX(), bounds.getMinY());
        double from = comparison.modeProperty().get() == Mode.SPLIT ? Math.round(share * getWidth()) : 0;
        clip.setX(from);
        clip.setWidth(Math.max(0, getWidth() - from));
        clip.setHeight(getHeight());
        divider.resizeRelocate(from - GRIP / 2, 0, GRIP, getHeight());
        double bottom = getHeight() - MARGIN;
        put(difference, (getWidth() - difference.prefWidth(-1)) / 2, bottom);
        double above = bottom - difference.prefHeight(-1) - MARGIN;
        put(left, from - MARGIN - left.prefWidth(-1), above);
        put(right, from + MARGIN, above);
    }

    /** A label with its lower left corner at a point; none for an empty text. */
    private static void put(Label label, double x, double bottom) {
        label.setVisible(!label.getText().isEmpty());
        double height = label.prefHeight(-1);
        label.resizeRelocate(x, bottom - height, label.prefWidth(-1), height);
    }
}
