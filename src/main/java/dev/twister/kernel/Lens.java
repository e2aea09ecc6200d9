package dev.twister.kernel;

/** A thin lens: what is not at the focus distance is seen from each of its points elsewhere. */
public final class Lens {
    private Lens() {}

    /**
     * Moves the start of a pinhole's view ray to the sample's point of the lens, and turns the ray to where the
     * pinhole's meets the plane that is sharp.
     *
     * @param path {@link Layout#PATH_LENGTH} floats
     * @param camera {@link Layout#CAMERA_LENGTH} floats, its aperture above 0
     * @param pixelSamples {@link Layout#SAMPLE_STRIDE} floats a sample
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
