package dev.twister.mesh;

import java.util.List;

/**
 * What lights a file's meshes, and from where they are seen.
 *
 * @param cameras each has a name of its own
 */
public record FileSurroundings(List<FileLight> lights, List<FileCamera> cameras) {
    public static final FileSurroundings NONE = new FileSurroundings(List.of(), List.of());

    public FileSurroundings {
        lights = List.copyOf(lights);
        cameras = List.copyOf(cameras);
    }

    /** The same in other coordinates. */
    FileSurroundings placed(Affine placement) {
        return new FileSurroundings(
                lights.stream().map(light -> light.placed(placement)).toList(),
                cameras.stream().map(camera -> camera.placed(placement)).toList());
    }
}
