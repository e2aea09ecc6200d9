package dev.twister.gui.bodies;

import dev.twister.gui.drawing.DrawnPicture;
import dev.twister.gui.edit.Axis;
import dev.twister.gui.edit.BodyEdits;
import dev.twister.gui.edit.BodyExtent;
import dev.twister.gui.picking.AxisHandle;
import dev.twister.gui.picking.Projection;
import dev.twister.gui.picture.PathPick;
import dev.twister.gui.picture.PictureView;
import dev.twister.gui.picture.PictureView.PicturePlace;
import dev.twister.gui.studio.Studio;
import dev.twister.scene.Scene;
import dev.twister.scene.Vector3;
import java.util.Comparator;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import javafx.beans.property.BooleanProperty;
import javafx.beans.property.SimpleBooleanProperty;
import javafx.css.PseudoClass;
import javafx.geometry.Point2D;
import javafx.scene.Group;
import javafx.scene.shape.Line;
import javafx.scene.shape.Polygon;

/**
 * Draws arrows at the active body that move the selected bodies along an axis. Hidden while physics runs and while a
 * pixel's path is shown.
 */
public final class AxisHandles extends Group {
    private static final PseudoClass POINTED = PseudoClass.getPseudoClass("pointed");

    /** Length from the body's middle to the tip, in the view's units. */
    private static final double LENGTH = 70;

    private static final double HEAD_LENGTH = 12;
    private static final double HEAD_HALF_WIDTH = 5;

    /** Distance from which the pointer grabs a handle. */
    private static final double REACH = 7;

    private final PictureView view;
    private final Studio studio;
    private final PathPick paths;
    private final BooleanProperty on = new SimpleBooleanProperty(true);
    private final Map<Axis, Arrow> arrows = new EnumMap<>(Axis.class);
    private List<AxisHandle> handles = List.of();
    private Consumer<Optional<Vector3>> follower = _ -> {};

    /** One handle. */
    private static final class Arrow extends Group {
        private final Line shade = new Line();
        private final Line line = new Line();
        private final Polygon head = new Polygon();

        Arrow(Axis axis) {
            String style = "axis-" + axis.label();
            setId("handle-" + axis.label());
            shade.getStyleClass().add("handle-shade");
            line.getStyleClass().addAll("handle", style);
            head.getStyleClass().addAll("handle-head", style);
            getChildren().addAll(shade, line, head);
        }

        void place(Point2D start, Point2D tip) {
            Point2D along = tip.subtract(start).normalize();
            Point2D across = new Point2D(-along.getY(), along.getX()).multiply(HEAD_HALF_WIDTH);
            Point2D neck = tip.subtract(along.multiply(HEAD_LENGTH));
            for (Line part : List.of(shade, line)) {
                part.setStartX(start.getX());
                part.setStartY(start.getY());
                part.setEndX(neck.getX());
                part.setEndY(neck.getY());
            }
            Point2D left = neck.add(across);
            Point2D right = neck.subtract(across);
            head.getPoints().setAll(left.getX(), left.getY(), tip.getX(), tip.getY(), right.getX(), right.getY());
        }

        void setPointed(boolean pointed) {
            line.pseudoClassStateChanged(POINTED, pointed);
            head.pseudoClassStateChanged(POINTED, pointed);
        }
    }

    public AxisHandles(PictureView view, Studio studio, PathPick paths) {
        this.view = view;
        this.studio = studio;
        this.paths = paths;
        setManaged(false);
        for (Axis axis : Axis.values()) {
            Arrow arrow = new Arrow(axis);
            arrow.setVisible(false);
            arrows.put(axis, arrow);
            getChildren().add(arrow);
        }
        studio.pictureProperty().subscribe(_ -> refresh());
        studio.selection().bodiesProperty().subscribe(_ -> refresh());
        studio.motion().motionProperty().subscribe(_ -> refresh());
        paths.pathProperty().subscribe(_ -> refresh());
        on.subscribe(_ -> refresh());
        view.image().boundsInParentProperty().subscribe(_ -> refresh());
    }

    /** Whether handles are shown. */
    public BooleanProperty onProperty() {
        return on;
    }

    /** Tells after each change of the picture where the active body is; empty where there are no handles. */
    void setOnRefresh(Consumer<Optional<Vector3>> newFollower) {
        follower = newFollower;
    }

    /** The axis of the handle at a place of the view. */
    Optional<Axis> axisAt(double x, double y) {
        return handles.stream()
                .filter(handle -> handle.distance(x, y) <= REACH)
                .min(Comparator.comparingDouble(handle -> handle.distance(x, y)))
                .map(AxisHandle::axis);
    }

    /** Highlights the handle that is grabbed or would be. */
    public void point(Optional<Axis> pointed) {
        arrows.forEach((axis, arrow) -> arrow.setPointed(pointed.equals(Optional.of(axis))));
    }

    private void refresh() {
        Optional<DrawnPicture> picture = studio.pictureProperty().get().filter(_ -> isWanted());
        Optional<Vector3> middle = picture.flatMap(this::middle);
        List<AxisHandle> seen = middle.map(
                        at -> seen(Projection.of(picture.orElseThrow().input()), at))
                .orElse(List.of());
        // Setting the same places would make JavaFX paint again.
        if (!seen.equals(handles)) {
            handles = seen;
            arrows.values().forEach(arrow -> arrow.setVisible(false));
            for (AxisHandle handle : handles) {
                Arrow arrow = arrows.get(handle.axis());
                arrow.place(point(handle.start()), point(handle.tip()));
                arrow.setVisible(true);
            }
        }
        follower.accept(middle);
    }

    private boolean isWanted() {
        return on.get()
                && !paths.isShown()
                && !studio.motion().motionProperty().get().running();
    }

    private List<AxisHandle> seen(Projection projection, Vector3 middle) {
        PicturePlace place = view.place();
        return AxisHandle.of(projection, middle, place.toPicture(LENGTH)).stream()
                .map(handle ->
                        new AxisHandle(handle.axis(), inView(place, handle.middle()), inView(place, handle.tip())))
                .toList();
    }

    /** The middle of the active body in the picture; empty if it is not visible. */
    private Optional<Vector3> middle(DrawnPicture picture) {
        int active = studio.selection().active();
        Scene scene = picture.request().scene();
        return studio.picturedBodies()
                .filter(_ -> BodyEdits.isFree(studio.scene(), active))
                .map(bodies -> bodies.inPicture(active))
                .filter(body -> BodyEdits.isMovable(scene, body))
                .map(body -> BodyEdits.isSphere(scene, body)
                        ? picture.input().bodies().centerInScene(body)
                        : BodyExtent.of(scene, picture.meshes(), body).middle());
    }

    static AxisHandle.Point inView(PicturePlace place, AxisHandle.Point pixel) {
        Point2D seen = place.toView(pixel.x(), pixel.y());
        return new AxisHandle.Point(seen.getX(), seen.getY());
    }

    private static Point2D point(AxisHandle.Point place) {
        return new Point2D(place.x(), place.y());
    }
}
