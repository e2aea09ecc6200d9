package dev.twister.scene;

import static java.util.Objects.requireNonNull;

import dev.twister.scene.property.Copied;
import java.util.List;

/**
 * A camera that a scene keeps under a name, to go to.
 *
 * @param name 1 to 200 characters; no other view of the scene has it
 * @param camera stands still: it has no keyframes
 */
@Copied
public record CameraView(String name, Camera camera) implements CameraViewCopy.With {
    public static final CameraView DEFAULT = new CameraView("", Camera.DEFAULT);

    public CameraView {
        requireNonNull(name, "name");
        requireNonNull(camera, "camera");
        camera = camera.withKeyframes(List.of());
    }
}
