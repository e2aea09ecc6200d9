package dev.twister.kernel;

/** The view rays of a strip. */
final class StripRays {
    private StripRays() {}

    /** Begins a sample: the view ray through its place in each pixel. */
    static void begin(
            int firstColumn,
            int row,
            int pixels,
            int sample,
            int[] dimensions,
            float[] camera,
            float[] pixelOffsets,
            float[] lanes,
            int[] marks) {
        int width = dimensions[Layout.WIDTH];
        int height = dimensions[Layout.HEIGHT];
        float offset = pixelOffsets[2 * sample];
        float v = ViewRay.v(dimensions[Layout.FIRST_ROW] + row + pixelOffsets[2 * sample + 1], width, height);
        float eyeDistance = camera[Layout.CAMERA_EYE_DISTANCE];
        float upX = v * camera[Layout.CAMERA_UP];
        float upY = v * camera[Layout.CAMERA_UP + 1];
        float upZ = v * camera[Layout.CAMERA_UP + 2];
        float forwardX = eyeDistance * camera[Layout.CAMERA_FORWARD];
        float forwardY = eyeDistance * camera[Layout.CAMERA_FORWARD + 1];
        float forwardZ = eyeDistance * camera[Layout.CAMERA_FORWARD + 2];
        float rightX = camera[Layout.CAMERA_RIGHT];
        float rightY = camera[Layout.CAMERA_RIGHT + 1];
        float rightZ = camera[Layout.CAMERA_RIGHT + 2];
        float positionX = camera[Layout.CAMERA_POSITION];
        float positionY = camera[Layout.CAMERA_POSITION + 1];
        float positionZ = camera[Layout.CAMERA_POSITION + 2];
        for (int lane = 0; lane < pixels; lane++) {
            float u = ViewRay.u(firstColumn + lane + offset, width, height);
            float x = u * rightX + upX + forwardX;
            float y = u * rightY + upY + forwardY;
            float z = u * rightZ + upZ + forwardZ;
            float inverse = KernelMath.inverseRoot(x * x + y * y + z * z);
            lanes[Strip.DIRECTION_X + lane] = x * inverse;
            lanes[Strip.DIRECTION_Y + lane] = y * inverse;
            lanes[Strip.DIRECTION_Z + lane] = z * inverse;
            lanes[Strip.ORIGIN_X + lane] = positionX;
            lanes[Strip.ORIGIN_Y + lane] = positionY;
            lanes[Strip.ORIGIN_Z + lane] = positionZ;
            lanes[Strip.THROUGHPUT + lane] = 1f;
            marks[Strip.LEAVING + lane] = Layout.NOTHING;
        }
    }
}
