package dev.twister.mesh;

/**
 * Triangles that share vertices. None is degenerate, and all numbers are finite. The arrays are immutable.
 *
 * @param positions {@code float[3 * vertices]}
 * @param normals {@code float[3 * vertices]}, unit vectors for shading; length 0 for flat triangles
 * @param textureCoordinates {@code float[2 * vertices]}, u to the right and v down from the image's top left; length 0
 *     if there are none; several sets of all vertices may follow one another
 * @param colors {@code float[4 * vertices]}, linear red, green and blue, and opacity, which multiply the material's;
 *     length 0 if there are none
 * @param tangents {@code float[4 * vertices]}, unit vectors to the right on a normal map's image, and the sign of
 *     cross(normal, tangent) toward its upper border; length 0 if the texture coordinates say where that is
 * @param corners {@code int[3 * triangles]}: each triangle's vertices a, b and c, in [0, vertices). (b - a) x (c - a)
 *     points to the file's outer side, or with a mirroring placement to the inner side.
 */
@SuppressWarnings("ArrayRecordComponent") // shared, and compared by identity
public record TriangleMesh(
        float[] positions,
        float[] normals,
        float[] textureCoordinates,
        float[] colors,
        float[] tangents,
        int[] corners) {
    private static final float[] NONE = {};

    /** Without colors and tangents. */
    public TriangleMesh(float[] positions, float[] normals, float[] textureCoordinates, int[] corners) {
        this(positions, normals, textureCoordinates, NONE, NONE, corners);
    }

    public int vertices() {
        return positions.length / 3;
    }

    public int triangles() {
        return corners.length / 3;
    }
}
