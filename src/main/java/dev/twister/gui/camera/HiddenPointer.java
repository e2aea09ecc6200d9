package dev.twister.gui.camera;

import java.util.Optional;
import java.util.function.Consumer;
import javafx.geometry.Point2D;
import javafx.geometry.Rectangle2D;

/**
 * A hidden pointer that never reaches the edge of the screen: near an edge it is moved to the middle, and at the end
 * back to its start. If a system does not allow that, it stops at the edge.
 */
final class HiddenPointer {
    /** Distance from an edge at which it is moved, relative to the screen's shorter side. */
    private static final double NEAR = 0.1;

    private final Consumer<Point2D> hand;
    private final Point2D start;
    private final Rectangle2D screen;
    private Point2D last;

    /** The place that the pointer was moved to; events from before may still arrive. */
    private Optional<Point2D> sentTo = Optional.empty();

    private boolean sent;

    /**
     * A pointer at the start of a drag, in the screen's coordinates.
     *
     * @param hand moves the pointer
     */
    HiddenPointer(Consumer<Point2D> hand, Point2D start, Rectangle2D screen) {
        this.hand = hand;
        this.start = start;
        this.screen = screen;
        last = start;
    }

    /** The movement of the mouse since the last call, given the pointer's present place. */
    Point2D movedTo(Point2D place) {
        // It is moved far, so that an event near that place is from after the move.
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

    /** Moves the pointer back to the start of the drag, if it was moved. */
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
