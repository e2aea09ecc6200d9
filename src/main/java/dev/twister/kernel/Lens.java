package dev.twister.kernel;

/** A thin lens, which blurs everything outside the plane in focus. */
public final class Lens {
    private Lens() {}

    /**
     * Moves the origin of a view ray to the sample's point on the lens about it, and turns the ray toward the
     * intersection of what was the ray with the plane in focus.
     *
     * @param path {@link Layout#PATH_LENGTH} floats
     */
    public static void bend(float[] path, float[] frame) {
        float radius = frame[Layout.CAMERA_APERTURE] * (float) Math.sqrt(Noise.number(path, Layout.SAMPLE_LENS, frame));
        float turns = Noise.number(path, Layout.SAMPLE_LENS + 1, frame);
        float right = radius * KernelMath.cosineOfTurns(turns);
        float up = radius * KernelMath.sineOfTurns(turns);
        float ahead = path[Layout.DIRECTION] * frame[Layout.CAMERA_FORWARD]
                + path[Layout.DIRECTION + 1] * frame[Layout.CAMERA_FORWARD + 1]
                + path[Layout.DIRECTION + 2] * frame[Layout.CAMERA_FORWARD + 2];
        float distance = frame[Layout.CAMERA_FOCUS] / ahead;
        float lengthSquared = 0f;
        for (int axis = 0; axis < 3; axis++) {
            float away = right * frame[Layout.CAMERA_RIGHT + axis] + up * frame[Layout.CAMERA_UP + axis];
            float direction = distance * path[Layout.DIRECTION + axis] - away;
            path[Layout.ORIGIN + axis] = path[Layout.ORIGIN + axis] + away;
            path[Layout.DIRECTION + axis] = direction;
            lengthSquared = lengthSquared + direction * direction;
        }
        float inverse = KernelMath.inverseRoot(lengthSquared);
        for (int axis = 0; axis < 3; axis++) {
            path[Layout.DIRECTION + axis] = path[Layout.DIRECTION + axis] * inverse;
        }
    }
}
