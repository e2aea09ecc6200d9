package dev.twister.mesh;

import java.util.List;

/**
 * What lights a file's meshes, and from where they are seen.
 *
 * @param cameras each has a name of its own
 */
public record Surroundings(List<FileLight> lights, List<FileCamera> cameras) {
    public static final Surroundings NONE = new Surroundings(List.of(), List.of());

    public Surroundings {
        lights = List.copyOf(lights);
        cameras = List.copyOf(cameras);
    }

    /** The same in other coordinates. */
    Surroundings placed(Affine placement) {
        return new Surroundings(
                lights.stream().map(light -> light.placed(placement)).toList(),
                cameras.stream().map(camera -> camera.placed(placement)).toList());
    }
}
