package dev.twister.gui.camera;

import dev.twister.gui.edit.BodyExtent;
import dev.twister.gui.picking.PointerRay;
import dev.twister.gui.picture.PictureView;
import dev.twister.gui.studio.Orbit;
import dev.twister.gui.studio.Studio;
import dev.twister.scene.Camera;
import dev.twister.scene.Vector3;
import java.util.Optional;
import javafx.geometry.Point2D;
import javafx.scene.input.MouseButton;
import javafx.scene.input.MouseEvent;
import javafx.scene.input.ScrollEvent;

/**
 * Moves the camera about the selected bodies, or about what is in the picture's middle: the middle button orbits, with
 * Shift it pans, and the wheel with Alt or Shift moves nearer.
 */
public final class OrbitMouse {
    private static final double DEGREES_A_PIXEL = 0.3;

    /** A notch of the wheel leaves this share of the distance. */
    private static final double NOTCH = 0.9;

    /** Distance of the pivot if the middle shows nothing. */
    private static final double USUAL_METERS = 10;

    /** Farther bodies are no pivot. */
    private static final double FAR_METERS = 1000;

    private final PictureView view;
    private final Studio studio;
    private Optional<Drag> drag = Optional.empty();

    /** A drag and its pivot. */
    private record Drag(Point2D pointer, Vector3 pivot) {}

    private OrbitMouse(PictureView view, Studio studio) {
        this.view = view;
        this.studio = studio;
    }

    /** Adds event filters, which run before the picture's other handlers. */
    public static void install(PictureView view, Studio studio) {
        OrbitMouse mouse = new OrbitMouse(view, studio);
        view.addEventFilter(MouseEvent.MOUSE_PRESSED, mouse::pressed);
        view.addEventFilter(MouseEvent.MOUSE_DRAGGED, mouse::dragged);
        view.addEventFilter(MouseEvent.MOUSE_RELEASED, _ -> mouse.drag = Optional.empty());
        view.addEventFilter(ScrollEvent.SCROLL, mouse::scrolled);
    }

    private void pressed(MouseEvent event) {
        drag = Optional.of(new Point2D(event.getX(), event.getY()))
                .filter(_ -> event.getButton() == MouseButton.MIDDLE)
                .map(pointer -> new Drag(pointer, pivot()));
        if (drag.isPresent()) {
            view.requestFocus();
            event.consume();
        }
    }

    private void dragged(MouseEvent event) {
        drag.ifPresent(held -> {
            double right = event.getX() - held.pointer().getX();
            double down = event.getY() - held.pointer().getY();
            if (event.isShiftDown()) {
                double meters = metersAPixel(held.pivot());
                studio.moveCamera(camera -> Orbit.panned(camera, -meters * right, meters * down));
            } else {
                studio.moveCamera(
                        camera -> Orbit.turned(camera, held.pivot(), DEGREES_A_PIXEL * right, DEGREES_A_PIXEL * down));
            }
            drag = Optional.of(new Drag(new Point2D(event.getX(), event.getY()), held.pivot()));
            event.consume();
        });
    }

    private void scrolled(ScrollEvent event) {
        if ((event.isAltDown() || event.isShiftDown()) && !event.isShortcutDown()) {
            // With Shift, systems report the wheel as horizontal.
            double turned = event.getDeltaY() == 0
                    ? event.getDeltaX() / event.getMultiplierX()
                    : event.getDeltaY() / event.getMultiplierY();
            Vector3 pivot = pivot();
            studio.moveCamera(camera -> Orbit.dollied(camera, pivot, Math.pow(NOTCH, turned)));
            event.consume();
        }
    }

    private Vector3 pivot() {
        return studio.bodies()
                .extent(studio.selection().bodies())
                .map(BodyExtent::middle)
                .orElseGet(this::middle);
    }

    private Vector3 middle() {
        Camera camera = studio.scene().camera();
        double meters = studio.pictureProperty()
                .get()
                .map(picture -> PointerRay.focusDistance(
                        picture.input(),
                        picture.frame().width() / 2.0,
                        picture.frame().height() / 2.0))
                .filter(found -> found < FAR_METERS)
                .orElse(USUAL_METERS);
        return Orbit.ahead(camera, meters);
    }

    /** The size of a pixel of the view at the pivot's distance. */
    private double metersAPixel(Vector3 pivot) {
        Camera camera = studio.scene().camera();
        double distance = pivot.minus(camera.position()).length();
        double side = Math.max(1, Math.min(view.getWidth(), view.getHeight()));
        return switch (camera.projection()) {
            case PERSPECTIVE -> 2 * distance * Math.tan(Math.toRadians(camera.fieldOfViewDegrees()) / 2) / side;
            case ORTHOGRAPHIC -> camera.viewHeight() / Math.max(1, view.getHeight());
            case PANORAMA -> Math.PI * distance / Math.max(1, view.getHeight());
            case FISHEYE -> distance * Math.toRadians(camera.fieldOfViewDegrees()) / side;
        };
    }
}
