package dev.twister.gui.model;

import dev.twister.gui.model.NumberSetting.Scale;
import dev.twister.scene.Camera;
import dev.twister.scene.Range;
import dev.twister.scene.Scene;
import dev.twister.scene.SceneLimits;
import dev.twister.scene.Vector3;
import java.util.List;
import java.util.function.BiFunction;
import java.util.function.ToDoubleFunction;

/** Where the camera is and looks, as numbers. */
public final class CameraNumbers {
    private CameraNumbers() {}

    public static final NumberSetting X = place(
            "Camera x",
            "The camera's place from left to right.",
            Vector3::x,
            (place, x) -> new Vector3(x, place.y(), place.z()));

    public static final NumberSetting Y = place(
            "Camera y",
            "The camera's height. It stays above the plane.",
            Vector3::y,
            (place, y) -> new Vector3(place.x(), y, place.z()));

    public static final NumberSetting Z = place(
            "Camera z",
            "The camera's place from near to far.",
            Vector3::z,
            (place, z) -> new Vector3(place.x(), place.y(), z));

    public static final NumberSetting YAW = new NumberSetting(
            "Yaw",
            "Turn of the camera to the right; 0 looks along z.",
            SceneLimits.YAW,
            new Range(-180, 180),
            Scale.LINEAR,
            1,
            "°",
            scene -> scene.camera().yawDegrees(),
            (scene, degrees) -> scene.withCamera(scene.camera().withYaw(degrees)));

    public static final NumberSetting PITCH = new NumberSetting(
            "Pitch",
            "Turn of the camera down; 0 is level.",
            SceneLimits.PITCH,
            new Range(-90, 90),
            Scale.LINEAR,
            1,
            "°",
            scene -> scene.camera().pitchDegrees(),
            (scene, degrees) -> scene.withCamera(scene.camera().withPitch(degrees)));

    /** Meters per second that a walk may have. */
    public static final List<Double> SPEEDS = List.of(0.2, 0.5, 1.0, 2.0, 5.0, 10.0, 20.0, 50.0, 100.0);

    private static NumberSetting place(
            String label, String hint, ToDoubleFunction<Vector3> reader, BiFunction<Vector3, Double, Vector3> writer) {
        return SceneNumbers.place(
                label,
                hint,
                scene -> reader.applyAsDouble(scene.camera().position()),
                (scene, number) -> moved(scene, writer, number));
    }

    private static Scene moved(Scene scene, BiFunction<Vector3, Double, Vector3> writer, double number) {
        Camera camera = scene.camera();
        return scene.withCamera(camera.withPosition(writer.apply(camera.position(), number)));
    }
}
