package dev.twister.gui.picture;

import dev.twister.explain.PathStep;
import dev.twister.explain.PathStep.LightSample;
import dev.twister.explain.PathStep.ShadedSurface;
import dev.twister.explain.PixelPath;
import dev.twister.gui.edit.BodyNumber;
import dev.twister.scene.Rgb;
import dev.twister.scene.Vector3;
import java.util.ArrayList;
import java.util.List;

/** The lines that show a pixel's path in the scene. */
public final class PathLines {
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
        return step.body() == BodyNumber.NONE ? TO_THE_SKY : step.distance();
    }

    private static Vector3 along(Vector3 from, Vector3 direction, double meters) {
        return from.plus(direction.times(meters));
    }
}
