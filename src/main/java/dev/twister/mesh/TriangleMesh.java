package dev.twister.mesh;

/**
 * Triangles that share vertices. None is degenerate, and all numbers are finite. The arrays are not changed.
 *
 * @param positions {@code float[3 * vertices]}
 * @param normals {@code float[3 * vertices]}, unit vectors for shading, or of length 0 where triangles are flat
 * @param textureCoordinates {@code float[2 * vertices]}, u to the right and v down from the picture's top left, or of
 *     length 0 where there are none
 * @param corners {@code int[3 * triangles]}: each triangle's vertices, in [0, vertices); with a, b and c, (b - a) x (c
 *     - a) points to the side that the file has as the outer one, in a placement that mirrors to the other
 */
@SuppressWarnings("ArrayRecordComponent") // shared, and compared by identity
public record TriangleMesh(float[] positions, float[] normals, float[] textureCoordinates, int[] corners) {
    public int vertices() {
        return positions.length / 3;
    }

    public int triangles() {
        return corners.length / 3;
    }
}
