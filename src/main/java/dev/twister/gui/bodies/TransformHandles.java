package dev.twister.gui.bodies;

import dev.twister.gui.drawing.DrawnPicture;
import dev.twister.gui.edit.Axis;
import dev.twister.gui.edit.BodyEdits;
import dev.twister.gui.edit.BodyTransform.Mode;
import dev.twister.gui.picking.AxisHandle;
import dev.twister.gui.picking.Projection;
import dev.twister.gui.picking.RotationRing;
import dev.twister.gui.picture.PictureView;
import dev.twister.gui.picture.PictureView.PicturePlace;
import dev.twister.gui.studio.Studio;
import dev.twister.scene.Vector3;
import java.util.Comparator;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;
import javafx.css.PseudoClass;
import javafx.geometry.Point2D;
import javafx.scene.Group;
import javafx.scene.shape.Circle;
import javafx.scene.shape.Line;
import javafx.scene.shape.Polyline;
import javafx.scene.shape.Rectangle;

/**
 * Draws rings at the active body that rotate the selected bodies about an axis, a box that scales them, and a dot on
 * the way of a sun's or spot's light that aims it. Shown beside the {@link AxisHandles}; there are no rings where a
 * rotation changes nothing.
 */
public final class TransformHandles extends Group {
    private static final PseudoClass POINTED = PseudoClass.getPseudoClass("pointed");

    /** Of the rings, in the view's units. */
    private static final double RADIUS = 50;

    /** From the body's middle to the box, to the right and down. */
    private static final double BOX_PLACE = 58;

    private static final double BOX = 10;

    /** From the light to the dot, across the view. */
    private static final double AIM_LENGTH = 96;

    private static final double AIM_RADIUS = 5;

    /** Distance from which the pointer grabs a handle. */
    private static final double REACH = 6;

    private final PictureView view;
    private final Studio studio;
    private final AxisHandles arrows;
    private final Map<Axis, Ring> rings = new EnumMap<>(Axis.class);
    private final Rectangle box = new Rectangle(BOX, BOX);
    private final Line aimShade = new Line();
    private final Line aimLine = new Line();
    private final Circle aim = new Circle(AIM_RADIUS);
    private Shown shown = new Shown(Optional.empty(), List.of(), Optional.empty());

    /** What is seen: places in the view. */
    private record Shown(Optional<Point2D> middle, List<RotationRing> rings, Optional<Point2D> aim) {}

    /**
     * A handle of that kind.
     *
     * @param axis of a rotation; empty for the box, and for the dot, which turns a light in any direction
     */
    record Handle(Mode mode, Optional<Axis> axis) {
        private static final Handle BOX = new Handle(Mode.SCALE, Optional.empty());
        private static final Handle DOT = new Handle(Mode.ROTATE, Optional.empty());

        boolean aims() {
            return equals(DOT);
        }
    }

    private static final class Ring extends Group {
        private final Polyline shade = new Polyline();
        private final Polyline line = new Polyline();

        Ring(Axis axis) {
            setId("ring-" + axis.label());
            setAccessibleText("Rotates about " + axis.label());
            shade.getStyleClass().add("handle-shade");
            line.getStyleClass().addAll("handle", "axis-" + axis.label());
            getChildren().addAll(shade, line);
        }

        void place(List<AxisHandle.Point> points) {
            List<Double> coordinates = points.stream()
                    .flatMap(point -> Stream.of(point.x(), point.y()))
                    .toList();
            shade.getPoints().setAll(coordinates);
            line.getPoints().setAll(coordinates);
        }
    }

    public TransformHandles(PictureView view, Studio studio, AxisHandles arrows) {
        this.view = view;
        this.studio = studio;
        this.arrows = arrows;
        setManaged(false);
        for (Axis axis : Axis.values()) {
            Ring ring = new Ring(axis);
            rings.put(axis, ring);
            getChildren().add(ring);
        }
        box.setId("scale-handle");
        box.setAccessibleText("Scales");
        box.getStyleClass().add("scale-handle");
        getChildren().add(box);
        aim.setId("aim-handle");
        aim.setAccessibleText("Aims the light");
        aim.getStyleClass().add("aim-handle");
        aimShade.getStyleClass().add("handle-shade");
        aimLine.getStyleClass().addAll("handle", "aim-line");
        getChildren().addAll(aimShade, aimLine, aim);
        show(shown);
        arrows.setOnRefresh(this::refresh);
    }

    /** The handle at a place of the view; arrows go first. */
    Optional<Handle> handleAt(double x, double y) {
        if (arrows.axisAt(x, y).isPresent()) {
            return Optional.empty();
        }
        if (shown.aim().filter(dot -> dot.distance(x, y) <= AIM_RADIUS + 2).isPresent()) {
            return Optional.of(Handle.DOT);
        }
        boolean atBox = shown.middle()
                .filter(_ -> box.getBoundsInParent().contains(x, y))
                .isPresent();
        return atBox
                ? Optional.of(Handle.BOX)
                : shown.rings().stream()
                        .filter(ring -> ring.distance(x, y) <= REACH)
                        .min(Comparator.comparingDouble(ring -> ring.distance(x, y)))
                        .map(ring -> new Handle(Mode.ROTATE, Optional.of(ring.axis())));
    }

    /** Highlights the handle that is grabbed or would be. */
    void point(Optional<Handle> pointed) {
        rings.forEach((axis, ring) -> ring.line.pseudoClassStateChanged(
                POINTED, pointed.flatMap(Handle::axis).equals(Optional.of(axis))));
        box.pseudoClassStateChanged(POINTED, pointed.equals(Optional.of(Handle.BOX)));
        aim.pseudoClassStateChanged(POINTED, pointed.equals(Optional.of(Handle.DOT)));
    }

    private void refresh(Optional<Vector3> body) {
        Optional<DrawnPicture> picture = studio.pictureProperty().get();
        Optional<Projection> projection = picture.map(drawn -> Projection.of(drawn.input()));
        PicturePlace place = view.place();
        Optional<Point2D> seen = body.flatMap(at -> projection.map(to -> to.point(at)))
                .filter(pixel -> pixel.length > 0)
                .map(pixel -> place.toView(pixel[0], pixel[1]));
        List<RotationRing> turning = body
                .filter(_ -> turns())
                .flatMap(at -> projection.map(to -> RotationRing.of(to, at, place.toPicture(RADIUS))))
                .orElse(List.of())
                .stream()
                .map(ring -> new RotationRing(
                        ring.axis(),
                        ring.points().stream()
                                .map(point -> AxisHandles.inView(place, point))
                                .toList()))
                .toList();
        Optional<Point2D> tip = seen.flatMap(_ -> projection.flatMap(to -> tip(to, body.orElseThrow())));
        Shown now = new Shown(seen, turning, tip);
        // Setting the same places would make JavaFX paint again.
        if (!now.equals(shown)) {
            show(now);
        }
    }

    /** Where the active light shines, at a length that is the same at any distance. */
    private Optional<Point2D> tip(Projection projection, Vector3 middle) {
        PicturePlace place = view.place();
        int active = studio.selection().active();
        double meters = place.toPicture(AIM_LENGTH) / projection.pixelsPerMeter(middle);
        return Optional.of(studio.bodies().scene())
                .filter(scene -> BodyEdits.isAimed(scene, active))
                .map(scene -> BodyEdits.light(scene, active).shape().toward().times(-meters))
                .map(way -> projection.point(middle.plus(way)))
                .filter(pixel -> pixel.length > 0)
                .map(pixel -> place.toView(pixel[0], pixel[1]));
    }

    /** Whether a rotation changes the selected bodies: one sphere alone stays as it is. */
    private boolean turns() {
        int active = studio.selection().active();
        return BodyEdits.isMesh(studio.scene(), active)
                || BodyEdits.isAimed(studio.scene(), active)
                || studio.selection().bodies().count() > 1;
    }

    private void show(Shown now) {
        shown = now;
        rings.values().forEach(ring -> ring.setVisible(false));
        for (RotationRing seen : now.rings()) {
            Ring ring = rings.get(seen.axis());
            ring.place(seen.points());
            ring.setVisible(true);
        }
        box.setVisible(now.middle().isPresent());
        now.middle()
                .ifPresent(place -> box.relocate(
                        Math.rint(place.getX() + BOX_PLACE - BOX / 2), Math.rint(place.getY() + BOX_PLACE - BOX / 2)));
        List.of(aimShade, aimLine, aim)
                .forEach(part -> part.setVisible(now.aim().isPresent()));
        now.aim().ifPresent(dot -> {
            Point2D from = now.middle().orElseThrow();
            for (Line line : List.of(aimShade, aimLine)) {
                line.setStartX(from.getX());
                line.setStartY(from.getY());
                line.setEndX(dot.getX());
                line.setEndY(dot.getY());
            }
            aim.setCenterX(dot.getX());
            aim.setCenterY(dot.getY());
        });
    }
}
