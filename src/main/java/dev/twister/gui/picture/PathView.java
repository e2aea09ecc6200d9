package dev.twister.gui.picture;

import dev.twister.explain.PathStep;
import dev.twister.explain.PathStep.LightSample;
import dev.twister.explain.PathStep.ShadedSurface;
import dev.twister.explain.PixelPath;
import dev.twister.gui.drawing.DrawnPicture;
import dev.twister.gui.picking.Projection;
import dev.twister.gui.picture.PathView.PathLines.Kind;
import dev.twister.gui.picture.PathView.PathLines.Line;
import dev.twister.gui.picture.PictureView.PicturePlace;
import dev.twister.gui.studio.Studio;
import dev.twister.scene.Rgb;
import dev.twister.scene.Vector3;
import java.util.ArrayList;
import java.util.List;
import javafx.geometry.Point2D;
import javafx.scene.canvas.Canvas;
import javafx.scene.canvas.GraphicsContext;
import javafx.scene.layout.Pane;
import javafx.scene.paint.Color;

/** A pixel's path as lines over the picture: view ray, reflected and refracted rays, normals, shadow rays. */
public final class PathView extends Pane {
    private static final double DOT = 7;
    private static final double WIDTH = 2;
    private static final double THIN = 0.7;
    private static final Color SHADE = Color.web("#000000a0");

    private final PictureView view;
    private final Studio studio;
    private final Canvas canvas = new Canvas();
    private List<Line> lines = List.of();

    public PathView(PictureView view, Studio studio, PathPick pick) {
        this.view = view;
        this.studio = studio;
        setMouseTransparent(true);
        getChildren().add(canvas);
        pick.pathProperty().subscribe(path -> {
            lines = path.map(PathLines::of).orElse(List.of());
            setVisible(path.isPresent());
            draw();
        });
        studio.pictureProperty().subscribe(_ -> draw());
        view.image().boundsInParentProperty().subscribe(_ -> draw());
        layoutBoundsProperty().subscribe(_ -> draw());
    }

    private void draw() {
        if (lines.isEmpty()) {
            // A canvas of the picture's size takes memory.
            canvas.setWidth(0);
            canvas.setHeight(0);
        } else {
            canvas.setWidth(getWidth());
            canvas.setHeight(getHeight());
            studio.pictureProperty().get().ifPresent(this::draw);
        }
    }

    private void draw(DrawnPicture picture) {
        GraphicsContext pen = canvas.getGraphicsContext2D();
        pen.clearRect(0, 0, canvas.getWidth(), canvas.getHeight());
        Projection projection = Projection.of(picture.input());
        PicturePlace place = view.place();
        for (Line line : lines) {
            double[] ends = projection.line(line.from(), line.to());
            if (ends.length > 0) {
                draw(pen, line.kind(), place.toView(ends[0], ends[1]), place.toView(ends[2], ends[3]));
            }
        }
    }

    private static void draw(GraphicsContext pen, Kind kind, Point2D from, Point2D to) {
        boolean shadow = kind == Kind.LIT || kind == Kind.DIMMED || kind == Kind.BLOCKED;
        if (!shadow) {
            stroke(pen, SHADE, WIDTH + 2, from, to);
        }
        stroke(pen, color(kind), shadow ? THIN : WIDTH, from, to);
        if (!shadow && kind != Kind.NORMAL) {
            pen.setFill(SHADE);
            pen.fillOval(to.getX() - DOT / 2 - 1, to.getY() - DOT / 2 - 1, DOT + 2, DOT + 2);
            pen.setFill(color(kind));
            pen.fillOval(to.getX() - DOT / 2, to.getY() - DOT / 2, DOT, DOT);
        }
    }

    private static void stroke(GraphicsContext pen, Color color, double width, Point2D from, Point2D to) {
        pen.setStroke(color);
        pen.setLineWidth(width);
        pen.strokeLine(from.getX(), from.getY(), to.getX(), to.getY());
    }

    static Color color(Kind kind) {
        return switch (kind) {
            case VIEW -> Color.web("#ffffff");
            case REFLECTED -> Color.web("#ffd24a");
            case REFRACTED -> Color.web("#5bc8ff");
            case SCATTERED -> Color.web("#ff9a5c");
            case NORMAL -> Color.web("#d58bff");
            case LIT -> Color.web("#40e060b0");
            case DIMMED -> Color.web("#c0d040b0");
            case BLOCKED -> Color.web("#ff4040b0");
        };
    }

    /** The lines that show a pixel's path in the scene. */
    static final class PathLines {
        /** Of a ray that meets nothing, in meters. */
        private static final double TO_THE_SKY = 200;

        /** Of a normal, as a share of the view ray. */
        private static final double NORMAL_LENGTH = 0.06;

        private static final Rgb DARK = new Rgb(0, 0, 0);

        private PathLines() {}

        /** What a line is. */
        public enum Kind {
            VIEW,
            REFLECTED,
            REFRACTED,
            /** By a matte surface, in path tracing. */
            SCATTERED,
            NORMAL,
            /** A shadow ray along which all light comes. */
            LIT,
            /** One that a transparent body dims. */
            DIMMED,
            BLOCKED
        }

        /** A line in the scene's meters. */
        public record Line(Kind kind, Vector3 from, Vector3 to) {}

        /** Shadow rays first, so that what is drawn later lies over them. */
        public static List<Line> of(PixelPath path) {
            List<Line> lines = new ArrayList<>();
            for (PathStep step : path.steps()) {
                step.shading()
                        .ifPresent(shading -> shading.lights().stream()
                                .flatMap(light -> light.shadowRays().stream())
                                .forEach(ray -> lines.add(shadow(shading, ray))));
            }
            double normal = NORMAL_LENGTH * length(path.steps().getFirst());
            for (PathStep step : path.steps()) {
                lines.add(new Line(kind(step), step.origin(), along(step.origin(), step.direction(), length(step))));
                step.shading().ifPresent(shading -> lines.add(normal(shading.point(), shading.normal(), normal)));
                step.scattering().ifPresent(surface -> lines.add(normal(surface.point(), surface.normal(), normal)));
            }
            return lines;
        }

        private static Line normal(Vector3 point, Vector3 normal, double length) {
            return new Line(Kind.NORMAL, point, along(point, normal, length));
        }

        private static Line shadow(ShadedSurface shading, LightSample ray) {
            Kind kind = ray.light() == 0 ? Kind.BLOCKED : ray.light() < 1 ? Kind.DIMMED : Kind.LIT;
            return new Line(kind, shading.point(), ray.target());
        }

        private static Kind kind(PathStep step) {
            return switch (step.kind()) {
                case VIEW -> Kind.VIEW;
                case REFLECTED -> Kind.REFLECTED;
                case REFRACTED -> Kind.REFRACTED;
                case SCATTERED -> Kind.SCATTERED;
                case EMITTER -> step.adds().equals(DARK) ? Kind.BLOCKED : Kind.LIT;
            };
        }

        private static double length(PathStep step) {
            return step.distance() == 0 ? TO_THE_SKY : step.distance();
        }

        private static Vector3 along(Vector3 from, Vector3 direction, double meters) {
            return from.plus(direction.times(meters));
        }
    }
}
