package dev.twister.scene;

import static java.util.Objects.requireNonNull;

import java.util.List;

/**
 * A camera that a scene keeps under a name, to go to.
 *
 * @param name 1 to 200 characters; no other view of the scene has it
 * @param camera stands still: it has no keyframes
 */
public record CameraView(String name, Camera camera) {
    public static final CameraView DEFAULT = new CameraView("", Camera.DEFAULT);

    public CameraView {
        requireNonNull(name, "name");
        requireNonNull(camera, "camera");
        camera = camera.withKeyframes(List.of());
    }

    public CameraView withName(String newName) {
        return new CameraView(newName, camera);
    }

    public CameraView withCamera(Camera newCamera) {
        return new CameraView(name, newCamera);
    }
}
