package dev.twister.gui;

import dev.twister.world.CameraMotion;
import javafx.scene.Cursor;
import javafx.scene.Node;
import javafx.scene.input.MouseButton;
import javafx.scene.input.MouseEvent;
import javafx.scene.input.ScrollEvent;

/**
 * Turns the camera by dragging over the picture, with the pointer hidden, and changes the field of view by the wheel. What
 * another handler of the picture's consumes (the drag of a body, say) does not come here.
 */
final class CameraMouse {
    private final Node picture;
    private final Studio studio;
    private double lastX;
    private double lastY;
    private boolean looking;

    private CameraMouse(Node picture, Studio studio) {
        this.picture = picture;
        this.studio = studio;
    }

    static void install(Node picture, Studio studio) {
        CameraMouse mouse = new CameraMouse(picture, studio);
        picture.addEventHandler(MouseEvent.MOUSE_PRESSED, mouse::pressed);
        picture.addEventHandler(MouseEvent.MOUSE_DRAGGED, mouse::dragged);
        picture.addEventHandler(MouseEvent.MOUSE_RELEASED, mouse::released);
        picture.addEventHandler(ScrollEvent.SCROLL, mouse::scrolled);
    }

    private void pressed(MouseEvent event) {
        picture.requestFocus();
        looking = event.getButton() != MouseButton.MIDDLE;
        lastX = event.getX();
        lastY = event.getY();
    }

    private void dragged(MouseEvent event) {
        if (looking) {
            picture.setCursor(Cursor.NONE);
            // What is under the pointer in the middle of the picture moves about as far as the pointer.
            double side = Math.min(
                    picture.getLayoutBounds().getWidth(),
                    picture.getLayoutBounds().getHeight());
            double degrees = studio.scene().camera().fieldOfViewDegrees() / Math.max(1, side);
            double right = (event.getX() - lastX) * degrees;
            double down = (event.getY() - lastY) * degrees;
            studio.moveCamera(camera -> CameraMotion.look(camera, right, down));
            lastX = event.getX();
            lastY = event.getY();
        }
    }

    private void released(MouseEvent event) {
        looking = false;
        picture.setCursor(Cursor.DEFAULT);
    }

    private void scrolled(ScrollEvent event) {
        if (event.getDeltaY() != 0) {
            double notches = event.getDeltaY() / event.getMultiplierY();
            studio.moveCamera(camera -> CameraMotion.zoom(camera, notches));
        }
    }
}
