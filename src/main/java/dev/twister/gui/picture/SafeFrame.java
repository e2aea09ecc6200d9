package dev.twister.gui.picture;

import dev.twister.gui.studio.Studio;
import dev.twister.scene.Camera;
import javafx.beans.property.BooleanProperty;
import javafx.beans.property.SimpleBooleanProperty;
import javafx.geometry.Bounds;
import javafx.scene.layout.Pane;
import javafx.scene.shape.Rectangle;

/** Outlines what a picture of the scene's own width and height shows, which may be more than the view has. */
public final class SafeFrame extends Pane {
    private final PictureView picture;
    private final Studio studio;
    private final BooleanProperty shown = new SimpleBooleanProperty(false);
    private final Rectangle outline = new Rectangle();

    public SafeFrame(PictureView picture, Studio studio) {
        this.picture = picture;
        this.studio = studio;
        setId("safe-frame");
        setMouseTransparent(true);
        outline.getStyleClass().add("safe-frame");
        outline.setManaged(false);
        getChildren().add(outline);
        visibleProperty().bind(shown);
        shown.subscribe(_ -> place());
        studio.sceneProperty().subscribe(_ -> place());
        picture.image().boundsInParentProperty().subscribe(_ -> place());
    }

    public BooleanProperty shownProperty() {
        return shown;
    }

    private void place() {
        if (shown.get()) {
            Bounds view = picture.image().getBoundsInParent();
            FrameOutline frame = FrameOutline.of(
                    view.getWidth(),
                    view.getHeight(),
                    studio.scene().rendering().width(),
                    studio.scene().rendering().height(),
                    studio.scene().camera().projection());
            outline.setX(view.getCenterX() - frame.width() / 2);
            outline.setY(view.getCenterY() - frame.height() / 2);
            outline.setWidth(frame.width());
            outline.setHeight(frame.height());
        }
    }

    /**
     * The size, in a view, of what a picture of other proportions shows: the field of view is over the shorter side, an
     * orthographic camera's height over the height, and a panorama always shows all.
     */
    public record FrameOutline(double width, double height) {
        private FrameOutline times(double factor) {
            return new FrameOutline(factor * width, factor * height);
        }

        /** The outline of an output in a view of the same camera. */
        public static FrameOutline of(
                double viewWidth,
                double viewHeight,
                double outputWidth,
                double outputHeight,
                Camera.Projection projection) {
            FrameOutline output = new FrameOutline(outputWidth, outputHeight);
            return switch (projection) {
                case PERSPECTIVE, FISHEYE ->
                    output.times(Math.min(viewWidth, viewHeight) / Math.min(outputWidth, outputHeight));
                case ORTHOGRAPHIC -> output.times(viewHeight / outputHeight);
                case PANORAMA -> new FrameOutline(viewWidth, viewHeight);
            };
        }
    }
}
