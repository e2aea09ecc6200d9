package dev.twister.gui.camera;

import dev.twister.gui.studio.Studio;
import dev.twister.scene.Camera;
import dev.twister.scene.property.CameraProperties;
import dev.twister.world.animation.CameraMotion;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Consumer;
import javafx.animation.PauseTransition;
import javafx.geometry.Point2D;
import javafx.geometry.Rectangle2D;
import javafx.scene.Cursor;
import javafx.scene.Node;
import javafx.scene.input.MouseButton;
import javafx.scene.input.MouseEvent;
import javafx.scene.input.ScrollEvent;
import javafx.scene.robot.Robot;
import javafx.stage.Screen;
import javafx.util.Duration;

/**
 * Turns the camera by dragging the picture, with the pointer hidden, and changes the field of view by the wheel. Events
 * that other handlers of the picture consume do not arrive here.
 */
public final class CameraMouse {
    /** From the upper to the lower border. */
    private static final double DEGREES_OF_A_PANORAMA = 180;

    private final Node picture;
    private final Studio studio;
    /** Turning the wheel after this time starts a new undo step. */
    private final PauseTransition turning = new PauseTransition(Duration.seconds(1));

    private Optional<HiddenPointer> pointer = Optional.empty();

    private CameraMouse(Node picture, Studio studio) {
        this.picture = picture;
        this.studio = studio;
        turning.setOnFinished(_ -> studio.endGesture());
    }

    public static void install(Node picture, Studio studio) {
        CameraMouse mouse = new CameraMouse(picture, studio);
        picture.addEventHandler(MouseEvent.MOUSE_PRESSED, mouse::pressed);
        picture.addEventHandler(MouseEvent.MOUSE_DRAGGED, mouse::dragged);
        picture.addEventHandler(MouseEvent.MOUSE_RELEASED, mouse::released);
        picture.addEventHandler(ScrollEvent.SCROLL, mouse::scrolled);
    }

    private void pressed(MouseEvent event) {
        picture.requestFocus();
        pointer = Optional.of(place(event))
                .filter(_ -> event.getButton() != MouseButton.MIDDLE)
                .map(start -> new HiddenPointer(to -> new Robot().mouseMove(to), start, screen(start)));
    }

    private static Point2D place(MouseEvent event) {
        return new Point2D(event.getScreenX(), event.getScreenY());
    }

    private static Rectangle2D screen(Point2D place) {
        return Screen.getScreensForRectangle(place.getX(), place.getY(), 1, 1).stream()
                .findFirst()
                .orElseGet(Screen::getPrimary)
                .getBounds();
    }

    private void dragged(MouseEvent event) {
        pointer.ifPresent(hidden -> {
            picture.setCursor(Cursor.NONE);
            // The middle of the picture moves about as far as the pointer.
            double height = picture.getLayoutBounds().getHeight();
            double side = Math.min(picture.getLayoutBounds().getWidth(), height);
            Camera seen = studio.scene().camera();
            double degrees = seen.projection() == Camera.Projection.PANORAMA
                    ? DEGREES_OF_A_PANORAMA / Math.max(1, height)
                    : seen.fieldOfViewDegrees() / Math.max(1, side);
            Point2D moved = hidden.movedTo(place(event)).multiply(degrees);
            studio.moveCamera(camera -> CameraMotion.look(camera, moved.getX(), moved.getY()));
        });
    }

    private void released(MouseEvent event) {
        pointer.ifPresent(HiddenPointer::release);
        pointer = Optional.empty();
        picture.setCursor(Cursor.DEFAULT);
    }

    private void scrolled(ScrollEvent event) {
        if (event.getDeltaY() != 0) {
            double notches = event.getDeltaY() / event.getMultiplierY();
            studio.edit(
                    (studio.scene().camera().projection() == Camera.Projection.ORTHOGRAPHIC
                                    ? CameraProperties.VIEW_HEIGHT
                                    : CameraProperties.FIELD_OF_VIEW)
                            .row()
                            .label()
                            .toLowerCase(Locale.ROOT),
                    scene -> scene.withCamera(CameraMotion.zoom(scene.camera(), notches)));
            turning.playFromStart();
        }
    }

    /**
     * A hidden pointer that never reaches the edge of the screen: near an edge it is moved to the middle, and at the
     * end back to its start. If a system does not allow that, it stops at the edge.
     */
    static final class HiddenPointer {
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
}
