package dev.twister.gui.picture;

import dev.twister.gui.drawing.DrawnPicture;
import dev.twister.gui.picture.PictureZoom.Side;
import dev.twister.gui.studio.Studio;
import dev.twister.image.Frame;
import dev.twister.world.FrameInput;
import java.nio.IntBuffer;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import javafx.geometry.Bounds;
import javafx.geometry.Point2D;
import javafx.scene.AccessibleRole;
import javafx.scene.image.Image;
import javafx.scene.image.ImageView;
import javafx.scene.image.PixelBuffer;
import javafx.scene.image.PixelFormat;
import javafx.scene.image.WritableImage;
import javafx.scene.layout.Pane;
import javafx.scene.layout.Region;
import javafx.scene.shape.Rectangle;
import javafx.stage.Window;

/**
 * Shows the newest picture, as large as fits, without copying it: each of the frames that go round has an image that
 * looks at the same pixels.
 */
public final class PictureView extends Pane {
    /** Nearer than that, pixels are squares. */
    private static final double PIXELS_SEEN_FROM = 2;

    private final ImageView view = new ImageView();
    private final Map<Frame, ShownFrame> frames = new HashMap<>();
    private final Studio studio;
    private Optional<Frame> onScreen = Optional.empty();
    private final Rectangle clip = new Rectangle();
    private PictureZoom zoom = PictureZoom.FIT;
    private Side across = new Side(1, 1);
    private Side down = new Side(1, 1);
    private double laidOutScale;

    /** A frame as JavaFX sees it. */
    private record ShownFrame(PixelBuffer<IntBuffer> pixels, WritableImage image) {
        static ShownFrame of(Frame frame) {
            PixelBuffer<IntBuffer> pixels = new PixelBuffer<>(
                    frame.width(), frame.height(), frame.pixels(), PixelFormat.getIntArgbPreInstance());
            return new ShownFrame(pixels, new WritableImage(pixels));
        }

        /** Whether the frame's pixels are where they were: an engine for a device has them outside the heap. */
        @SuppressWarnings("ReferenceEquality") // equal buffers may be elsewhere
        boolean showsPixelsOf(Frame frame) {
            return pixels.getBuffer() == frame.pixels();
        }
    }

    public PictureView(Studio studio) {
        this.studio = studio;
        getStyleClass().add("picture");
        setFocusTraversable(true);
        setAccessibleRole(AccessibleRole.IMAGE_VIEW);
        setAccessibleText("Picture of the scene");
        view.setManaged(false);
        getChildren().add(view);
        clip.widthProperty().bind(widthProperty());
        clip.heightProperty().bind(heightProperty());
        studio.pictureProperty().subscribe(picture -> picture.ifPresent(this::show));
    }

    /** The image that is shown. */
    public ImageView image() {
        return view;
    }

    /** Where the picture lies in this view. */
    public PicturePlace place() {
        return new PicturePlace(view.getBoundsInParent(), (int) view.getImage().getWidth(), (int)
                view.getImage().getHeight());
    }

    /** Lays something over all of the view. */
    public void addOverlay(Region overlay) {
        overlay.setManaged(false);
        getChildren().add(overlay);
        layoutBoundsProperty().subscribe(bounds -> overlay.resize(bounds.getWidth(), bounds.getHeight()));
    }

    /** Asks for a picture of as many pixels as the screen has here. */
    public void tellSize() {
        Window window = getScene().getWindow();
        if (window.getOutputScaleX() != laidOutScale) {
            requestLayout();
        }
        studio.setViewSize(getWidth() * window.getOutputScaleX(), getHeight() * window.getOutputScaleY());
    }

    @Override
    protected void layoutChildren() {
        Image image = view.getImage();
        if (image == null) {
            return;
        }
        Window window = getScene().getWindow();
        laidOutScale = window.getOutputScaleX();
        double width = image.getWidth() / window.getOutputScaleX();
        double height = image.getHeight() / window.getOutputScaleY();
        double fit = Math.min(getWidth() / width, getHeight() / height);
        // Pixel for pixel, JavaFX without a graphics card takes a sixth of the time that scaling takes it.
        if (Math.abs(fit - 1) * Math.max(image.getWidth(), image.getHeight()) >= 1) {
            width *= fit;
            height *= fit;
        }
        across = new Side(width, getWidth());
        down = new Side(height, getHeight());
        view.setFitWidth(width * zoom.factor());
        view.setFitHeight(height * zoom.factor());
        view.setSmooth(zoom.factor() < PIXELS_SEEN_FROM);
        view.relocate(snapPositionX(zoom.left(across)), snapPositionY(zoom.top(down)));
    }

    /** Whether only a part of the picture is seen. */
    boolean isZoomed() {
        return !zoom.isFit();
    }

    /** Magnifies by a factor; what is at that place of the view stays there. */
    void zoom(double change, double x, double y) {
        show(zoom.times(change, across, x, down, y));
    }

    /** The same about the view's middle. */
    public void zoom(double change) {
        zoom(change, getWidth() / 2, getHeight() / 2);
    }

    public void zoomToFit() {
        show(PictureZoom.FIT);
    }

    /** Moves what is magnified. */
    void moveZoomed(double right, double lower) {
        show(zoom.moved(across, right, down, lower));
    }

    private void show(PictureZoom newZoom) {
        zoom = newZoom;
        setClip(zoom.isFit() ? null : clip);
        requestLayout();
    }

    private void show(DrawnPicture picture) {
        Frame frame = picture.frame();
        if (onScreen.equals(Optional.of(frame))) {
            // The exchange gives a repetition of the picture that is shown in its frame. To hand it to JavaFX would
            // cost an engine on all cores a tenth of its frames.
            return;
        }
        onScreen = Optional.of(frame);
        // Frames of another size do not come back.
        frames.keySet().removeIf(old -> old.width() != frame.width() || old.height() != frame.height());
        ShownFrame shown = frames.compute(
                frame, (_, known) -> known != null && known.showsPixelsOf(frame) ? known : ShownFrame.of(frame));
        shown.pixels().updateBuffer(_ -> null);
        Image before = view.getImage();
        view.setImage(shown.image());
        if (before == null || before.getWidth() != frame.width() || before.getHeight() != frame.height()) {
            requestLayout();
        }
    }

    /**
     * Where a picture lies in the view that it was scaled to fit.
     *
     * @param bounds of the scaled picture, in the view's units
     * @param width of the picture, in pixels
     * @param height of the picture, in pixels
     */
    public record PicturePlace(Bounds bounds, int width, int height) {
        /** From the view's units to pixels of the picture. */
        public Point2D toPicture(double x, double y) {
            return new Point2D(
                    (x - bounds.getMinX()) * width / bounds.getWidth(),
                    (y - bounds.getMinY()) * height / bounds.getHeight());
        }

        /** From the view's units to pixels of the same picture in another size. */
        public Point2D toPicture(double x, double y, FrameInput other) {
            Point2D place = toPicture(x, y);
            return new Point2D(place.getX() * other.width() / width, place.getY() * other.height() / height);
        }

        /** From a length in the view's units to one in pixels of the picture. */
        public double toPicture(double length) {
            return length * width / bounds.getWidth();
        }

        /** From pixels of the picture to the view's units. */
        public Point2D toView(double x, double y) {
            return new Point2D(
                    bounds.getMinX() + x * bounds.getWidth() / width,
                    bounds.getMinY() + y * bounds.getHeight() / height);
        }

        public boolean contains(double x, double y) {
            return bounds.contains(x, y);
        }
    }
}
