package dev.twister.gui.bodies;

import dev.twister.gui.camera.CameraMouse;
import dev.twister.gui.drawing.DrawnPicture;
import dev.twister.gui.edit.Axis;
import dev.twister.gui.edit.BodyEdits;
import dev.twister.gui.edit.BodyNumber;
import dev.twister.gui.edit.BodyTitles;
import dev.twister.gui.edit.DraggedBodies;
import dev.twister.gui.edit.TagEdits;
import dev.twister.gui.picking.BodyDrag;
import dev.twister.gui.picking.PointerRay;
import dev.twister.gui.picture.PathPick;
import dev.twister.gui.picture.PictureView;
import dev.twister.gui.property.PropertyNumbers;
import dev.twister.gui.studio.StatusText;
import dev.twister.gui.studio.Studio;
import dev.twister.scene.Vector3;
import dev.twister.world.FrameInput;
import java.util.Optional;
import java.util.stream.Stream;
import javafx.beans.property.ReadOnlyObjectProperty;
import javafx.beans.property.ReadOnlyObjectWrapper;
import javafx.beans.value.ObservableValue;
import javafx.geometry.Point2D;
import javafx.scene.Cursor;
import javafx.scene.input.KeyCode;
import javafx.scene.input.KeyEvent;
import javafx.scene.input.MouseButton;
import javafx.scene.input.MouseEvent;

/**
 * Selects the clicked body or focuses on it, and drags the selected bodies by one of them or by a handle. Drags that
 * begin elsewhere are left to {@link CameraMouse}.
 */
public final class BodyMouse {
    private final PictureView view;
    private final Studio studio;
    private final PathPick paths;
    private final AxisHandles handles;
    private Optional<Point2D> pointer = Optional.empty();
    private Optional<Held> held = Optional.empty();
    private final ReadOnlyObjectWrapper<Optional<Axis>> axis = new ReadOnlyObjectWrapper<>(Optional.empty());

    /** The drag of the active body and of the bodies that move with it. */
    private record Held(BodyDrag drag, DraggedBodies bodies, Optional<SurfaceRest> rest) {}

    /** The pointer of the drag, in pixels of the view. */
    private Point2D draggedTo = Point2D.ZERO;

    private boolean snapping;

    /** Whether the active body is put on the surface under the pointer. */
    private boolean resting;

    /** The last notice about the axis; may be empty. */
    private String told = "";

    private BodyMouse(PictureView view, Studio studio, PathPick paths, AxisHandles handles) {
        this.paths = paths;
        this.handles = handles;
        this.view = view;
        this.studio = studio;
    }

    /** Adds event filters, which run before the picture's other handlers. */
    public static BodyMouse install(
            PictureView view,
            Studio studio,
            PathPick paths,
            AxisHandles handles,
            ObservableValue<Boolean> windowFocused) {
        BodyMouse mouse = new BodyMouse(view, studio, paths, handles);
        view.addEventFilter(MouseEvent.MOUSE_PRESSED, mouse::pressed);
        view.addEventFilter(MouseEvent.MOUSE_DRAGGED, mouse::dragged);
        view.addEventFilter(MouseEvent.MOUSE_RELEASED, mouse::released);
        view.addEventFilter(MouseEvent.MOUSE_CLICKED, mouse::clicked);
        view.addEventFilter(MouseEvent.MOUSE_MOVED, mouse::moved);
        windowFocused.subscribe(focused -> {
            if (!focused) {
                mouse.letGo();
            }
        });
        // The selection was changed by a key during a drag: the pointer does not hold the new body.
        studio.selection().bodiesProperty().subscribe(_ -> mouse.letGo());
        view.addEventFilter(MouseEvent.MOUSE_EXITED, _ -> {
            mouse.pointer = Optional.empty();
            handles.point(Optional.empty());
        });
        view.addEventFilter(KeyEvent.KEY_PRESSED, event -> mouse.keyPressed(event.getCode(), event));
        view.addEventFilter(KeyEvent.KEY_RELEASED, event -> {
            if (event.getCode() == KeyCode.CONTROL) {
                mouse.snap(false);
            } else if (event.getCode() == KeyCode.SHIFT) {
                mouse.rest(false);
            }
        });
        return mouse;
    }

    private void pressed(MouseEvent event) {
        if (event.getButton() == MouseButton.PRIMARY) {
            // The release of a button over another window is not reported.
            letGo();
        }
        if (event.getButton() == MouseButton.PRIMARY && !event.isShiftDown() && !event.isAltDown()) {
            Optional<Axis> handle = handles.axisAt(event.getX(), event.getY());
            if (handle.isPresent()) {
                take(event);
                axis.set(handle);
                tellAxis();
            } else {
                bodyAt(event).filter(this::isHeldBy).ifPresent(body -> {
                    studio.selection().activate(body);
                    take(event);
                });
            }
        }
    }

    /** Whether a body can be used to drag the selected ones. */
    private boolean isHeldBy(int body) {
        return studio.selection().bodies().contains(body) && BodyEdits.isFree(studio.scene(), body);
    }

    /** Starts a drag of the selected bodies. */
    private void take(MouseEvent event) {
        DrawnPicture picture = studio.pictureProperty().get().orElseThrow();
        DraggedBodies bodies =
                new DraggedBodies(studio.bodies().scene(), studio.selection().bodies());
        Point2D place = place(event);
        draggedTo = new Point2D(event.getX(), event.getY());
        held = Optional.of(new Held(
                BodyDrag.start(
                        picture.input(),
                        bodies.held(),
                        studio.bodies().extent(studio.selection().active()).middle(),
                        place.getX(),
                        place.getY()),
                bodies,
                SurfaceRest.of(studio, picture)));
        view.requestFocus();
        event.consume();
    }

    /** The axis of the drag; empty if it is free. */
    public ReadOnlyObjectProperty<Optional<Axis>> axisProperty() {
        return axis.getReadOnlyProperty();
    }

    private void dragged(MouseEvent event) {
        if (held.isPresent()) {
            draggedTo = new Point2D(event.getX(), event.getY());
            snapping = event.isControlDown();
            resting = event.isShiftDown();
            move();
            event.consume();
        }
    }

    /** Moves the dragged bodies to the pointer; keys restrict the movement. */
    private void move() {
        held.ifPresent(taken -> {
            FrameInput input = studio.pictureProperty().get().orElseThrow().input();
            Point2D to = view.place().toPicture(draggedTo.getX(), draggedTo.getY());
            Vector3 free = axis.get()
                    .map(along -> taken.drag().placeAlong(along, input, to.getX(), to.getY()))
                    .orElseGet(() -> taken.drag().placeAt(input, to.getX(), to.getY()));
            Vector3 snapped = snapping ? BodyDrag.snapped(free, axis.get()) : free;
            Vector3 place = taken.rest()
                    .filter(_ -> resting && axis.get().isEmpty())
                    .flatMap(rest -> rest.place(to.getX(), to.getY()))
                    .orElse(snapped);
            studio.edit("move", scene -> taken.bodies().moved(scene, place));
        });
    }

    /** X, Y and Z restrict the drag to that axis, or free it again. */
    private void keyPressed(KeyCode key, KeyEvent event) {
        if (held.isEmpty()) {
            return;
        }
        if (key == KeyCode.CONTROL) {
            snap(true);
        } else if (key == KeyCode.SHIFT) {
            rest(true);
        }
        Stream.of(Axis.values())
                .filter(along -> along.name().equals(key.getName()))
                .findFirst()
                .ifPresent(along -> {
                    axis.set(axis.get().equals(Optional.of(along)) ? Optional.empty() : Optional.of(along));
                    tellAxis();
                    move();
                    event.consume();
                });
    }

    /** Shows the axis of the drag in the status line. */
    private void tellAxis() {
        studio.retract(told);
        told = axis.get()
                .map(along -> "Moving along " + along.label() + "; " + along.name() + " moves freely again")
                .orElse("");
        if (!told.isEmpty()) {
            studio.notice(told);
        }
    }

    private void snap(boolean on) {
        if (held.isPresent() && snapping != on) {
            snapping = on;
            move();
        }
    }

    private void rest(boolean on) {
        if (held.isPresent() && resting != on) {
            resting = on;
            move();
        }
    }

    private void released(MouseEvent event) {
        if (held.isPresent()) {
            letGo();
            event.consume();
        }
    }

    private void letGo() {
        if (held.isPresent()) {
            held = Optional.empty();
            snapping = false;
            resting = false;
            axis.set(Optional.empty());
            tellAxis();
            studio.endGesture();
        }
    }

    private void clicked(MouseEvent event) {
        if (event.getButton() == MouseButton.PRIMARY && event.isStillSincePress()) {
            if (event.isAltDown()) {
                explain(event.getX(), event.getY());
            } else if (event.isShiftDown() && event.isShortcutDown()) {
                focus(event);
            } else if (event.isShiftDown() || event.isShortcutDown()) {
                bodyAt(event).filter(this::isUnlocked).ifPresent(studio.selection()::toggle);
            } else if (handles.axisAt(event.getX(), event.getY()).isEmpty()) {
                studio.selection().select(bodyAt(event).filter(this::isUnlocked).orElse(BodyNumber.NONE));
            }
        }
    }

    /** Whether a clicked body can be selected; tells it if not. */
    private boolean isUnlocked(int body) {
        boolean locked = TagEdits.of(studio.scene(), body).locked();
        if (locked) {
            studio.notice(BodyTitles.title(studio.scene(), body) + " is locked; select it in the list of bodies");
        }
        return !locked;
    }

    private void explain(double x, double y) {
        studio.pictureProperty().get().filter(_ -> view.place().contains(x, y)).ifPresent(picture -> {
            Point2D place = view.place().toPicture(x, y);
            paths.pick(
                    picture,
                    Math.clamp((int) place.getX(), 0, picture.frame().width() - 1),
                    Math.clamp((int) place.getY(), 0, picture.frame().height() - 1));
        });
    }

    /** Shows the path of the pixel under the pointer, or hides the shown one. */
    public void togglePath() {
        if (paths.isShown()) {
            paths.clear();
        } else {
            pointer.ifPresentOrElse(
                    place -> explain(place.getX(), place.getY()),
                    () -> studio.notice("Point at a pixel of the picture first"));
        }
    }

    /** Focuses the lens on the body at a place. */
    private void focus(MouseEvent event) {
        studio.pictureProperty()
                .get()
                .filter(_ -> view.place().contains(event.getX(), event.getY()))
                .ifPresent(picture -> {
                    Point2D place = place(event);
                    double meters = PropertyNumbers.FOCUS_DISTANCE
                            .scale()
                            .rounded(PointerRay.focusDistance(picture.input(), place.getX(), place.getY()));
                    studio.editOnce(
                            "focus distance",
                            scene -> scene.withCamera(scene.camera().withFocusDistance(meters)));
                    studio.notice(StatusText.focused(studio.scene().camera()));
                });
    }

    private void moved(MouseEvent event) {
        pointer = Optional.of(new Point2D(event.getX(), event.getY()));
        Optional<Axis> handle = handles.axisAt(event.getX(), event.getY());
        handles.point(handle);
        boolean over =
                handle.isPresent() || bodyAt(event).filter(this::isHeldBy).isPresent();
        view.setCursor(over ? Cursor.MOVE : Cursor.DEFAULT);
    }

    /** The scene's body at a place. */
    private Optional<Integer> bodyAt(MouseEvent event) {
        return studio.pictureProperty()
                .get()
                .filter(_ -> view.place().contains(event.getX(), event.getY()))
                .map(picture -> {
                    Point2D place = place(event);
                    return picture.sceneBody(PointerRay.bodyAt(picture.input(), place.getX(), place.getY()));
                })
                .flatMap(body -> studio.picturedBodies().map(bodies -> bodies.inScene(body)));
    }

    private Point2D place(MouseEvent event) {
        return view.place().toPicture(event.getX(), event.getY());
    }
}
