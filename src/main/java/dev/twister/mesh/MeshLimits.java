package dev.twister.mesh;

/** Limits for the size and content of mesh files. */
final class MeshLimits {
    static final long FILE_BYTES = 1L << 31;
    static final int TRIANGLES = 16_000_000;
    static final int VERTICES = 3 * TRIANGLES;
    static final int POLYGON_CORNERS = 10_000;
    static final int PARTS = 100_000;

    /** Keeps products of three coordinates far from a float's maximum. */
    private static final double COORDINATE = 1e9;

    private MeshLimits() {}

    static boolean areCoordinates(double x, double y, double z) {
        return isCoordinate(x) && isCoordinate(y) && isCoordinate(z);
    }

    static boolean isCoordinate(double value) {
        return Math.abs(value) <= COORDINATE;
    }

    /** More than that come from few bytes only if primitives share them again and again. */
    static long trianglesOf(long bytes) {
        return 100_000 + 16 * bytes;
    }

    static String tooManyTriangles(long count) {
        return count + " triangles; at most " + TRIANGLES + " are read: simplify the mesh or split the file";
    }
}
