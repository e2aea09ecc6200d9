package dev.twister.gui.camera;

import dev.twister.gui.studio.Studio;
import dev.twister.scene.property.CameraProperties;
import dev.twister.world.animation.CameraMotion;
import java.util.Locale;
import java.util.Optional;
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
            double side = Math.min(
                    picture.getLayoutBounds().getWidth(),
                    picture.getLayoutBounds().getHeight());
            double degrees = studio.scene().camera().fieldOfViewDegrees() / Math.max(1, side);
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
                    CameraProperties.FIELD_OF_VIEW.row().label().toLowerCase(Locale.ROOT),
                    scene -> scene.withCamera(CameraMotion.zoom(scene.camera(), notches)));
            turning.playFromStart();
        }
    }
}
