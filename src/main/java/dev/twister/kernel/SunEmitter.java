package dev.twister.kernel;

/** A sun: parallel light from a disc that is infinitely far away. */
public final class SunEmitter {
    /** Least sine of the angle that a sun's radius fills, as a sharp one would have an infinite radiance. */
    public static final float LEAST_SINE = 0x1p-30f;

    private SunEmitter() {}

    /** Place in {@code looks} of the first sun's emitter. */
    public static int first(float[] frame) {
        int far = (int) frame[Layout.SUNS] + (frame[Layout.SKY_EMITTER] > 0f ? 1 : 0);
        return (int) frame[Layout.EMITTER_TABLE] + Layout.EMITTER_STRIDE * ((int) frame[Layout.EMITTERS] - far);
    }

    /** Writes a direction of the cone that a sun's disc fills, and what {@link Emitter#choose} writes. */
    static void choose(float[] path, int body, float first, float second, float[] looks) {
        int look = Layout.LOOK_STRIDE * body;
        float cone = cone(looks[look + Layout.LOOK_SUN_SINE]);
        float below = first * cone;
        float sine = (float) Math.sqrt(Math.max(below * (2f - below), 0f));
        TangentFrame.write(
                path,
                Layout.TO_LIGHT,
                -looks[look + Layout.LOOK_SPOT_AXIS],
                -looks[look + Layout.LOOK_SPOT_AXIS + 1],
                -looks[look + Layout.LOOK_SPOT_AXIS + 2],
                sine * KernelMath.cosineOfTurns(second),
                sine * KernelMath.sineOfTurns(second),
                1f - below);
        path[Layout.LIGHT_DISTANCE] = Intersection.MISS;
        path[Layout.LIGHT_DENSITY] = coneDensity(cone);
    }

    /** 1 if the path's ray, which has met no body, goes to a sun's disc, else 0. */
    public static int isMet(float[] path, int body, float[] looks) {
        int look = Layout.LOOK_STRIDE * body;
        float x = -looks[look + Layout.LOOK_SPOT_AXIS];
        float y = -looks[look + Layout.LOOK_SPOT_AXIS + 1];
        float z = -looks[look + Layout.LOOK_SPOT_AXIS + 2];
        float sine = looks[look + Layout.LOOK_SUN_SINE];
        float directionX = path[Layout.DIRECTION];
        float directionY = path[Layout.DIRECTION + 1];
        float directionZ = path[Layout.DIRECTION + 2];
        float along = directionX * x + directionY * y + directionZ * z;
        // Of a small angle the sine is more exact than the cosine.
        float acrossX = directionY * z - directionZ * y;
        float acrossY = directionZ * x - directionX * z;
        float acrossZ = directionX * y - directionY * x;
        float across = acrossX * acrossX + acrossY * acrossY + acrossZ * acrossZ;
        return (along > 0f ? 1 : 0) & (across < sine * sine ? 1 : 0);
    }

    /**
     * Density per steradian with which {@link Emitter#choose} takes a direction of a sun's disc.
     *
     * @param emitter its place in {@code looks}
     */
    public static float density(int emitter, float[] looks) {
        int body = (int) looks[emitter + Layout.EMITTER_BODY];
        float sine = looks[Layout.LOOK_STRIDE * body + Layout.LOOK_SUN_SINE];
        return looks[emitter + Layout.EMITTER_PROBABILITY] * coneDensity(cone(sine));
    }

    /** {@code 1 - cos} of the angle that the disc's radius fills. */
    private static float cone(float discSine) {
        float sine = Math.max(discSine, LEAST_SINE);
        return sine * sine / (1f + (float) Math.sqrt(1f - sine * sine));
    }

    private static float coneDensity(float cone) {
        return 1f / (2f * KernelMath.PI * cone);
    }
}
