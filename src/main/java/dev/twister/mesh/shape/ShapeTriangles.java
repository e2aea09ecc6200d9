package dev.twister.mesh.shape;

import dev.twister.mesh.TriangleMesh;
import dev.twister.mesh.assembly.FloatList;
import dev.twister.mesh.assembly.IntList;
import dev.twister.scene.Vector3;

/** Triangles of a shape with normals and texture coordinates, in Twister's axes. */
final class ShapeTriangles {
    /** A corner: where it is, the unit normal there, and the texture coordinates with v down. */
    record Corner(Vector3 position, Vector3 normal, double u, double v) {}

    private final FloatList positions = new FloatList();
    private final FloatList normals = new FloatList();
    private final FloatList textureCoordinates = new FloatList();
    private final IntList corners = new IntList();

    /** Adds a vertex and returns its number. */
    int vertex(Corner corner) {
        add(positions, corner.position());
        add(normals, corner.normal());
        textureCoordinates.add((float) corner.u());
        textureCoordinates.add((float) corner.v());
        return positions.size() / 3 - 1;
    }

    private static void add(FloatList floats, Vector3 vector) {
        floats.add((float) vector.x());
        floats.add((float) vector.y());
        floats.add((float) vector.z());
    }

    /** Adds a triangle of three vertices, clockwise where its outer side is seen. */
    void triangle(int a, int b, int c) {
        corners.add(a);
        corners.add(b);
        corners.add(c);
    }

    /**
     * Adds a rectangle with the whole texture.
     *
     * @param center its middle
     * @param right from its middle to its right edge, where its outer side is seen
     * @param up from its middle to its upper edge, likewise
     */
    void rectangle(Vector3 center, Vector3 right, Vector3 up) {
        Vector3 normal = up.cross(right).normalized();
        Vector3 upper = center.plus(up);
        Vector3 lower = center.minus(up);
        int a = vertex(new Corner(upper.minus(right), normal, 0, 0));
        int b = vertex(new Corner(upper.plus(right), normal, 1, 0));
        int c = vertex(new Corner(lower.plus(right), normal, 1, 1));
        int d = vertex(new Corner(lower.minus(right), normal, 0, 1));
        triangle(a, b, c);
        triangle(a, c, d);
    }

    TriangleMesh mesh() {
        return new TriangleMesh(
                positions.toArray(), normals.toArray(), textureCoordinates.toArray(), corners.toArray());
    }
}
