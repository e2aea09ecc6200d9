package dev.twister.oracle;

import dev.twister.mesh.TriangleMesh;
import dev.twister.scene.Vector3;

/** A tube along a (2, 3) torus knot, with the smooth tube's normals. */
final class TorusKnot {
    private static final double TUBE = 0.34;
    private static final double SCALE = 0.75;
    private static final double HEIGHT = 2.55;

    private TorusKnot() {}

    static TriangleMesh mesh(int rings, int sides) {
        float[] positions = new float[3 * rings * sides];
        float[] normals = new float[positions.length];
        int[] corners = new int[6 * rings * sides];
        for (int ring = 0; ring < rings; ring++) {
            double turn = 2 * Math.PI * ring / rings;
            Vector3 place = place(turn);
            Vector3 tangent = place(turn + 1e-4).minus(place(turn - 1e-4)).normalized();
            Vector3 side = tangent.cross(new Vector3(place.x(), place.y(), 0)).normalized();
            Vector3 up = side.cross(tangent);
            for (int i = 0; i < sides; i++) {
                double angle = 2 * Math.PI * i / sides;
                Vector3 normal = side.times(Math.cos(angle)).plus(up.times(Math.sin(angle)));
                int vertex = ring * sides + i;
                put(normals, vertex, normal);
                put(positions, vertex, place.plus(normal.times(TUBE)).plus(new Vector3(0, HEIGHT, 0)));
                int next = ring * sides + (i + 1) % sides;
                int beyond = (ring + 1) % rings * sides;
                int[] quad = {vertex, beyond + (i + 1) % sides, beyond + i, vertex, next, beyond + (i + 1) % sides};
                System.arraycopy(quad, 0, corners, 6 * vertex, 6);
            }
        }
        return new TriangleMesh(positions, normals, new float[0], corners);
    }

    private static Vector3 place(double turn) {
        double radius = 2 + Math.cos(3 * turn);
        return new Vector3(radius * Math.cos(2 * turn), radius * Math.sin(2 * turn), Math.sin(3 * turn)).times(SCALE);
    }

    private static void put(float[] floats, int vertex, Vector3 vector) {
        floats[3 * vertex] = (float) vector.x();
        floats[3 * vertex + 1] = (float) vector.y();
        floats[3 * vertex + 2] = (float) vector.z();
    }
}
