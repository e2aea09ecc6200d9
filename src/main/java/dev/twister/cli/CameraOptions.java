package dev.twister.cli;

import dev.twister.scene.Camera;
import dev.twister.scene.Vector3;
import java.util.Optional;
import picocli.CommandLine.Option;

/** Where the picture is seen from, instead of the scene's own camera. */
final class CameraOptions {
    /** As in scene files: keeps every position, and its square, far from where floats lose metres. */
    private static final double MAX_COORDINATE = 1e6;

    private static final double MAX_YAW_DEGREES = 1e6;
    private static final double MAX_PITCH_DEGREES = 90;
    private static final double MIN_FIELD_OF_VIEW_DEGREES = 1;
    private static final double MAX_FIELD_OF_VIEW_DEGREES = 179;

    @Option(
            names = "--camera",
            paramLabel = "X,Y,Z",
            converter = Vector3Converter.class,
            description = "The camera's position, in metres.")
    private Optional<Vector3> position = Optional.empty();

    @Option(names = "--yaw", paramLabel = "DEGREES", description = "Turn to the right.")
    private Optional<Double> yaw = Optional.empty();

    @Option(names = "--pitch", paramLabel = "DEGREES", description = "Turn down, -90 to 90.")
    private Optional<Double> pitch = Optional.empty();

    @Option(
            names = "--fov",
            paramLabel = "DEGREES",
            description = "The angle over the picture's shorter side, 1 to 179.")
    private Optional<Double> fieldOfView = Optional.empty();

    Camera over(Camera camera) {
        return new Camera(
                position.map(CameraOptions::checked).orElse(camera.position()),
                Ranges.check("--yaw", yaw.orElse(camera.yawDegrees()), -MAX_YAW_DEGREES, MAX_YAW_DEGREES),
                Ranges.check("--pitch", pitch.orElse(camera.pitchDegrees()), -MAX_PITCH_DEGREES, MAX_PITCH_DEGREES),
                Ranges.check(
                        "--fov",
                        fieldOfView.orElse(camera.fieldOfViewDegrees()),
                        MIN_FIELD_OF_VIEW_DEGREES,
                        MAX_FIELD_OF_VIEW_DEGREES));
    }

    private static Vector3 checked(Vector3 place) {
        Ranges.check("--camera's x", place.x(), -MAX_COORDINATE, MAX_COORDINATE);
        Ranges.check("--camera's y", place.y(), -MAX_COORDINATE, MAX_COORDINATE);
        Ranges.check("--camera's z", place.z(), -MAX_COORDINATE, MAX_COORDINATE);
        return place;
    }
}
