package dev.twister.gui.picture;

import java.util.Optional;
import javafx.geometry.Point2D;
import javafx.scene.input.MouseButton;
import javafx.scene.input.MouseEvent;
import javafx.scene.input.ScrollEvent;

/** Magnifies the picture with Ctrl and the wheel, and moves what is magnified with Ctrl and the mouse. */
public final class ZoomMouse {
    public static final double STEP = 1.25;

    private final PictureView view;
    private Optional<Point2D> held = Optional.empty();

    private ZoomMouse(PictureView view) {
        this.view = view;
    }

    /** Filters, so that this comes before what else listens to the picture. */
    public static void install(PictureView view) {
        ZoomMouse mouse = new ZoomMouse(view);
        view.addEventFilter(ScrollEvent.SCROLL, mouse::scrolled);
        view.addEventFilter(MouseEvent.MOUSE_PRESSED, mouse::pressed);
        view.addEventFilter(MouseEvent.MOUSE_DRAGGED, mouse::dragged);
        view.addEventFilter(MouseEvent.MOUSE_RELEASED, mouse::released);
    }

    private void scrolled(ScrollEvent event) {
        if (event.isShortcutDown()) {
            view.zoom(Math.pow(STEP, event.getDeltaY() / event.getMultiplierY()), event.getX(), event.getY());
            event.consume();
        }
    }

    private void pressed(MouseEvent event) {
        held = Optional.of(new Point2D(event.getX(), event.getY()))
                .filter(_ -> event.getButton() == MouseButton.PRIMARY && event.isShortcutDown() && view.isZoomed());
        if (held.isPresent()) {
            event.consume();
        }
    }

    private void dragged(MouseEvent event) {
        held.ifPresent(from -> {
            view.moveZoomed(event.getX() - from.getX(), event.getY() - from.getY());
            held = Optional.of(new Point2D(event.getX(), event.getY()));
            event.consume();
        });
    }

    private void released(MouseEvent event) {
        if (held.isPresent()) {
            held = Optional.empty();
            event.consume();
        }
    }
}
