package dev.twister.gui.picking;

import dev.twister.gui.edit.Axis;
import dev.twister.scene.Vector3;
import java.util.ArrayList;
import java.util.List;

/**
 * Where the handle is seen by which a body is moved along an axis, in pixels of the picture.
 *
 * @param middle the body's center; handles start outside of it
 * @param tip the end of the handle's arrow
 */
public record AxisHandle(Axis axis, Point middle, Point tip) {
    /** Of the length: the middle of a small body stays free. */
    private static final double GAP = 0.25;

    /** Of the length: an axis that points at the viewer is no handle. */
    private static final double LEAST = 0.3;

    /** A place in the picture, in pixels from its upper left corner. */
    public record Point(double x, double y) {
        double distance(Point other) {
            return Math.hypot(other.x - x, other.y - y);
        }

        /** To the nearest place of a line. */
        double distance(Point start, Point end) {
            double right = end.x - start.x;
            double down = end.y - start.y;
            double share = ((x - start.x) * right + (y - start.y) * down) / (right * right + down * down);
            return start.towards(end, Math.clamp(share, 0, 1)).distance(this);
        }

        private Point towards(Point other, double share) {
            return new Point(x + share * (other.x - x), y + share * (other.y - y));
        }
    }

    /**
     * The handles of a body that can be grabbed, each as long on the screen as its axis is across the view.
     *
     * @param middle of the body
     * @param length of one that lies across the view, in pixels of the picture
     */
    public static List<AxisHandle> of(Projection projection, Vector3 middle, double length) {
        List<AxisHandle> handles = new ArrayList<>();
        double[] seen = projection.point(middle);
        if (seen.length > 0) {
            Point center = new Point(seen[0], seen[1]);
            double meters = length / projection.pixelsPerMeter(middle);
            for (Axis axis : Axis.values()) {
                double[] end = projection.point(axis.from(middle, meters));
                if (end.length > 0) {
                    Point tip = new Point(end[0], end[1]);
                    if (center.distance(tip) >= LEAST * length) {
                        handles.add(new AxisHandle(axis, center, tip));
                    }
                }
            }
        }
        return handles;
    }

    /** Where the handle begins. */
    public Point start() {
        return middle.towards(tip, GAP);
    }

    /** From a place to the nearest one of the handle, in pixels. */
    public double distance(double x, double y) {
        return new Point(x, y).distance(start(), tip);
    }
}
