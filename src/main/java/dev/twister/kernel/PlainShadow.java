package dev.twister.kernel;

/**
 * Soft shadows by the equations alone: every sample's place by sine and cosine, every sphere by its quadratic's near
 * root. The shortcuts of {@link SoftShadow} are held to it and measured against it; it runs on the JVM only.
 */
final class PlainShadow {
    /** {@code pi * (3 - sqrt 5)} radians. */
    private static final double GOLDEN_ANGLE = 2.399963229728653;

    private PlainShadow() {}

    /** S in [0, 1]: 1 - blocked / samples. */
    static float visible(
            float pointX,
            float pointY,
            float pointZ,
            int own,
            float axisX,
            float axisY,
            float axisZ,
            float lightRadius,
            int samples,
            float[] bodyPositions,
            float[] bodySizes,
            int bodies) {
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
            float toX = bodyPositions[3 * Layout.LIGHT] + wX * y - pointX;
            float toY = bodyPositions[3 * Layout.LIGHT + 1] + uY * x + wY * y - pointY;
            float toZ = bodyPositions[3 * Layout.LIGHT + 2] + uZ * x + wZ * y - pointZ;
            float length = (float) Math.sqrt(toX * toX + toY * toY + toZ * toZ);
            float inverseLength = length > 0f ? 1f / length : 0f;
            int hit = 0;
            for (int body = Layout.FIRST_SPHERE; body < bodies && hit == 0; body++) {
                if (body != own) {
                    float near = Intersection.sphere(
                            bodyPositions[3 * body] - pointX,
                            bodyPositions[3 * body + 1] - pointY,
                            bodyPositions[3 * body + 2] - pointZ,
                            bodySizes[body],
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
}
