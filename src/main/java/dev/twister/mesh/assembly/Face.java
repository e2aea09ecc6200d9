package dev.twister.mesh.assembly;

/** The plane of a triangle; a mutable object that is reused for many triangles. */
final class Face {
    private double x;
    private double y;
    private double z;

    double x() {
        return x;
    }

    double y() {
        return y;
    }

    double z() {
        return z;
    }

    /**
     * Computes the plane of the triangle with these vertices. Its unit normal points to the side from which the corners
     * appear counterclockwise in right-handed axes.
     *
     * @return whether the triangle has an area that floats can distinguish from 0
     */
    boolean set(float[] positions, int a, int b, int c) {
        double ax = positions[3 * a];
        double ay = positions[3 * a + 1];
        double az = positions[3 * a + 2];
        double ux = positions[3 * b] - ax;
        double uy = positions[3 * b + 1] - ay;
        double uz = positions[3 * b + 2] - az;
        double vx = positions[3 * c] - ax;
        double vy = positions[3 * c + 1] - ay;
        double vz = positions[3 * c + 2] - az;
        double nx = uy * vz - uz * vy;
        double ny = uz * vx - ux * vz;
        double nz = ux * vy - uy * vx;
        double length = Math.sqrt(nx * nx + ny * ny + nz * nz);
        x = nx / length;
        y = ny / length;
        z = nz / length;
        return length >= Float.MIN_NORMAL;
    }
}
