package dev.twister.gui.picture;

import dev.twister.world.FrameInput;
import javafx.geometry.Bounds;
import javafx.geometry.Point2D;

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
                bounds.getMinX() + x * bounds.getWidth() / width, bounds.getMinY() + y * bounds.getHeight() / height);
    }

    public boolean contains(double x, double y) {
        return bounds.contains(x, y);
    }
}
