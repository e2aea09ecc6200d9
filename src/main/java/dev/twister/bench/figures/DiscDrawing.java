package dev.twister.bench.figures;

import java.util.Locale;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/** Draws the light's disc as seen from a surface point, with the targets of its shadow rays. */
final class DiscDrawing {
    /** Side of the square drawing, in pixels. */
    static final int SIDE = 360;

    private static final double RADIUS = 165;
    private static final double LARGEST_DOT = 9;

    private DiscDrawing() {}

    /**
     * An SVG document.
     *
     * @param json of {@code twister explain --json}; its first step has shadow rays, the first of them to the disc's
     *     center
     * @param discRadius in meters
     */
    static String svg(String json, double discRadius) {
        JsonNode surface =
                JsonMapper.shared().readTree(json).get("steps").get(0).get("surface");
        JsonNode rays = surface.get("shadowRays");
        double[] axis = vector(surface.get("toLight"));
        double across = Math.hypot(axis[1], axis[2]);
        double[] u = {0, axis[2] / across, -axis[1] / across};
        double[] w = cross(u, axis);
        double[] center = vector(rays.get(0).get("target"));
        double dot = Math.min(LARGEST_DOT, 2 * LARGEST_DOT * Math.pow(rays.size(), -0.28));
        StringBuilder svg = new StringBuilder();
        svg.append("""
                <svg xmlns="http://www.w3.org/2000/svg" width="360" height="360" viewBox="0 0 360 360">
                <rect width="360" height="360" fill="#22262e"/>
                <circle cx="180" cy="180" r="165" fill="none" stroke="#8a93a6" stroke-width="2"/>
                """);
        for (JsonNode ray : rays) {
            double[] target = vector(ray.get("target"));
            double[] away = {target[0] - center[0], target[1] - center[1], target[2] - center[2]};
            svg.append(String.format(
                    Locale.ROOT,
                    "<circle cx=\"%.1f\" cy=\"%.1f\" r=\"%.1f\" fill=\"%s\"/>\n",
                    SIDE / 2.0 + RADIUS * dot(away, u) / discRadius,
                    SIDE / 2.0 - RADIUS * dot(away, w) / discRadius,
                    dot,
                    ray.get("light").doubleValue() > 0 ? "#ffd34d" : "#6b7280"));
        }
        return svg.append("</svg>\n").toString();
    }

    private static double[] vector(JsonNode node) {
        return new double[] {
            node.get(0).doubleValue(), node.get(1).doubleValue(), node.get(2).doubleValue()
        };
    }

    private static double dot(double[] a, double[] b) {
        return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    }

    private static double[] cross(double[] a, double[] b) {
        return new double[] {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
    }
}
