package dev.twister.mesh;

/** How large a mesh file may be, and what it may hold. */
final class MeshLimits {
    static final long FILE_BYTES = 1L << 31;
    static final int TRIANGLES = 16_000_000;
    static final int VERTICES = 3 * TRIANGLES;
    static final int POLYGON_CORNERS = 10_000;
    static final int PARTS = 100_000;

    /** Products of three coordinates stay far from the end of a float's range. */
    private static final double COORDINATE = 1e9;

    private MeshLimits() {}

    static boolean isCoordinate(double value) {
        return Math.abs(value) <= COORDINATE;
    }

    /** Why a number is no coordinate. */
    static String badCoordinate(double value) {
        return (Double.isFinite(value) ? "the coordinate " + value : "a coordinate that is not a finite number")
                + "; expected numbers from -1e9 to 1e9";
    }

    static String tooManyTriangles(long count) {
        return count + " triangles; at most " + TRIANGLES + " are read: simplify the mesh or split the file";
    }
}
