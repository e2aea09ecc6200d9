package dev.twister.kernel;

/** A sphere that emits outward: a light, or a sphere with emission. */
final class SphereEmitter {
    /** Directions through a sphere whose cone is narrower are not sampled: rounding would decide whether they hit. */
    private static final float LEAST_CONE = 1e-14f;

    private SphereEmitter() {}

    /**
     * Writes a direction of the cone that a sphere fills (Shirley, Wang and Zimmerman 1996), and what
     * {@link Emitter#choose} writes; from inside the density is 0.
     */
    static void choose(float[] path, int body, float first, float second, float[] bodies) {
        float x = bodies[Layout.PLACE_STRIDE * body] - path[Layout.POINT];
        float y = bodies[Layout.PLACE_STRIDE * body + 1] - path[Layout.POINT + 1];
        float z = bodies[Layout.PLACE_STRIDE * body + 2] - path[Layout.POINT + 2];
        float radius = bodies[Layout.PLACE_STRIDE * body + Layout.PLACE_SIZE];
        float cone = cone(x * x + y * y + z * z, radius);
        float inverse = KernelMath.inverseRoot(x * x + y * y + z * z);
        float below = first * cone;
        float sine = (float) Math.sqrt(Math.max(below * (2f - below), 0f));
        TangentFrame.write(
                path,
                Layout.TO_LIGHT,
                x * inverse,
                y * inverse,
                z * inverse,
                sine * KernelMath.cosineOfTurns(second),
                sine * KernelMath.sineOfTurns(second),
                1f - below);
        float distance = Intersection.sphere(
                x, y, z, radius, path[Layout.TO_LIGHT], path[Layout.TO_LIGHT + 1], path[Layout.TO_LIGHT + 2]);
        int met = (cone > LEAST_CONE ? 1 : 0) & (distance < Intersection.MISS ? 1 : 0);
        path[Layout.LIGHT_DISTANCE] = distance;
        path[Layout.LIGHT_DENSITY] = met != 0 ? coneDensity(cone) : 0f;
    }

    /** {@code 1 - cos} of the half angle of the cone that a sphere fills; 0 from inside. */
    private static float cone(float distanceSquared, float radius) {
        float sineSquared = radius * radius / Math.max(distanceSquared, 1e-30f);
        return sineSquared < 1f ? sineSquared / (1f + (float) Math.sqrt(1f - sineSquared)) : 0f;
    }

    private static float coneDensity(float cone) {
        return 1f / (2f * KernelMath.PI * cone);
    }

    /** Density per steradian of the direction of the path's ray. */
    static float density(float[] path, int body, float[] bodies) {
        float x = bodies[Layout.PLACE_STRIDE * body] - path[Layout.ORIGIN];
        float y = bodies[Layout.PLACE_STRIDE * body + 1] - path[Layout.ORIGIN + 1];
        float z = bodies[Layout.PLACE_STRIDE * body + 2] - path[Layout.ORIGIN + 2];
        float radius = bodies[Layout.PLACE_STRIDE * body + Layout.PLACE_SIZE];
        float cone = cone(x * x + y * y + z * z, radius);
        return cone > LEAST_CONE ? coneDensity(cone) : 0f;
    }
}
