package dev.twister.gui.bodies;

import dev.twister.gui.drawing.DrawnPicture;
import dev.twister.gui.edit.Axis;
import dev.twister.gui.edit.BodyEdits;
import dev.twister.gui.edit.BodyNumber;
import dev.twister.gui.edit.SelectedBodies;
import dev.twister.gui.picking.BodyOutline;
import dev.twister.gui.picking.Projection;
import dev.twister.gui.picture.PictureView;
import dev.twister.gui.picture.PictureView.PicturePlace;
import dev.twister.gui.studio.PictureBodies;
import dev.twister.gui.studio.Studio;
import dev.twister.scene.Mesh;
import dev.twister.scene.Scene;
import dev.twister.scene.Vector3;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import javafx.geometry.Point2D;
import javafx.scene.Group;
import javafx.scene.layout.Pane;
import javafx.scene.shape.Line;
import javafx.scene.shape.Polygon;
import javafx.scene.shape.Rectangle;

/** Draws the outlines of the selected bodies over the picture; the active one's is different. */
public final class SelectionView extends Pane {
    private static final int CORNERS = 96;

    /** Corners of an outline if there are several. */
    private static final int FEW_CORNERS = 48;

    /**
     * If more bodies are selected, the last ones are outlined: an outline takes JavaFX longer than a sphere takes an
     * engine.
     */
    private static final int MOST_OUTLINED = 200;

    /** To map the bodies of more spheres to the picture takes long while their numbers differ. */
    private static final int MOST_MAPPED = 2000;

    /** Length of the axis to both sides of the body. */
    private static final double AXIS_METERS = 1000;

    private final PictureView view;
    private final Studio studio;
    private final Outline active = new Outline();
    private final Group others = new Group();
    private final Line axisLine = new Line();
    private Optional<Axis> axis = Optional.empty();

    public SelectionView(PictureView view, Studio studio, List<Group> handles) {
        this.view = view;
        this.studio = studio;
        setMouseTransparent(true);
        // Outlines beyond the picture must not enlarge this view.
        Rectangle clip = new Rectangle();
        clip.widthProperty().bind(widthProperty());
        clip.heightProperty().bind(heightProperty());
        setClip(clip);
        active.setId("active-outline");
        active.line().setId("outline");
        others.setManaged(false);
        others.setId("other-outlines");
        axisLine.setManaged(false);
        axisLine.setVisible(false);
        axisLine.setId("axis");
        getChildren().addAll(axisLine, others, active);
        getChildren().addAll(handles);
        studio.pictureProperty().subscribe(_ -> refresh());
        studio.selection().bodiesProperty().subscribe(_ -> refresh());
        view.image().boundsInParentProperty().subscribe(_ -> refresh());
    }

    /** Shows the axis along which the active body is moved. */
    public void showAxis(Optional<Axis> newAxis) {
        axis = newAxis;
        refresh();
    }

    private void refreshAxis() {
        int selected = studio.selection().active();
        double[] ends = axis.filter(_ -> BodyEdits.isMovable(studio.scene(), selected))
                .flatMap(along -> studio.pictureProperty().get().map(picture -> {
                    Vector3 middle = studio.bodies().extent(selected).middle();
                    return Projection.of(picture.input())
                            .line(along.from(middle, -AXIS_METERS), along.from(middle, AXIS_METERS));
                }))
                .orElse(new double[0]);
        axisLine.setVisible(ends.length > 0);
        if (ends.length > 0) {
            Point2D from = view.place().toView(ends[0], ends[1]);
            Point2D to = view.place().toView(ends[2], ends[3]);
            axisLine.setStartX(from.getX());
            axisLine.setStartY(from.getY());
            axisLine.setEndX(to.getX());
            axisLine.setEndY(to.getY());
            axisLine.getStyleClass().setAll("axis", "axis-" + axis.orElseThrow().label());
        }
    }

    private void refresh() {
        refreshAxis();
        SelectedBodies selected = studio.selection().bodies();
        active.show(points(selected.active(), CORNERS));
        List<Integer> outlined = outlined(selected);
        while (others.getChildren().size() > outlined.size()) {
            others.getChildren().removeLast();
        }
        for (int index = 0; index < outlined.size(); index++) {
            if (index == others.getChildren().size()) {
                others.getChildren().add(new Outline("outline-other"));
            }
            ((Outline) others.getChildren().get(index)).show(points(outlined.get(index), FEW_CORNERS));
        }
    }

    /** The outlines of the other bodies. */
    private List<Integer> outlined(SelectedBodies selected) {
        boolean renumbered =
                studio.picturedBodies().filter(PictureBodies::renumbered).isPresent()
                        && studio.scene().spheres().size() > MOST_MAPPED;
        return renumbered
                ? List.of()
                : selected.bodies().reversed().stream()
                        .filter(body -> body != selected.active())
                        .limit(MOST_OUTLINED - 1)
                        .toList();
    }

    private List<Double> points(int body, int corners) {
        return studio.picturedBodies()
                .map(bodies -> bodies.inPicture(body))
                .flatMap(pictured ->
                        studio.pictureProperty().get().map(picture -> points(corners(picture, pictured, corners))))
                .orElse(List.of());
    }

    private List<Double> points(double[] corners) {
        PicturePlace place = view.place();
        List<Double> points = new ArrayList<>();
        for (int i = 0; i < corners.length; i += 2) {
            Point2D corner = place.toView(corners[i], corners[i + 1]);
            points.add(corner.getX());
            points.add(corner.getY());
        }
        return points;
    }

    private static double[] corners(DrawnPicture picture, int body, int count) {
        Scene scene = picture.request().scene();
        if (BodyEdits.isMesh(scene, body)) {
            Mesh mesh = BodyEdits.mesh(scene, body);
            return picture.meshes().holds(mesh)
                    ? BodyOutline.ofMesh(picture.input(), picture.meshes().farPoints(mesh))
                    : new double[0];
        }
        if (BodyEdits.isLight(scene, body)) {
            int light = BodyNumber.light(body);
            return BodyOutline.ofSphere(picture.input(), picture.input().light(light), count);
        }
        // Nothing or the plane is selected, or the picture is older than the body.
        return body == BodyNumber.NONE
                        || body == BodyNumber.PLANE
                        || body >= picture.input().bodyCount()
                ? new double[0]
                : BodyOutline.ofSphere(picture.input(), body, count);
    }

    /** The outline of a body, readable over any picture. */
    private static final class Outline extends Group {
        private final Polygon shade = new Polygon();
        private final Polygon line = new Polygon();

        Outline(String... styles) {
            setManaged(false);
            shade.getStyleClass().addAll("outline", "outline-shade");
            line.getStyleClass().add("outline");
            line.getStyleClass().addAll(styles);
            getChildren().addAll(shade, line);
        }

        Polygon line() {
            return line;
        }

        /** Sets the corners: x and y of each in turn. */
        void show(List<Double> points) {
            // Setting the same points would make JavaFX paint again.
            if (!line.getPoints().equals(points)) {
                line.getPoints().setAll(points);
                shade.getPoints().setAll(points);
            }
        }
    }
}
