package dev.twister.gui.bodies;

import dev.twister.gui.bodies.TransformHandles.Handle;
import dev.twister.gui.edit.BodyTransform;
import dev.twister.gui.edit.BodyTransform.Mode;
import dev.twister.gui.picking.Projection;
import dev.twister.gui.picking.RotationRing;
import dev.twister.gui.picking.SurfacePoint;
import dev.twister.gui.picture.PictureView;
import dev.twister.gui.studio.Studio;
import dev.twister.scene.Scene;
import dev.twister.scene.Vector3;
import dev.twister.world.FrameInput;
import java.util.Locale;
import java.util.Objects;
import java.util.Optional;
import java.util.function.UnaryOperator;
import java.util.stream.Stream;
import javafx.beans.value.ObservableValue;
import javafx.geometry.Point2D;
import javafx.scene.Node;
import javafx.scene.input.MouseButton;
import javafx.scene.input.MouseEvent;

/** Rotates, scales and aims the selected bodies by the {@link TransformHandles}; Ctrl snaps. */
public final class HandleMouse {
    private static final double TURN = 360;

    private final PictureView view;
    private final Studio studio;
    private final TransformHandles handles;
    private Optional<Held> held = Optional.empty();
    private boolean swallowing;

    /** Around the axis, the way of the pointer so far; for the box 0. */
    private double degrees;

    private double lastDegrees;
    private String told = "";

    /** The handle, by the picture and the pointer's place in it at the start. */
    private record Held(Handle handle, BodyTransform bodies, FrameInput input, Point2D from) {}

    private HandleMouse(PictureView view, Studio studio, TransformHandles handles) {
        this.view = view;
        this.studio = studio;
        this.handles = handles;
    }

    /**
     * Adds event filters.
     *
     * @param around the picture, so that they run before all of the picture's own
     */
    public static void install(
            Node around,
            PictureView view,
            Studio studio,
            TransformHandles handles,
            ObservableValue<Boolean> windowFocused) {
        HandleMouse mouse = new HandleMouse(view, studio, handles);
        around.addEventFilter(MouseEvent.MOUSE_MOVED, event -> handles.point(mouse.handle(event)));
        around.addEventFilter(MouseEvent.MOUSE_PRESSED, mouse::pressed);
        around.addEventFilter(MouseEvent.MOUSE_DRAGGED, mouse::dragged);
        around.addEventFilter(MouseEvent.MOUSE_RELEASED, mouse::released);
        around.addEventFilter(MouseEvent.MOUSE_CLICKED, event -> {
            if (mouse.swallowing) {
                event.consume();
            }
        });
        windowFocused.subscribe(focused -> {
            if (!focused) {
                mouse.letGo();
            }
        });
        studio.selection().bodiesProperty().subscribe(_ -> mouse.letGo());
    }

    /** The handle under the pointer; none where something else lies over the picture. */
    private Optional<Handle> handle(MouseEvent event) {
        Point2D place = place(event);
        return isInPicture(event) ? handles.handleAt(place.getX(), place.getY()) : Optional.empty();
    }

    private boolean isInPicture(MouseEvent event) {
        return event.getTarget() instanceof Node target
                && Stream.iterate(target, Objects::nonNull, Node::getParent).anyMatch(view::equals);
    }

    private void pressed(MouseEvent event) {
        if (held.isPresent() && event.getButton() != MouseButton.PRIMARY) {
            event.consume();
            return;
        }
        // The release of a button over another window is not reported.
        letGo();
        Optional<Handle> handle = handle(event)
                .filter(_ -> !event.isConsumed())
                .filter(_ -> event.getButton() == MouseButton.PRIMARY && !event.isShiftDown() && !event.isAltDown());
        swallowing = handle.isPresent();
        handle.ifPresent(grabbed -> {
            FrameInput input = studio.pictureProperty().get().orElseThrow().input();
            Vector3 pivot = studio.bodies().extent(studio.selection().active()).middle();
            Point2D from = pixel(event, input);
            held = BodyTransform.of(studio.bodies().scene(), studio.selection().bodies())
                    .map(bodies -> new Held(grabbed, bodies.about(pivot), input, from));
            degrees = 0;
            lastDegrees = held.map(taken -> angle(taken, from)).orElse(0.0);
            view.requestFocus();
            event.consume();
        });
    }

    private void dragged(MouseEvent event) {
        held.ifPresent(taken -> {
            Point2D to = pixel(event, taken.input());
            event.consume();
            if (taken.handle().aims()) {
                aim(taken, to);
                return;
            }
            Mode mode = taken.handle().mode();
            double free = mode == Mode.ROTATE ? turn(taken, to) : factor(taken, to);
            double number = event.isControlDown() ? BodyTransform.snapped(mode, free) : free;
            UnaryOperator<Scene> change = taken.handle()
                    .axis()
                    .<UnaryOperator<Scene>>map(axis ->
                            scene -> taken.bodies().rotated(scene, axis.from(Vector3.ZERO, 1), number))
                    .orElse(scene -> taken.bodies().scaled(scene, number));
            studio.edit(mode.label().toLowerCase(Locale.ROOT), change);
            tell(taken.handle(), number);
        });
    }

    /** Lets the active light shine at what is under the pointer. */
    private void aim(Held taken, Point2D to) {
        int active = studio.selection().active();
        Vector3 target = SurfacePoint.aim(taken.input(), to.getX(), to.getY());
        studio.edit("aim", scene -> taken.bodies().aimed(scene, active, target));
        told = "Aims the light at what is under the pointer";
        studio.notice(told);
    }

    private void released(MouseEvent event) {
        if (held.isPresent()) {
            if (event.getButton() == MouseButton.PRIMARY) {
                letGo();
            }
            event.consume();
        }
    }

    private void letGo() {
        if (held.isPresent()) {
            held = Optional.empty();
            studio.endGesture();
            studio.retract(told);
        }
    }

    private void tell(Handle handle, double number) {
        told = handle.mode().label()
                + handle.axis().map(axis -> " about " + axis.label()).orElse("")
                + String.format(Locale.ROOT, " %.3g ", number) + handle.mode().unit() + "; Ctrl snaps";
        studio.notice(told);
    }

    /** More than a half turn, too. */
    private double turn(Held taken, Point2D to) {
        double now = angle(taken, to);
        double step = now - lastDegrees;
        degrees += step - TURN * Math.rint(step / TURN);
        lastDegrees = now;
        return degrees;
    }

    /** Where the pointer is around the axis; where it was if that is not known. */
    private double angle(Held taken, Point2D place) {
        return taken.handle()
                .axis()
                .map(axis -> RotationRing.degrees(
                                taken.input(), axis, taken.bodies().pivot(), place.getX(), place.getY())
                        .orElse(lastDegrees))
                .orElse(0.0);
    }

    private static double factor(Held taken, Point2D to) {
        double[] pixel = Projection.of(taken.input()).point(taken.bodies().pivot());
        Point2D middle = pixel.length == 0 ? Point2D.ZERO : new Point2D(pixel[0], pixel[1]);
        return to.distance(middle) / Math.max(1, taken.from().distance(middle));
    }

    private Point2D place(MouseEvent event) {
        return view.sceneToLocal(event.getSceneX(), event.getSceneY());
    }

    /** The pointer's place in the picture at the start; the present one may have more pixels. */
    private Point2D pixel(MouseEvent event, FrameInput input) {
        Point2D place = place(event);
        return view.place().toPicture(place.getX(), place.getY(), input);
    }
}
