package dev.twister.mesh.shape;

import dev.twister.mesh.shape.ShapeTriangles.Corner;
import dev.twister.scene.Vector3;
import java.util.List;

/** A ball of triangles of nearly one size: an icosahedron whose triangles are each cut into four again and again. */
final class IcosphereTriangles {
    /** 20,480 triangles, whose edges are seen from the center at 2 degrees. */
    private static final int CUTS = 5;

    private static final double GOLDEN = (1 + Math.sqrt(5)) / 2;

    private static final List<Vector3> CORNERS = List.of(
            new Vector3(-1, GOLDEN, 0),
            new Vector3(1, GOLDEN, 0),
            new Vector3(-1, -GOLDEN, 0),
            new Vector3(1, -GOLDEN, 0),
            new Vector3(0, -1, GOLDEN),
            new Vector3(0, 1, GOLDEN),
            new Vector3(0, -1, -GOLDEN),
            new Vector3(0, 1, -GOLDEN),
            new Vector3(GOLDEN, 0, -1),
            new Vector3(GOLDEN, 0, 1),
            new Vector3(-GOLDEN, 0, -1),
            new Vector3(-GOLDEN, 0, 1));

    private static final int[] FACES = {
        0, 11, 5, 0, 5, 1, 0, 1, 7, 0, 7, 10, 0, 10, 11, 1, 5, 9, 5, 11, 4, 11, 10, 2, 10, 7, 6, 7, 1, 8, 3, 9, 4, 3, 4,
        2, 3, 2, 6, 3, 6, 8, 3, 8, 9, 4, 9, 5, 2, 4, 11, 6, 2, 10, 8, 6, 7, 9, 8, 1
    };

    private final ShapeTriangles triangles;

    IcosphereTriangles(ShapeTriangles triangles) {
        this.triangles = triangles;
    }

    /** Adds a ball about the origin, one meter wide. */
    void add() {
        for (int at = 0; at < FACES.length; at += 3) {
            add(unit(FACES[at]), unit(FACES[at + 1]), unit(FACES[at + 2]), CUTS);
        }
    }

    private static Vector3 unit(int corner) {
        return CORNERS.get(corner).normalized();
    }

    private void add(Vector3 a, Vector3 b, Vector3 c, int cuts) {
        if (cuts == 0) {
            double seam = u(a.plus(b).plus(c));
            triangles.triangle(vertex(a, seam), vertex(b, seam), vertex(c, seam));
        } else {
            Vector3 ab = a.plus(b).normalized();
            Vector3 bc = b.plus(c).normalized();
            Vector3 ca = c.plus(a).normalized();
            add(a, ab, ca, cuts - 1);
            add(ab, b, bc, cuts - 1);
            add(ca, bc, c, cuts - 1);
            add(ab, bc, ca, cuts - 1);
        }
    }

    /** @param middle u in the middle of the triangle, from which no corner is a half turn away */
    private int vertex(Vector3 normal, double middle) {
        boolean pole = Math.hypot(normal.x(), normal.z()) < 1e-9;
        double u = pole ? middle : u(normal) + Math.rint(middle - u(normal));
        return triangles.vertex(new Corner(
                normal.times(0.5), normal, u, 0.5 - Math.asin(Math.clamp(normal.y(), -1.0, 1.0)) / Math.PI));
    }

    private static double u(Vector3 direction) {
        return 0.5 + Math.atan2(direction.x(), -direction.z()) / (2 * Math.PI);
    }
}
