package dev.twister.gui.picture;

import java.util.Optional;
import javafx.geometry.Point2D;
import javafx.scene.input.MouseButton;
import javafx.scene.input.MouseEvent;
import javafx.scene.input.ScrollEvent;

/**
 * The visible part of a picture and its magnification, relative to the size at which all of it fits.
 *
 * @param factor 1 if the picture fits the view, up to {@value #MOST}
 * @param centerX what is seen in the view's middle, as a share of the picture's width
 * @param centerY the same of its height
 */
public record PictureZoom(double factor, double centerX, double centerY) {
    public static final double MOST = 128;

    /** By a notch of the wheel, or a key. */
    public static final double STEP = 1.25;

    /** All of the picture. */
    public static final PictureZoom FIT = new PictureZoom(1, 0.5, 0.5);

    /** So near to 1, it is meant to fit. */
    private static final double LEAST = 1.01;

    /**
     * One axis of the view: the fitted picture's length along it, and the view's.
     *
     * @param fitted above 0
     * @param view above 0
     */
    public record Side(double fitted, double view) {
        private double start(double factor, double center) {
            double length = fitted * factor;
            double start = view / 2 - center * length;
            return length <= view ? (view - length) / 2 : Math.clamp(start, view - length, 0);
        }

        /** The center at which the share lies at that place of the view. */
        private double center(double factor, double share, double place) {
            return share + (view / 2 - place) / (fitted * factor);
        }

        private double share(double factor, double center, double place) {
            return (place - start(factor, center)) / (fitted * factor);
        }
    }

    /**
     * Lets Ctrl with the wheel magnify a picture, and Ctrl with the mouse move what is magnified. Adds event filters,
     * which run before the picture's other handlers.
     */
    public static void install(PictureView view) {
        Mouse mouse = new Mouse(view);
        view.addEventFilter(ScrollEvent.SCROLL, mouse::scrolled);
        view.addEventFilter(MouseEvent.MOUSE_PRESSED, mouse::pressed);
        view.addEventFilter(MouseEvent.MOUSE_DRAGGED, mouse::dragged);
        view.addEventFilter(MouseEvent.MOUSE_RELEASED, mouse::released);
    }

    public boolean isFit() {
        return factor == 1;
    }

    /** Where the picture begins in the view; it leaves no room that it can fill. */
    public double left(Side across) {
        return across.start(factor, centerX);
    }

    public double top(Side down) {
        return down.start(factor, centerY);
    }

    /** So many times larger or smaller; what lies at a place of the view stays there, as far as it can. */
    public PictureZoom times(double change, Side across, double x, Side down, double y) {
        double zoomed = Math.clamp(factor * change, 1, MOST);
        if (zoomed < LEAST) {
            return FIT;
        }
        return new PictureZoom(
                zoomed,
                across.center(zoomed, across.share(factor, centerX, x), x),
                down.center(zoomed, down.share(factor, centerY, y), y));
    }

    /** The picture moved with the pointer, up to its border. */
    public PictureZoom moved(Side across, double right, Side down, double lower) {
        return new PictureZoom(
                factor,
                across.share(factor, centerX, across.view() / 2 - right),
                down.share(factor, centerY, down.view() / 2 - lower));
    }

    /** Magnifies the picture with Ctrl and the wheel, and moves what is magnified with Ctrl and the mouse. */
    private static final class Mouse {
        private final PictureView view;
        private Optional<Point2D> held = Optional.empty();

        private Mouse(PictureView view) {
            this.view = view;
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
}
