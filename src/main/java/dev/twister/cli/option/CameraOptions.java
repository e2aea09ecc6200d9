package dev.twister.cli.option;

import dev.twister.cli.file.BadInputException;
import dev.twister.image.PictureSize;
import dev.twister.scene.Camera;
import dev.twister.scene.CameraView;
import dev.twister.scene.Scene;
import dev.twister.scene.TrackTarget;
import dev.twister.scene.Vector3;
import dev.twister.scene.property.CameraProperties;
import dev.twister.scene.property.SceneLimits;
import java.util.Arrays;
import java.util.Optional;
import java.util.stream.Collectors;
import picocli.CommandLine.ITypeConverter;
import picocli.CommandLine.Option;
import picocli.CommandLine.TypeConversionException;

/**
 * Where the picture is seen from and through which lens, instead of the scene's own camera; within what a scene file
 * may have.
 */
public final class CameraOptions {
    private static final String VIEW = "--camera-view";

    @Option(
            names = VIEW,
            paramLabel = "NAME",
            description = "One of the scene's views instead of its camera; it stands still.")
    private Optional<String> view = Optional.empty();

    @Option(
            names = "--camera",
            paramLabel = "X,Y,Z",
            converter = Vector3Converter.class,
            description = "The camera's position, in meters.")
    private Optional<Vector3> position = Optional.empty();

    @Option(names = "--yaw", paramLabel = "DEGREES", description = "Turn of the camera to the right.")
    private Optional<Double> yaw = Optional.empty();

    @Option(names = "--pitch", paramLabel = "DEGREES", description = "Turn of the camera down, -90 to 90.")
    private Optional<Double> pitch = Optional.empty();

    @Option(
            names = "--projection",
            paramLabel = "PROJECTION",
            description =
                    "perspective, orthographic, panorama (all directions; best twice as wide as high) or fisheye.")
    private Optional<Camera.Projection> projection = Optional.empty();

    @Option(
            names = "--view-height",
            paramLabel = "METERS",
            description = "What the height of an orthographic picture shows.")
    private Optional<Double> viewHeight = Optional.empty();

    @Option(
            names = "--fov",
            paramLabel = "DEGREES",
            description = "Field of view over the picture's shorter side, 1 to 179; to 360 with a fisheye.")
    private Optional<Double> fieldOfView = Optional.empty();

    @Option(
            names = "--aperture",
            paramLabel = "METERS",
            description = "Radius of the lens, 0 or more; with 0 everything is in focus.")
    private Optional<Double> aperture = Optional.empty();

    @Option(
            names = "--focus",
            paramLabel = "METERS",
            description = "Distance that is in focus, when the aperture is above 0.")
    private Optional<Double> focusDistance = Optional.empty();

    public Camera over(Scene scene) {
        Camera camera = view.map(name -> view(scene, name)).orElse(scene.camera());
        camera = camera.withPosition(position.map(CameraOptions::checked).orElse(camera.position()));
        camera = CameraProperties.PROJECTION.wither().apply(camera, projection.orElse(camera.projection()));
        camera = Ranges.over(camera, "--yaw", yaw, CameraProperties.YAW);
        camera = Ranges.over(camera, "--pitch", pitch, CameraProperties.PITCH);
        camera = fieldOfView.isPresent()
                ? camera.withFieldOfViewDegrees(
                        Ranges.check("--fov", fieldOfView.get(), CameraProperties.fieldOfView(camera.projection())))
                : camera;
        camera = Ranges.over(camera, "--view-height", viewHeight, CameraProperties.VIEW_HEIGHT);
        camera = Ranges.over(camera, "--aperture", aperture, CameraProperties.APERTURE);
        return Ranges.over(camera, "--focus", focusDistance, CameraProperties.FOCUS_DISTANCE);
    }

    /** The name of the view that a picture is seen from, as it is there. */
    public Optional<String> viewAlone() {
        return view.filter(_ -> position.isEmpty() && yaw.isEmpty() && pitch.isEmpty());
    }

    /** The size of a picture for which none is given: of a panorama that is asked for, twice as wide as high. */
    public PictureSize sizeOr(PictureSize usual) {
        return projection.filter(Camera.Projection.PANORAMA::equals).isPresent()
                ? new PictureSize(usual.width(), Math.max(1, usual.width() / 2))
                : usual;
    }

    /** The scene without the tracks of what the options say. */
    public Scene fixed(Scene scene) {
        boolean all = view.isPresent();
        Scene rest = fixed(scene, "fieldOfView", all || fieldOfView.isPresent());
        rest = fixed(rest, "viewHeight", all || viewHeight.isPresent());
        rest = fixed(rest, "aperture", all || aperture.isPresent());
        return fixed(rest, "focusDistance", all || focusDistance.isPresent());
    }

    private static Scene fixed(Scene scene, String property, boolean given) {
        return given ? scene.withoutTrack(TrackTarget.CAMERA, property) : scene;
    }

    private static Camera view(Scene scene, String name) {
        return scene.views().stream()
                .filter(view -> view.name().equals(name))
                .findFirst()
                .map(CameraView::camera)
                .orElseThrow(() -> new BadInputException(
                        scene.views().isEmpty()
                                ? VIEW + " is '" + name + "', but the scene has no views"
                                : "unknown value '" + name + "' of " + VIEW + "; expected one of the scene's views: "
                                        + scene.views().stream()
                                                .map(CameraView::name)
                                                .collect(Collectors.joining(", "))));
    }

    private static Vector3 checked(Vector3 place) {
        Ranges.check("--camera's x", place.x(), SceneLimits.POSITION);
        Ranges.check("--camera's y", place.y(), SceneLimits.POSITION);
        Ranges.check("--camera's z", place.z(), SceneLimits.POSITION);
        return place;
    }

    /** Reads places such as {@code 0,-5,-15}. */
    private static final class Vector3Converter implements ITypeConverter<Vector3> {
        private static final int COORDINATES = 3;

        @Override
        public Vector3 convert(String text) {
            String[] parts = text.split(",", -1);
            if (parts.length != COORDINATES) {
                throw malformed(text);
            }
            try {
                double[] numbers =
                        Arrays.stream(parts).mapToDouble(Double::parseDouble).toArray();
                return new Vector3(numbers[0], numbers[1], numbers[2]);
            } catch (NumberFormatException _) {
                throw malformed(text);
            }
        }

        private static TypeConversionException malformed(String text) {
            return new TypeConversionException(
                    "'" + text + "' is not a position; write x,y,z in meters, such as 0,-5,-15");
        }
    }
}
