package dev.twister.kernel;

/** Directions given in a frame about an axis. */
final class TangentFrame {
    private TangentFrame() {}

    /**
     * Writes a direction given in the frame of a unit vector N (Duff et al., "Building an Orthonormal Basis,
     * Revisited", 2017).
     *
     * @param at place of three floats in the path
     * @param x component along the first tangent
     * @param y component along the second tangent
     * @param z component along N
     */
    static void write(float[] path, int at, float normalX, float normalY, float normalZ, float x, float y, float z) {
        float sign = normalZ < 0f ? -1f : 1f;
        float a = -1f / (sign + normalZ);
        float b = normalX * normalY * a;
        path[at] = x * (1f + sign * normalX * normalX * a) + y * b + z * normalX;
        path[at + 1] = x * sign * b + y * (sign + normalY * normalY * a) + z * normalY;
        path[at + 2] = -x * sign * normalX - y * normalY + z * normalZ;
    }
}
