package dev.twister.world;

import dev.twister.kernel.CameraRay;
import dev.twister.kernel.Layout;
import dev.twister.scene.Camera;

/** Converts a camera's angles to the first floats of {@link View#frame}, so that no pixel needs trigonometry. */
public final class CameraBasis {
    private CameraBasis() {}

    /**
     * Position; right, up and forward, which are the axes turned by pitch about x, then by yaw about y; lens and eye
     * distance; the projection.
     */
    public static float[] of(Camera camera) {
        double yaw = Math.toRadians(camera.yawDegrees());
        double pitch = Math.toRadians(camera.pitchDegrees());
        double sinYaw = Math.sin(yaw);
        double cosYaw = Math.cos(yaw);
        double sinPitch = Math.sin(pitch);
        double cosPitch = Math.cos(pitch);
        int projection = projection(camera.projection());
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
        boolean round = projection > CameraRay.ORTHOGRAPHIC;
        array[Layout.CAMERA_APERTURE] = round ? 0 : (float) camera.aperture();
        array[Layout.CAMERA_FOCUS] = (float) camera.focusDistance();
        double field = camera.fieldOfViewDegrees();
        array[Layout.CAMERA_EYE_DISTANCE] = (float) (1 / Math.tan(Math.toRadians(field) / 2));
        array[Layout.CAMERA_PROJECTION] = projection;
        array[Layout.CAMERA_VIEW_HEIGHT] = (float) camera.viewHeight();
        array[Layout.CAMERA_HALF_FIELD] = (float) (field / 2 / 360);
        return array;
    }

    private static int projection(Camera.Projection projection) {
        return switch (projection) {
            case PERSPECTIVE -> CameraRay.PERSPECTIVE;
            case ORTHOGRAPHIC -> CameraRay.ORTHOGRAPHIC;
            case PANORAMA -> CameraRay.PANORAMA;
            case FISHEYE -> CameraRay.FISHEYE;
        };
    }

    private static void put(float[] array, int at, double x, double y, double z) {
        array[at] = (float) x;
        array[at + 1] = (float) y;
        array[at + 2] = (float) z;
    }
}
