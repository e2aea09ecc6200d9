package dev.twister.mesh.shape;

import dev.twister.mesh.shape.ShapeTriangles.Corner;
import dev.twister.scene.Vector3;

/** Surfaces that a line sweeps in a full turn about the y axis. Texture coordinates are a sphere's around the axis. */
final class TurnedTriangles {
    /** Steps of a turn: the outline of a round shape is off by 0.03 % of its radius. */
    static final int STEPS = 128;

    private final ShapeTriangles triangles;

    /**
     * A circle about the axis.
     *
     * @param radius 0 for a point
     * @param outward of the unit normal, away from the axis
     * @param upward of the unit normal, along the axis
     * @param v downward in the texture
     */
    record Ring(double radius, double y, double outward, double upward, double v) {
        /** @param step in [0, {@link #STEPS}], whole at vertices of the circle */
        Corner at(double step) {
            // The last place is exactly the first one.
            double turn = 2 * Math.PI * (step % STEPS / STEPS - 0.5);
            double x = Math.sin(turn);
            double z = -Math.cos(turn);
            return new Corner(
                    new Vector3(radius * x, y, radius * z),
                    new Vector3(outward * x, upward, outward * z),
                    step / STEPS,
                    v);
        }
    }

    TurnedTriangles(ShapeTriangles triangles) {
        this.triangles = triangles;
    }

    /** Adds the surface between two rings, of which the upper one comes first where the outer side is seen. */
    void band(Ring upper, Ring lower) {
        int[] above = vertices(upper);
        int[] below = vertices(lower);
        for (int step = 0; step < STEPS; step++) {
            triangles.triangle(above[step], above[step + 1], below[step + 1]);
            triangles.triangle(above[step], below[step + 1], below[step]);
        }
    }

    private int[] vertices(Ring ring) {
        int[] vertices = new int[STEPS + 1];
        for (int step = 0; step <= STEPS; step++) {
            vertices[step] = triangles.vertex(ring.at(step));
        }
        return vertices;
    }

    /** Adds the surface between a tip, whose normal is turned along, and a ring below it. */
    void tip(Ring tip, Ring lower) {
        int[] below = vertices(lower);
        for (int step = 0; step < STEPS; step++) {
            triangles.triangle(triangles.vertex(tip.at(step + 0.5)), below[step + 1], below[step]);
        }
    }

    /**
     * Adds a disc with the middle of the texture.
     *
     * @param upward 1 for a disc that is seen from above, -1 for one that is seen from below
     */
    void disc(double radius, double y, int upward) {
        Vector3 normal = new Vector3(0, upward, 0);
        int center = triangles.vertex(new Corner(new Vector3(0, y, 0), normal, 0.5, 0.5));
        Ring rim = new Ring(radius, y, 0, upward, 0);
        int[] vertices = new int[STEPS + 1];
        for (int step = 0; step <= STEPS; step++) {
            Vector3 place = rim.at(step).position();
            vertices[step] = triangles.vertex(
                    new Corner(place, normal, 0.5 + 0.5 * place.x() / radius, 0.5 - 0.5 * upward * place.z() / radius));
        }
        for (int step = 0; step < STEPS; step++) {
            triangles.triangle(center, vertices[upward > 0 ? step + 1 : step], vertices[upward > 0 ? step : step + 1]);
        }
    }
}
