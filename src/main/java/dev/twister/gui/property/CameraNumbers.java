package dev.twister.gui.property;

import dev.twister.gui.edit.Axis;
import dev.twister.gui.property.NumberScale.Spread;
import dev.twister.scene.Camera;
import dev.twister.scene.Scene;
import dev.twister.scene.property.Range;
import dev.twister.scene.property.SceneLimits;
import java.math.BigDecimal;
import java.math.RoundingMode;
import java.util.List;

/** The numbers of the camera. */
public final class CameraNumbers {
    public static final NumberProperty<Camera> FIELD_OF_VIEW = new NumberProperty<>(
            "Field of view",
            "Field of view over the shorter side of the picture. Small is a telephoto lens, large a wide angle.",
            "Alt+W",
            new NumberScale(SceneLimits.FIELD_OF_VIEW, new Range(10, 120), Spread.LINEAR, 1, "°"),
            Camera::fieldOfViewDegrees,
            Camera::withFieldOfViewDegrees);

    /** Half the height of a frame of 35 mm film. */
    private static final double HALF_FRAME_MILLIMETERS = 12;

    /** Of the angle, so that the same length leads to the same angle. */
    private static final int DECIMALS = 12;

    private static final NumberProperty<Camera> FOCAL_LENGTH = new NumberProperty<>(
            "Focal length",
            "The field of view as the focal length of a lens on 35 mm film, whose frame is 24 mm high.",
            "",
            new NumberScale(
                    new Range(
                            focalLength(SceneLimits.FIELD_OF_VIEW.max()),
                            focalLength(SceneLimits.FIELD_OF_VIEW.min()),
                            "mm"),
                    new Range(8, 200),
                    Spread.LOGARITHMIC,
                    1,
                    "mm"),
            camera -> focalLength(camera.fieldOfViewDegrees()),
            (camera, millimeters) -> camera.withFieldOfViewDegrees(fieldOfView(millimeters)));

    public static final NumberProperty<Camera> APERTURE = new NumberProperty<>(
            "Aperture",
            "The lens's radius. 0 is sharp everywhere; larger values blur more of what is not in focus.",
            "Alt+Shift+A",
            new NumberScale(SceneLimits.APERTURE, new Range(0, 0.5), Spread.LINEAR, 3, "m"),
            Camera::aperture,
            Camera::withAperture);

    public static final NumberProperty<Camera> FOCUS_DISTANCE = new NumberProperty<>(
            "Focus distance",
            "Distance to the plane in focus, straight ahead. Ctrl+Shift+click in the picture sets it.",
            "Alt+Shift+D",
            new NumberScale(SceneLimits.FOCUS_DISTANCE, new Range(0.1, 100), Spread.LOGARITHMIC, 2, "m"),
            Camera::focusDistance,
            Camera::withFocusDistance);

    /** The rows of the panel, in their order. */
    public static final List<NumberProperty<Scene>> ALL = List.of(
                    place(Axis.X, "The camera's position from left to right.", "Alt+Shift+1"),
                    place(Axis.Y, "The camera's height. It stays above the plane.", "Alt+Shift+2"),
                    place(Axis.Z, "The camera's position from near to far.", "Alt+Shift+3"),
                    new NumberProperty<>(
                            "Yaw",
                            "Turn of the camera to the right; 0 looks along z.",
                            "Alt+Shift+Y",
                            new NumberScale(SceneLimits.YAW, new Range(-180, 180), Spread.LINEAR, 1, "°"),
                            Camera::yawDegrees,
                            Camera::withYawDegrees),
                    new NumberProperty<>(
                            "Pitch",
                            "Turn of the camera down; 0 is level.",
                            "Alt+Shift+U",
                            new NumberScale(SceneLimits.PITCH, new Range(-90, 90), Spread.LINEAR, 1, "°"),
                            Camera::pitchDegrees,
                            Camera::withPitchDegrees),
                    FIELD_OF_VIEW,
                    FOCAL_LENGTH,
                    APERTURE,
                    FOCUS_DISTANCE)
            .stream()
            .map(number -> number.in(Scene::camera, (scene, edit) -> scene.withCamera(edit.apply(scene.camera()))))
            .toList();

    /** Walking speeds in meters per second. */
    public static final List<Double> SPEEDS = List.of(0.2, 0.5, 1.0, 2.0, 5.0, 10.0, 20.0, 50.0, 100.0);

    private CameraNumbers() {}

    private static double focalLength(double degrees) {
        return HALF_FRAME_MILLIMETERS / Math.tan(Math.toRadians(degrees / 2));
    }

    private static double fieldOfView(double millimeters) {
        double degrees = 2 * Math.toDegrees(Math.atan(HALF_FRAME_MILLIMETERS / millimeters));
        return SceneLimits.FIELD_OF_VIEW.clamp(BigDecimal.valueOf(degrees)
                .setScale(DECIMALS, RoundingMode.HALF_UP)
                .doubleValue());
    }

    private static NumberProperty<Camera> place(Axis axis, String hint, String key) {
        return new NumberProperty<>(
                "Camera " + axis.label(),
                hint,
                key,
                SceneNumbers.PLACE,
                camera -> axis.of(camera.position()),
                (camera, number) -> camera.withPosition(axis.with(camera.position(), number)));
    }
}
