package dev.twister.gui;

import dev.twister.gui.drawing.DrawnPicture;
import dev.twister.gui.model.Axis;
import dev.twister.gui.model.BodyEdits;
import dev.twister.gui.model.BodyNumber;
import dev.twister.gui.model.MeshOutline;
import dev.twister.gui.model.Projection;
import dev.twister.gui.model.SphereOutline;
import dev.twister.scene.Mesh;
import dev.twister.scene.Scene;
import dev.twister.scene.Vector3;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import javafx.geometry.Point2D;
import javafx.scene.layout.Pane;
import javafx.scene.shape.Line;
import javafx.scene.shape.Polygon;
import javafx.scene.shape.Rectangle;

/** Draws the selected body's outline over the picture. */
final class SelectionView extends Pane {
    private static final int CORNERS = 96;

    /** Both ways from the body. */
    private static final double AXIS_METERS = 1000;

    private final PictureView view;
    private final Studio studio;
    private final Polygon shade = new Polygon();
    private final Polygon line = new Polygon();
    private final Line axisLine = new Line();
    private Optional<Axis> axis = Optional.empty();

    SelectionView(PictureView view, Studio studio) {
        this.view = view;
        this.studio = studio;
        setMouseTransparent(true);
        // An outline that goes beyond the picture makes no room for itself.
        Rectangle clip = new Rectangle();
        clip.widthProperty().bind(widthProperty());
        clip.heightProperty().bind(heightProperty());
        setClip(clip);
        for (Polygon polygon : List.of(shade, line)) {
            polygon.setManaged(false);
            polygon.getStyleClass().add("outline");
        }
        shade.getStyleClass().add("outline-shade");
        line.setId("outline");
        axisLine.setManaged(false);
        axisLine.setVisible(false);
        axisLine.setId("axis");
        getChildren().addAll(axisLine, shade, line);
        studio.pictureProperty().subscribe(_ -> refresh());
        studio.selectionProperty().subscribe(_ -> refresh());
        view.image().boundsInParentProperty().subscribe(_ -> refresh());
    }

    /** Shows the axis through the selected body, along which it is moved. */
    void showAxis(Optional<Axis> newAxis) {
        axis = newAxis;
        refresh();
    }

    private void refreshAxis() {
        int selected = studio.selectionProperty().get();
        double[] ends = axis.filter(_ -> BodyEdits.isMovable(studio.scene(), selected))
                .flatMap(along -> studio.pictureProperty().get().map(picture -> {
                    Vector3 middle = studio.extentNow(selected).middle();
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
        int selected = studio.selectionProperty().get();
        List<Double> points = studio.picturedBodies()
                .map(bodies -> bodies.inPicture(selected))
                .flatMap(body -> studio.pictureProperty().get().map(picture -> points(picture, body)))
                .orElse(List.of());
        // Told the same points, JavaFX would paint anew.
        if (!line.getPoints().equals(points)) {
            line.getPoints().setAll(points);
            shade.getPoints().setAll(points);
        }
    }

    private List<Double> points(DrawnPicture picture, int body) {
        PicturePlace place = view.place();
        double[] corners = corners(picture, body);
        List<Double> points = new ArrayList<>();
        for (int i = 0; i < corners.length; i += 2) {
            Point2D corner = place.toView(corners[i], corners[i + 1]);
            points.add(corner.getX());
            points.add(corner.getY());
        }
        return points;
    }

    private static double[] corners(DrawnPicture picture, int body) {
        Scene scene = picture.request().scene();
        if (BodyEdits.isMesh(scene, body)) {
            Mesh mesh = BodyEdits.mesh(scene, body);
            return picture.meshes().holds(mesh)
                    ? MeshOutline.corners(picture.input(), picture.meshes().farPoints(mesh))
                    : new double[0];
        }
        // Nothing is selected, or the plane, or the picture is of the time before the body was there.
        return body == BodyNumber.NONE
                        || body == BodyNumber.PLANE
                        || body >= picture.input().bodyCount()
                ? new double[0]
                : SphereOutline.corners(picture.input(), body, CORNERS);
    }
}
