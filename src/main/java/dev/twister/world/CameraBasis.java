package dev.twister.world;

import dev.twister.kernel.Layout;
import dev.twister.scene.Camera;

/** Converts a camera's angles to the first floats of {@link View#frame}, so that no pixel needs trigonometry. */
public final class CameraBasis {
    private CameraBasis() {}

    /**
     * Position; right, up and forward, which are the axes turned by pitch about x, then by yaw about y; lens and eye
     * distance.
     */
    public static float[] of(Camera camera) {
        double yaw = Math.toRadians(camera.yawDegrees());
        double pitch = Math.toRadians(camera.pitchDegrees());
        double sinYaw = Math.sin(yaw);
        double cosYaw = Math.cos(yaw);
        double sinPitch = Math.sin(pitch);
        double cosPitch = Math.cos(pitch);
        float[] array = new float[Layout.CAMERA_LENGTH];
        put(
                array,
                Layout.CAMERA_POSITION,
                camera.position().x(),
                camera.position().y(),
                camera.position().z());
        put(array, Layout.CAMERA_RIGHT, cosYaw, 0, -sinYaw);
        put(array, Layout.CAMERA_UP, sinPitch * sinYaw, cosPitch, sinPitch * cosYaw);
        put(array, Layout.CAMERA_FORWARD, cosPitch * sinYaw, -sinPitch, cosPitch * cosYaw);
        array[Layout.CAMERA_APERTURE] = (float) camera.aperture();
        array[Layout.CAMERA_FOCUS] = (float) camera.focusDistance();
        array[Layout.CAMERA_EYE_DISTANCE] = (float) (1 / Math.tan(Math.toRadians(camera.fieldOfViewDegrees()) / 2));
        return array;
    }

    private static void put(float[] array, int at, double x, double y, double z) {
        array[at] = (float) x;
        array[at + 1] = (float) y;
        array[at + 2] = (float) z;
    }
}
