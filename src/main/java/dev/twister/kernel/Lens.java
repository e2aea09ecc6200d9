package dev.twister.kernel;

/** A thin lens, which blurs everything outside the plane in focus. */
public final class Lens {
    private Lens() {}

    /**
     * Moves the origin of a pinhole camera's view ray to the sample's point on the lens, and turns the ray toward the
     * pinhole ray's intersection with the plane in focus.
     *
     * @param path {@link Layout#PATH_LENGTH} floats
     * @param camera {@link Layout#CAMERA_LENGTH} floats, with an aperture above 0
     * @param pixelSamples {@link Layout#SAMPLE_STRIDE} floats per sample
     */
    public static void bend(float[] path, float[] camera, float[] pixelSamples) {
        float radius = camera[Layout.CAMERA_APERTURE]
                * (float) Math.sqrt(Noise.number(path, pixelSamples, Layout.SAMPLE_LENS));
        float turns = Noise.number(path, pixelSamples, Layout.SAMPLE_LENS + 1);
        float right = radius * KernelMath.cosineOfTurns(turns);
        float up = radius * KernelMath.sineOfTurns(turns);
        float ahead = path[Layout.DIRECTION] * camera[Layout.CAMERA_FORWARD]
                + path[Layout.DIRECTION + 1] * camera[Layout.CAMERA_FORWARD + 1]
                + path[Layout.DIRECTION + 2] * camera[Layout.CAMERA_FORWARD + 2];
        float distance = camera[Layout.CAMERA_FOCUS] / ahead;
        float lengthSquared = 0f;
        for (int axis = 0; axis < 3; axis++) {
            float away = right * camera[Layout.CAMERA_RIGHT + axis] + up * camera[Layout.CAMERA_UP + axis];
            float direction = distance * path[Layout.DIRECTION + axis] - away;
            path[Layout.ORIGIN + axis] = camera[Layout.CAMERA_POSITION + axis] + away;
            path[Layout.DIRECTION + axis] = direction;
            lengthSquared = lengthSquared + direction * direction;
        }
        float inverse = KernelMath.inverseRoot(lengthSquared);
        for (int axis = 0; axis < 3; axis++) {
            path[Layout.DIRECTION + axis] = path[Layout.DIRECTION + axis] * inverse;
        }
    }
}
