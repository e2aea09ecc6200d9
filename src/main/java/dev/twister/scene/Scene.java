package dev.twister.scene;

import java.nio.file.Path;
import java.util.List;

/**
 * What a scene file says.
 *
 * @param name a short title, may be empty
 * @param description a sentence for a person, may be empty
 * @param skybox the panorama's file, already resolved against the scene file's folder
 * @param ambient the ambient strength a in [0, 1], {@value #DEFAULT_AMBIENT} where the file is silent
 */
public record Scene(
        String name,
        String description,
        Camera camera,
        Light light,
        Plane plane,
        List<Sphere> spheres,
        Path skybox,
        double ambient,
        RenderSettings settings) {
    /** The version of the file format that this program reads and writes. */
    public static final int VERSION = 1;

    public static final double DEFAULT_AMBIENT = 0.2;

    public Scene {
        spheres = List.copyOf(spheres);
    }

    public Scene withCamera(Camera newCamera) {
        return new Scene(name, description, newCamera, light, plane, spheres, skybox, ambient, settings);
    }

    public Scene withLight(Light newLight) {
        return new Scene(name, description, camera, newLight, plane, spheres, skybox, ambient, settings);
    }

    public Scene withSpheres(List<Sphere> newSpheres) {
        return new Scene(name, description, camera, light, plane, newSpheres, skybox, ambient, settings);
    }

    public Scene withSkybox(Path newSkybox) {
        return new Scene(name, description, camera, light, plane, spheres, newSkybox, ambient, settings);
    }

    public Scene withSettings(RenderSettings newSettings) {
        return new Scene(name, description, camera, light, plane, spheres, skybox, ambient, newSettings);
    }
}
