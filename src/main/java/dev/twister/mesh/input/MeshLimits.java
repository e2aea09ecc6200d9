package dev.twister.mesh.input;

/** Limits for the size and content of mesh files. */
public final class MeshLimits {
    public static final long FILE_BYTES = 1L << 31;
    public static final int TRIANGLES = 16_000_000;
    public static final int VERTICES = 3 * TRIANGLES;
    public static final int POLYGON_CORNERS = 10_000;
    public static final int PARTS = 100_000;

    /** Keeps products of three coordinates far from a float's maximum. */
    private static final double COORDINATE = 1e9;

    private MeshLimits() {}

    public static boolean areCoordinates(double x, double y, double z) {
        return isCoordinate(x) && isCoordinate(y) && isCoordinate(z);
    }

    public static boolean isCoordinate(double value) {
        return Math.abs(value) <= COORDINATE;
    }

    /** More than that come from few bytes only if primitives share them again and again. */
    public static long trianglesOf(long bytes) {
        return 100_000 + 16 * bytes;
    }

    public static String tooManyTriangles(long count) {
        return count + " triangles; at most " + TRIANGLES + " are read: simplify the mesh or split the file";
    }
}
