package dev.twister.world;

/**
 * Vogel's sunflower: points spread evenly over the unit disc (Vogel 1979), which the kernel scales to the light's disc.
 */
final class SunflowerDisc {
    private static final double GOLDEN_ANGLE_RADIANS = Math.PI * (3 - Math.sqrt(5));

    private SunflowerDisc() {}

    /**
     * {@code 2 * count} floats: x and y of {@code sqrt(i / n) * (cos, sin)(i * golden angle)}, i from 0. The first
     * point is the center, so one sample gives a hard shadow.
     */
    static float[] points(int count) {
        float[] points = new float[2 * count];
        for (int i = 0; i < count; i++) {
            double distance = Math.sqrt((double) i / count);
            points[2 * i] = (float) (distance * Math.cos(i * GOLDEN_ANGLE_RADIANS));
            points[2 * i + 1] = (float) (distance * Math.sin(i * GOLDEN_ANGLE_RADIANS));
        }
        return points;
    }
}
