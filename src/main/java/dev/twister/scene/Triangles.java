package dev.twister.scene;

import static java.util.Objects.requireNonNull;

import dev.twister.scene.property.Range;

/**
 * Triangles that are made in code, in Twister's axes: x right, y up, z into the picture. Two of them are equal if they
 * are the same object. Scene files cannot have them.
 */
public final class Triangles implements Geometry {
    private static final Range COORDINATE = new Range(-1e9, 1e9);

    private final String name;
    private final float[] positions;
    private final int[] corners;

    private Triangles(String name, float[] positions, int[] corners) {
        this.name = name;
        this.positions = positions;
        this.corners = corners;
    }

    /**
     * Copies the arrays. Triangles without an area are left out when the mesh is rendered.
     *
     * @param name for messages
     * @param positions {@code float[3 * vertices]}, in meters before the mesh's scale
     * @param corners {@code int[3 * triangles]}: the vertices of each triangle, clockwise where its outer side is seen
     * @throws SceneException if a length is no multiple of 3, a coordinate is not from -1e9 to 1e9, or a vertex is not
     *     there; the message says which
     */
    public static Triangles of(String name, float[] positions, int[] corners) {
        requireNonNull(name, "name");
        requireThrees("positions", positions.length);
        requireThrees("corners", corners.length);
        for (int i = 0; i < positions.length; i++) {
            COORDINATE.require("positions[" + i + "]", positions[i]);
        }
        Range vertices = new Range(0, positions.length / 3d - 1);
        for (int i = 0; i < corners.length; i++) {
            vertices.require("corners[" + i + "]", corners[i]);
        }
        return new Triangles(name, positions.clone(), corners.clone());
    }

    private static void requireThrees(String array, int length) {
        if (length == 0 || length % 3 != 0) {
            throw new SceneException(
                    array + " has " + length + " numbers, but must have 3 or a multiple of 3, at least one");
        }
    }

    @Override
    public String name() {
        return name;
    }

    public int vertexCount() {
        return positions.length / 3;
    }

    public int triangleCount() {
        return corners.length / 3;
    }

    /** The position of a vertex, from 0 on. */
    public Vector3 vertex(int number) {
        return new Vector3(positions[3 * number], positions[3 * number + 1], positions[3 * number + 2]);
    }

    /**
     * The vertex at a corner of a triangle.
     *
     * @param corner 0, 1 or 2
     */
    public int corner(int triangle, int corner) {
        return corners[3 * triangle + corner];
    }

    @Override
    public String toString() {
        return name;
    }
}
