package dev.twister.gui.bodies;

import dev.twister.gui.drawing.DrawnPicture;
import dev.twister.gui.edit.Axis;
import dev.twister.gui.edit.BodyTransform;
import dev.twister.gui.edit.BodyTransform.Mode;
import dev.twister.gui.picking.BodyDrag;
import dev.twister.gui.picking.Projection;
import dev.twister.gui.picture.PictureView;
import dev.twister.gui.studio.Studio;
import dev.twister.kernel.Layout;
import dev.twister.scene.Scene;
import dev.twister.scene.Vector3;
import dev.twister.world.FrameInput;
import java.util.Optional;
import java.util.function.UnaryOperator;
import java.util.stream.Stream;
import javafx.geometry.Point2D;
import javafx.scene.Node;
import javafx.scene.input.KeyCode;
import javafx.scene.input.KeyEvent;
import javafx.scene.input.MouseButton;
import javafx.scene.input.MouseEvent;

/**
 * Moves, rotates and scales the selected bodies by the pointer, without a button held, or by a typed number. X, Y and Z
 * choose an axis; Enter or a click confirms, Esc or the right button cancels.
 */
public final class TransformKeys {
    private final PictureView view;
    private final Studio studio;
    private Point2D pointer = Point2D.ZERO;
    private Optional<Held> held = Optional.empty();
    private Mode mode = Mode.MOVE;
    private Optional<Axis> axis = Optional.empty();
    private String typed = "";
    private boolean snapping;

    /** Whether the active body is put on the surface under the pointer. */
    private boolean resting;

    private boolean edited;
    private boolean swallowing;
    private String told = "";

    /** What is transformed, by a picture and the pointer's place in it at the start. */
    private record Held(
            BodyTransform bodies, BodyDrag drag, FrameInput input, Point2D from, Optional<SurfaceRest> rest) {}

    private TransformKeys(PictureView view, Studio studio) {
        this.view = view;
        this.studio = studio;
    }

    /**
     * Adds event filters.
     *
     * @param around the picture, so that they run before all of the picture's own
     */
    public static TransformKeys install(Node around, PictureView view, Studio studio) {
        TransformKeys keys = new TransformKeys(view, studio);
        around.addEventFilter(MouseEvent.MOUSE_MOVED, keys::moved);
        around.addEventFilter(MouseEvent.MOUSE_DRAGGED, keys::swallow);
        around.addEventFilter(MouseEvent.MOUSE_PRESSED, keys::pressed);
        around.addEventFilter(MouseEvent.MOUSE_CLICKED, keys::swallow);
        around.addEventFilter(KeyEvent.KEY_PRESSED, keys::keyPressed);
        around.addEventFilter(KeyEvent.KEY_RELEASED, event -> {
            if (event.getCode() == KeyCode.CONTROL || event.getCode() == KeyCode.SHIFT) {
                keys.snapping = keys.snapping && event.getCode() != KeyCode.CONTROL;
                keys.resting = keys.resting && event.getCode() != KeyCode.SHIFT;
                keys.show();
            }
        });
        view.focusedProperty().subscribe(focused -> {
            if (!focused) {
                keys.confirm();
            }
        });
        studio.selection().bodiesProperty().subscribe(_ -> keys.confirm());
        return keys;
    }

    /** Starts to move, rotate or scale what is selected; tells it if nothing is. */
    public void start(Mode newMode) {
        confirm();
        Optional<BodyTransform> bodies =
                BodyTransform.of(studio.bodies().scene(), studio.selection().bodies());
        if (bodies.isEmpty() || studio.pictureProperty().get().isEmpty()) {
            studio.notice("Select a sphere, a mesh or a light first");
            return;
        }
        view.requestFocus();
        DrawnPicture picture = studio.pictureProperty().get().get();
        FrameInput input = picture.input();
        Point2D from = pixel(input);
        Vector3 pivot = bodies.get().pivot();
        held = Optional.of(new Held(
                bodies.get(),
                BodyDrag.start(input, pivot, pivot, from.getX(), from.getY()),
                input,
                from,
                SurfaceRest.of(studio, picture)));
        mode = newMode;
        axis = Optional.empty();
        typed = "";
        snapping = false;
        resting = false;
        edited = false;
        tell();
    }

    private void moved(MouseEvent event) {
        pointer = view.sceneToLocal(event.getSceneX(), event.getSceneY());
        if (held.isPresent()) {
            snapping = event.isControlDown();
            resting = event.isShiftDown();
            if (typed.isEmpty()) {
                show();
            }
            event.consume();
        }
    }

    /** The click that confirms or cancels selects nothing. */
    private void swallow(MouseEvent event) {
        if (held.isPresent() || swallowing) {
            swallowing = event.getEventType() != MouseEvent.MOUSE_CLICKED && swallowing;
            event.consume();
        }
    }

    private void pressed(MouseEvent event) {
        swallowing = held.isPresent();
        if (held.isPresent()) {
            if (event.getButton() == MouseButton.PRIMARY) {
                confirm();
            } else {
                cancel();
            }
            event.consume();
        }
    }

    private void keyPressed(KeyEvent event) {
        if (held.isEmpty()) {
            return;
        }
        KeyCode key = event.getCode();
        Optional<Axis> along = Stream.of(Axis.values())
                .filter(one -> one.name().equals(key.getName()))
                .findFirst();
        Optional<Mode> other = mode(key);
        if (key == KeyCode.ENTER) {
            confirm();
        } else if (key == KeyCode.ESCAPE) {
            cancel();
        } else if (key == KeyCode.CONTROL) {
            snapping = true;
            show();
        } else if (key == KeyCode.SHIFT) {
            resting = true;
            show();
        } else if (along.isPresent()) {
            axis = axis.equals(along) ? Optional.empty() : along;
            show();
        } else if (other.isPresent()) {
            mode = other.get();
            typed = "";
            show();
        } else if (key == KeyCode.BACK_SPACE) {
            typed = typed.isEmpty() ? "" : typed.substring(0, typed.length() - 1);
            show();
        } else if (character(event).isPresent()) {
            typed += character(event).get();
            show();
        } else {
            return;
        }
        event.consume();
    }

    private static Optional<Mode> mode(KeyCode key) {
        return switch (key) {
            case G -> Optional.of(Mode.MOVE);
            case R -> Optional.of(Mode.ROTATE);
            case S -> Optional.of(Mode.SCALE);
            default -> Optional.empty();
        };
    }

    private Optional<String> character(KeyEvent event) {
        KeyCode key = event.getCode();
        if (key.isDigitKey()) {
            String name = key.getName();
            return Optional.of(name.substring(name.length() - 1));
        }
        return switch (key) {
            case MINUS, SUBTRACT -> Optional.of("-").filter(_ -> typed.isEmpty());
            case PERIOD, DECIMAL, COMMA -> Optional.of(".").filter(_ -> !typed.contains("."));
            default -> Optional.empty();
        };
    }

    /** Shows the bodies as the pointer or the typed number has them. */
    private void show() {
        held.ifPresent(taken -> {
            UnaryOperator<Scene> change = switch (mode) {
                case MOVE -> move(taken);
                case ROTATE -> rotation(taken);
                case SCALE -> {
                    double factor = number().orElseGet(() -> snap(factor(taken)));
                    yield scene -> taken.bodies().scaled(scene, factor);
                }
            };
            edited = true;
            // One name for all modes, so that they are undone together.
            studio.edit("transform", change);
            tell();
        });
    }

    private UnaryOperator<Scene> move(Held taken) {
        Vector3 pivot = taken.bodies().pivot();
        Point2D to = pixel(taken.input());
        Point2D seen = view.place().toPicture(pointer.getX(), pointer.getY());
        Optional<Vector3> rest = taken.rest()
                .filter(_ -> resting && axis.isEmpty())
                .flatMap(surface -> surface.way(seen.getX(), seen.getY()));
        Vector3 by = number().map(meters -> axis.orElse(Axis.X).from(Vector3.ZERO, meters))
                .or(() -> rest)
                .orElseGet(() -> {
                    Vector3 free = axis.map(
                                    along -> taken.drag().placeAlong(along, taken.input(), to.getX(), to.getY()))
                            .orElseGet(() -> taken.drag().placeAt(taken.input(), to.getX(), to.getY()));
                    return (snapping ? BodyDrag.snapped(free, axis) : free).minus(pivot);
                });
        return scene -> taken.bodies().moved(scene, by);
    }

    private UnaryOperator<Scene> rotation(Held taken) {
        float[] camera = taken.input().view().frame();
        Vector3 ahead = new Vector3(
                camera[Layout.CAMERA_FORWARD], camera[Layout.CAMERA_FORWARD + 1], camera[Layout.CAMERA_FORWARD + 2]);
        Vector3 about = axis.map(along -> along.from(Vector3.ZERO, 1)).orElse(ahead);
        double sign = about.dot(ahead) < 0 ? 1 : -1;
        double degrees = number().orElseGet(() -> snap(sign * screenDegrees(taken)));
        return scene -> taken.bodies().rotated(scene, about, degrees);
    }

    private double snap(double number) {
        return snapping ? BodyTransform.snapped(mode, number) : number;
    }

    /** How far the pointer has gone around the pivot, clockwise. */
    private double screenDegrees(Held taken) {
        Point2D middle = middle(taken);
        Point2D from = taken.from().subtract(middle);
        Point2D to = pixel(taken.input()).subtract(middle);
        return Math.toDegrees(Math.atan2(to.getY(), to.getX()) - Math.atan2(from.getY(), from.getX()));
    }

    private double factor(Held taken) {
        Point2D middle = middle(taken);
        double from = Math.max(1, taken.from().distance(middle));
        return pixel(taken.input()).distance(middle) / from;
    }

    /** The pointer's place in the picture at the start; the present one may have more pixels. */
    private Point2D pixel(FrameInput input) {
        return view.place().toPicture(pointer.getX(), pointer.getY(), input);
    }

    private static Point2D middle(Held taken) {
        double[] pixel = Projection.of(taken.input()).point(taken.bodies().pivot());
        return pixel.length == 0 ? Point2D.ZERO : new Point2D(pixel[0], pixel[1]);
    }

    /** The typed number; empty if there is none yet. */
    private Optional<Double> number() {
        try {
            return Optional.of(Double.parseDouble(typed));
        } catch (NumberFormatException _) {
            return Optional.empty();
        }
    }

    private void tell() {
        told = mode.label()
                + axis.filter(_ -> mode != Mode.SCALE)
                        .map(along -> (mode == Mode.MOVE ? " along " : " about ") + along.label())
                        .orElse("")
                + (typed.isEmpty() ? "" : " " + typed + " " + mode.unit())
                + ": X, Y, Z axis; type a number; Enter or click confirms, Esc cancels; Ctrl snaps"
                + (mode == Mode.MOVE ? ", Shift rests it on a surface" : "");
        studio.notice(told);
    }

    private void confirm() {
        if (held.isPresent()) {
            end();
        }
    }

    private void cancel() {
        end();
        if (edited) {
            studio.undo();
        }
        studio.notice("Canceled");
    }

    private void end() {
        held = Optional.empty();
        studio.endGesture();
        studio.retract(told);
    }
}
