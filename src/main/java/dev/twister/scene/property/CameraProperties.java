package dev.twister.scene.property;

import static dev.twister.scene.property.Property.choice;
import static dev.twister.scene.property.Property.decimal;
import static dev.twister.scene.property.Property.vector;
import static dev.twister.scene.property.Slide.linear;
import static dev.twister.scene.property.Slide.logarithmic;

import dev.twister.scene.Camera;
import dev.twister.scene.Vector3;
import java.util.List;

/** The properties of the camera, in the order in which a scene file has them. */
public final class CameraProperties {
    public static final Property<Camera, Vector3> POSITION = vector(
                    "position", SceneLimits.POSITION, Camera::position, Camera::withPosition)
            .written()
            .means("the lens's center")
            .row("Camera", "The camera's position.", "Alt+Shift+1 Alt+Shift+2 Alt+Shift+3")
            .slide(Slide.PLACE);

    public static final Property<Camera, Double> YAW = decimal(
                    "yaw", SceneLimits.ANGLE, Camera::yawDegrees, Camera::withYawDegrees)
            .written()
            .means("turn about y; positive looks right")
            .row("Yaw", "Turn of the camera to the right; 0 looks along z.", "Alt+Shift+Y")
            .slide(Slide.ANGLE);

    public static final Property<Camera, Double> PITCH = decimal(
                    "pitch", new Range(-90, 90, "degrees"), Camera::pitchDegrees, Camera::withPitchDegrees)
            .written()
            .means("turn about x; positive looks down")
            .row("Pitch", "Turn of the camera down; 0 is level.", "Alt+Shift+U")
            .slide(linear(-90, 90, 1, "°"));

    public static final Property<Camera, Camera.Projection> PROJECTION = choice(
                    "projection", Camera.Projection.class, Camera::projection, CameraProperties::projected)
            .since(4)
            .means("how directions are laid out: `panorama` is the whole sphere, `fisheye` the equidistant one")
            .row(
                    "Projection",
                    "Perspective; orthographic, without vanishing points; panorama, all directions; or fisheye.",
                    "");

    public static final Property<Camera, Double> FIELD_OF_VIEW = decimal(
                    "fieldOfView",
                    new Range(1, Camera.Projection.FISHEYE.maxFieldOfView(), "degrees"),
                    Camera::fieldOfViewDegrees,
                    (camera, degrees) -> camera.withFieldOfViewDegrees(
                            fieldOfView(camera.projection()).clamp(degrees)))
            .written()
            .animated()
            .means("the angle over the picture's shorter side; above 179 with a `fisheye` alone")
            .row(
                    "Field of view",
                    "Field of view over the shorter side of the picture. Small is a telephoto lens, large a wide "
                            + "angle.",
                    "Alt+W")
            .slide(linear(10, 120, 1, "°"));

    public static final Property<Camera, Double> VIEW_HEIGHT = decimal(
                    "viewHeight", SceneLimits.LENGTH, Camera::viewHeight, Camera::withViewHeight)
            .since(4)
            .animated()
            .means("what the picture's height shows, with the projection `orthographic`")
            .row("View height", "With the orthographic projection: what the picture's height shows.", "")
            .slide(logarithmic(0.1, 100, 2, "m"));

    public static final Property<Camera, Double> APERTURE = decimal(
                    "aperture", new Range(0, 1e6, "meters"), Camera::aperture, Camera::withAperture)
            .since(2)
            .animated()
            .means("the lens's radius; with 0 everything is sharp, as it is in panoramas and with a `fisheye`")
            .row(
                    "Aperture",
                    "The lens's radius. 0 is sharp everywhere; larger values blur more of what is not in focus.",
                    "Alt+Shift+A")
            .slide(linear(0, 0.5, 3, "m"));

    public static final Property<Camera, Double> FOCUS_DISTANCE = decimal(
                    "focusDistance", SceneLimits.LENGTH, Camera::focusDistance, Camera::withFocusDistance)
            .since(2)
            .animated()
            .means("how far ahead the plane is that is in focus")
            .row(
                    "Focus distance",
                    "Distance to the plane in focus, straight ahead. Ctrl+Shift+click in the picture sets it.",
                    "Alt+Shift+D")
            .slide(logarithmic(0.1, 100, 2, "m"));

    public static final List<Property<Camera, ?>> ALL =
            List.of(POSITION, YAW, PITCH, PROJECTION, FIELD_OF_VIEW, VIEW_HEIGHT, APERTURE, FOCUS_DISTANCE);

    private CameraProperties() {}

    /** The camera with a projection, and the nearest field of view that this can have. */
    private static Camera projected(Camera camera, Camera.Projection projection) {
        return camera.withProjection(projection)
                .withFieldOfViewDegrees(fieldOfView(projection).clamp(camera.fieldOfViewDegrees()));
    }

    /** What a camera of that projection may have. */
    public static Range fieldOfView(Camera.Projection projection) {
        Range widest = FIELD_OF_VIEW.range();
        return new Range(widest.min(), projection.maxFieldOfView(), widest.unit());
    }
}
