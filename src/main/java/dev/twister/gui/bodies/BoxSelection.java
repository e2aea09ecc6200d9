package dev.twister.gui.bodies;

import dev.twister.gui.drawing.DrawnPicture;
import dev.twister.gui.edit.BodyEdits;
import dev.twister.gui.picking.Projection;
import dev.twister.gui.picture.PictureView;
import dev.twister.gui.studio.Studio;
import dev.twister.scene.Scene;
import dev.twister.scene.Vector3;
import dev.twister.world.FrameInput;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import javafx.geometry.Point2D;
import javafx.scene.Cursor;
import javafx.scene.Node;
import javafx.scene.input.KeyCode;
import javafx.scene.input.KeyEvent;
import javafx.scene.input.MouseButton;
import javafx.scene.input.MouseEvent;
import javafx.scene.layout.Pane;
import javafx.scene.shape.Rectangle;

/** Selects the bodies in a box that is dragged over the picture; Shift adds them to the selection. */
public final class BoxSelection extends Pane {
    private final PictureView view;
    private final Studio studio;
    private final Rectangle box = new Rectangle();
    private boolean armed;
    private Optional<Point2D> corner = Optional.empty();

    /**
     * Lays the box over the picture.
     *
     * @param around the picture, so that events are taken before all of the picture's own
     */
    public BoxSelection(Node around, PictureView view, Studio studio) {
        this.view = view;
        this.studio = studio;
        setMouseTransparent(true);
        box.getStyleClass().add("selection-box");
        box.setManaged(false);
        box.setVisible(false);
        getChildren().add(box);
        view.addOverlay(this);
        around.addEventFilter(MouseEvent.MOUSE_PRESSED, this::pressed);
        around.addEventFilter(MouseEvent.MOUSE_DRAGGED, this::dragged);
        around.addEventFilter(MouseEvent.MOUSE_RELEASED, this::released);
        around.addEventFilter(KeyEvent.KEY_PRESSED, event -> {
            if (armed && event.getCode() == KeyCode.ESCAPE) {
                disarm();
                event.consume();
            }
        });
    }

    /** The next drag over the picture selects. */
    public void arm() {
        armed = true;
        view.requestFocus();
        view.setCursor(Cursor.CROSSHAIR);
        studio.notice("Drag a box over the bodies; Shift adds them to the selection");
    }

    private void disarm() {
        armed = false;
        corner = Optional.empty();
        box.setVisible(false);
        view.setCursor(Cursor.DEFAULT);
    }

    private Point2D place(MouseEvent event) {
        return view.sceneToLocal(event.getSceneX(), event.getSceneY());
    }

    private void pressed(MouseEvent event) {
        if (armed && event.getButton() == MouseButton.PRIMARY) {
            corner = Optional.of(place(event));
            event.consume();
        }
    }

    private void dragged(MouseEvent event) {
        corner.ifPresent(from -> {
            Point2D to = place(event);
            box.setX(Math.min(from.getX(), to.getX()));
            box.setY(Math.min(from.getY(), to.getY()));
            box.setWidth(Math.abs(to.getX() - from.getX()));
            box.setHeight(Math.abs(to.getY() - from.getY()));
            box.setVisible(true);
            event.consume();
        });
    }

    private void released(MouseEvent event) {
        corner.ifPresent(from -> {
            studio.pictureProperty()
                    .get()
                    .ifPresent(picture -> select(picture, from, place(event), event.isShiftDown()));
            disarm();
            event.consume();
        });
    }

    private void select(DrawnPicture picture, Point2D from, Point2D to, boolean more) {
        Point2D start = view.place().toPicture(from.getX(), from.getY());
        Point2D end = view.place().toPicture(to.getX(), to.getY());
        List<Integer> chosen =
                new ArrayList<>(more ? studio.selection().bodies().bodies() : List.of());
        chosen.addAll(Box.between(start.getX(), start.getY(), end.getX(), end.getY())
                .bodies(
                        studio.scene(),
                        picture.input(),
                        body -> studio.bodies().extent(body).middle()));
        studio.selection().select(chosen);
        studio.notice(studio.selection().bodies().count() + " bodies selected");
    }

    /**
     * A box in a picture, which selects the bodies whose middle is in it.
     *
     * @param left in pixels
     * @param top in pixels
     * @param right in pixels, at least the left
     * @param bottom in pixels, at least the top
     */
    public record Box(double left, double top, double right, double bottom) {
        /** The box between two corners. */
        public static Box between(double x, double y, double otherX, double otherY) {
            return new Box(Math.min(x, otherX), Math.min(y, otherY), Math.max(x, otherX), Math.max(y, otherY));
        }

        /**
         * The movable bodies in the box.
         *
         * @param middle of a body
         */
        public List<Integer> bodies(Scene scene, FrameInput input, Function<Integer, Vector3> middle) {
            Projection projection = Projection.of(input);
            return BodyEdits.movable(scene).stream()
                    .filter(body -> contains(projection.point(middle.apply(body))))
                    .toList();
        }

        private boolean contains(double[] pixel) {
            return pixel.length == 2 && pixel[0] >= left && pixel[0] <= right && pixel[1] >= top && pixel[1] <= bottom;
        }
    }
}
