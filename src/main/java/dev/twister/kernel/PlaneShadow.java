package dev.twister.kernel;

/** The plane's part of {@link Shadow}: it blocks rays that cross its square between another body and a light sample. */
final class PlaneShadow {
    private PlaneShadow() {}

    /**
     * 1 if the plane may block a shadow ray: the point is on another body, and part of the disc is on the plane's other
     * side.
     *
     * @param path {@link Layout#PATH_LENGTH} floats
     * @param own the body that the point lies on
     * @param discRadius in meters
     */
    static int mayBlock(float[] path, int own, float discRadius, float[] bodies, float[] looks, int variant) {
        float height = bodies[Layout.PLACE_STRIDE * Layout.PLANE + 1];
        float above = path[Layout.POINT + 1] - height;
        float light = Illumination.center(path, 1, bodies, looks, variant) - height;
        float reach = discRadius * Shadow.RELATIVE_MARGIN;
        int below = (above > 0f ? 1 : 0) & (light < reach ? 1 : 0);
        int over = (above < 0f ? 1 : 0) & (light > -reach ? 1 : 0);
        return (own != Layout.PLANE ? 1 : 0) & (below | over);
    }

    /**
     * 1 if the shadow ray to a sample crosses the square. The sample's height is computed relative to the light's
     * center, without loss of precision, for lights at the height of the plane.
     *
     * @param x the sample's position along U, at distance 1
     * @param y the sample's position along W, at distance 1
     */
    static int blocks(float[] path, float x, float y, float[] bodies, float[] looks, int variant) {
        int plane = Layout.PLACE_STRIDE * Layout.PLANE;
        float distance = path[Layout.LIGHT_DISTANCE];
        float above = path[Layout.POINT + 1] - bodies[plane + 1];
        float sampleAbove = Illumination.center(path, 1, bodies, looks, variant)
                - bodies[plane + 1]
                + distance * (path[Layout.DISC_U_Y] * x + path[Layout.DISC_W + 1] * y);
        int blocks = 0;
        if (above * sampleAbove < 0f) {
            float part = above / (above - sampleAbove);
            float toX = Illumination.center(path, 0, bodies, looks, variant)
                    + distance * (path[Layout.DISC_W] * y)
                    - path[Layout.POINT];
            float toZ = Illumination.center(path, 2, bodies, looks, variant)
                    + distance * (path[Layout.DISC_U_Z] * x + path[Layout.DISC_W + 2] * y)
                    - path[Layout.POINT + 2];
            blocks = Intersection.isOnSquare(
                    path[Layout.POINT] + part * toX - bodies[plane],
                    path[Layout.POINT + 2] + part * toZ - bodies[plane + 2],
                    bodies[plane + Layout.PLACE_SIZE]);
        }
        return blocks;
    }
}
