package dev.twister.gui.camera;

import java.util.Optional;
import java.util.function.Consumer;
import javafx.geometry.Point2D;
import javafx.geometry.Rectangle2D;

/**
 * A pointer that is not seen and never comes to the end of the screen: near an edge it is put in the screen's middle,
 * and at the end back where it was. Where a system does not let it be put elsewhere, it stops at the edge.
 */
final class HiddenPointer {
    /** So near an edge, as a share of the screen's shorter side. */
    private static final double NEAR = 0.1;

    private final Consumer<Point2D> hand;
    private final Point2D start;
    private final Rectangle2D screen;
    private Point2D last;

    /** Where the pointer was sent; events from before it went there may still come. */
    private Optional<Point2D> sentTo = Optional.empty();

    private boolean sent;

    /**
     * A pointer at the start of a drag, all places in the screen's coordinates.
     *
     * @param hand puts it elsewhere
     */
    HiddenPointer(Consumer<Point2D> hand, Point2D start, Rectangle2D screen) {
        this.hand = hand;
        this.start = start;
        this.screen = screen;
        last = start;
    }

    /** How far the hand has moved since it was last asked, now that the pointer is there. */
    Point2D movedTo(Point2D place) {
        // It is sent far away, so that what is nearer to there was moved from there.
        if (sentTo.filter(middle -> place.distance(middle) < place.distance(last))
                .isPresent()) {
            last = sentTo.get();
            sentTo = Optional.empty();
        }
        Point2D moved = place.subtract(last);
        last = place;
        if (sentTo.isEmpty() && isNearAnEdge(place)) {
            send(new Point2D(
                    Math.rint(screen.getMinX() + screen.getWidth() / 2),
                    Math.rint(screen.getMinY() + screen.getHeight() / 2)));
        }
        return moved;
    }

    /** Puts it back where the drag began, where it was sent away from there. */
    void release() {
        if (sent) {
            hand.accept(start);
        }
    }

    private void send(Point2D middle) {
        sent = true;
        sentTo = Optional.of(middle);
        hand.accept(middle);
    }

    private boolean isNearAnEdge(Point2D place) {
        double near = NEAR * Math.min(screen.getWidth(), screen.getHeight());
        return place.getX() < screen.getMinX() + near
                || place.getY() < screen.getMinY() + near
                || place.getX() >= screen.getMaxX() - near
                || place.getY() >= screen.getMaxY() - near;
    }
}
