package dev.twister.kernel;

/**
 * Soft shadows by the equations alone: sample positions by sine and cosine, spheres by the near root of the quadratic,
 * the plane by the sides that point and sample are on. Reference for the shortcuts of {@link Shadow}.
 */
public final class PlainShadow {
    /** {@code pi * (3 - sqrt 5)} radians. */
    private static final double GOLDEN_ANGLE = 2.399963229728653;

    private PlainShadow() {}

    /** Returns the visibility in [0, 1] at {@link Layout#POINT}: 1 - blocked / samples. */
    public static float visible(float[] path, int own, int samples, float[] places, int bodies) {
        float pointX = path[Layout.POINT];
        float pointY = path[Layout.POINT + 1];
        float pointZ = path[Layout.POINT + 2];
        float axisX = path[Layout.TO_LIGHT];
        float axisY = path[Layout.TO_LIGHT + 1];
        float axisZ = path[Layout.TO_LIGHT + 2];
        int light = Layout.PLACE_STRIDE * Layout.LIGHT;
        float lightRadius = places[light + Layout.PLACE_SIZE];
        int alongX = (axisY == 0f ? 1 : 0) & (axisZ == 0f ? 1 : 0);
        float uY = alongX != 0 ? 0f : axisZ;
        float uZ = alongX != 0 ? axisX : -axisY;
        float inverse = KernelMath.inverseRoot(uY * uY + uZ * uZ);
        uY = uY * inverse;
        uZ = uZ * inverse;
        float wX = uY * axisZ - uZ * axisY;
        float wY = uZ * axisX;
        float wZ = -uY * axisX;
        int blocked = 0;
        for (int sample = 0; sample < samples; sample++) {
            float distance = 2f * lightRadius * (float) Math.sqrt((double) sample / samples);
            float x = distance * (float) Math.cos(sample * GOLDEN_ANGLE);
            float y = distance * (float) Math.sin(sample * GOLDEN_ANGLE);
            float toX = places[light] + wX * y - pointX;
            float toY = places[light + 1] + uY * x + wY * y - pointY;
            float toZ = places[light + 2] + uZ * x + wZ * y - pointZ;
            float length = (float) Math.sqrt(toX * toX + toY * toY + toZ * toZ);
            float inverseLength = length > 0f ? 1f / length : 0f;
            int hit = own != Layout.PLANE ? hitsPlane(pointX, pointY, pointZ, toX, toY, toZ, places) : 0;
            for (int body = Layout.FIRST_SPHERE; body < bodies && hit == 0; body++) {
                if (body != own) {
                    int place = Layout.PLACE_STRIDE * body;
                    float near = Intersection.sphere(
                            places[place] - pointX,
                            places[place + 1] - pointY,
                            places[place + 2] - pointZ,
                            places[place + Layout.PLACE_SIZE],
                            toX * inverseLength,
                            toY * inverseLength,
                            toZ * inverseLength);
                    hit = near < length ? 1 : 0;
                }
            }
            blocked = blocked + hit;
        }
        return 1f - (float) blocked / samples;
    }

    private static int hitsPlane(float x, float y, float z, float toX, float toY, float toZ, float[] places) {
        int plane = Layout.PLACE_STRIDE * Layout.PLANE;
        float above = y - places[plane + 1];
        int hit = 0;
        if (above * (above + toY) < 0f) {
            float part = -above / toY;
            hit = Intersection.isOnSquare(
                    x + part * toX - places[plane],
                    z + part * toZ - places[plane + 2],
                    places[plane + Layout.PLACE_SIZE]);
        }
        return hit;
    }
}
