package dev.twister.scene;

import java.nio.file.Path;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Optional;
import java.util.SequencedMap;
import java.util.stream.Stream;

/**
 * What a scene file says.
 *
 * @param name a short title, may be empty
 * @param description a sentence for a person, may be empty
 * @param views cameras to go to, each under a name of its own, in the order in which they are offered
 * @param materials those that bodies share by name, in the file's order; what a body has of one is in the body
 * @param spheres those that are there from the start
 * @param meshes bodies of triangles
 * @param skybox the panorama's file, already resolved against the scene file's folder
 * @param skyRotationDegrees how far the panorama is turned to the right, about the y axis
 * @param skyStrength what its radiance is multiplied by, 0 or more
 * @param ambient the ambient strength a in [0, 1], {@value #DEFAULT_AMBIENT} where the file is silent
 * @param physics how bodies move, where they do
 * @param pour spheres that come one after the other while bodies move
 */
public record Scene(
        String name,
        String description,
        Camera camera,
        List<CameraView> views,
        Light light,
        SequencedMap<String, Material> materials,
        Plane plane,
        List<Sphere> spheres,
        List<Mesh> meshes,
        Path skybox,
        double skyRotationDegrees,
        double skyStrength,
        double ambient,
        RenderSettings settings,
        Physics physics,
        Optional<Pour> pour) {
    /** The newest version of the file format; the older ones are read too. */
    public static final int VERSION = 2;

    public static final double DEFAULT_AMBIENT = 0.2;

    public Scene {
        materials = Collections.unmodifiableSequencedMap(new LinkedHashMap<>(materials));
        views = List.copyOf(views);
        spheres = List.copyOf(spheres);
        meshes = List.copyOf(meshes);
    }

    /** An empty scene: the default camera, light, plane and settings, no name and no spheres. */
    public static Scene under(Path skybox) {
        return new Scene(
                "",
                "",
                Camera.DEFAULT,
                List.of(),
                Light.DEFAULT,
                new LinkedHashMap<>(),
                Plane.DEFAULT,
                List.of(),
                List.of(),
                skybox,
                0,
                1,
                DEFAULT_AMBIENT,
                RenderSettings.DEFAULT,
                Physics.DEFAULT,
                Optional.empty());
    }

    /** The spheres that are there from the start, then those that are poured, in the order in which they come. */
    public List<Sphere> allSpheres() {
        return pour.map(coming -> Stream.concat(spheres.stream(), coming.spheres().stream())
                        .toList())
                .orElse(spheres);
    }

    public Scene withName(String newName) {
        return new Scene(
                newName,
                description,
                camera,
                views,
                light,
                materials,
                plane,
                spheres,
                meshes,
                skybox,
                skyRotationDegrees,
                skyStrength,
                ambient,
                settings,
                physics,
                pour);
    }

    public Scene withDescription(String newDescription) {
        return new Scene(
                name,
                newDescription,
                camera,
                views,
                light,
                materials,
                plane,
                spheres,
                meshes,
                skybox,
                skyRotationDegrees,
                skyStrength,
                ambient,
                settings,
                physics,
                pour);
    }

    public Scene withCamera(Camera newCamera) {
        return new Scene(
                name,
                description,
                newCamera,
                views,
                light,
                materials,
                plane,
                spheres,
                meshes,
                skybox,
                skyRotationDegrees,
                skyStrength,
                ambient,
                settings,
                physics,
                pour);
    }

    public Scene withViews(List<CameraView> newViews) {
        return new Scene(
                name,
                description,
                camera,
                newViews,
                light,
                materials,
                plane,
                spheres,
                meshes,
                skybox,
                skyRotationDegrees,
                skyStrength,
                ambient,
                settings,
                physics,
                pour);
    }

    public Scene withLight(Light newLight) {
        return new Scene(
                name,
                description,
                camera,
                views,
                newLight,
                materials,
                plane,
                spheres,
                meshes,
                skybox,
                skyRotationDegrees,
                skyStrength,
                ambient,
                settings,
                physics,
                pour);
    }

    public Scene withMaterials(SequencedMap<String, Material> newMaterials) {
        return new Scene(
                name,
                description,
                camera,
                views,
                light,
                newMaterials,
                plane,
                spheres,
                meshes,
                skybox,
                skyRotationDegrees,
                skyStrength,
                ambient,
                settings,
                physics,
                pour);
    }

    public Scene withPlane(Plane newPlane) {
        return new Scene(
                name,
                description,
                camera,
                views,
                light,
                materials,
                newPlane,
                spheres,
                meshes,
                skybox,
                skyRotationDegrees,
                skyStrength,
                ambient,
                settings,
                physics,
                pour);
    }

    public Scene withSpheres(List<Sphere> newSpheres) {
        return new Scene(
                name,
                description,
                camera,
                views,
                light,
                materials,
                plane,
                newSpheres,
                meshes,
                skybox,
                skyRotationDegrees,
                skyStrength,
                ambient,
                settings,
                physics,
                pour);
    }

    public Scene withMeshes(List<Mesh> newMeshes) {
        return new Scene(
                name,
                description,
                camera,
                views,
                light,
                materials,
                plane,
                spheres,
                newMeshes,
                skybox,
                skyRotationDegrees,
                skyStrength,
                ambient,
                settings,
                physics,
                pour);
    }

    public Scene withSkybox(Path newSkybox) {
        return new Scene(
                name,
                description,
                camera,
                views,
                light,
                materials,
                plane,
                spheres,
                meshes,
                newSkybox,
                skyRotationDegrees,
                skyStrength,
                ambient,
                settings,
                physics,
                pour);
    }

    public Scene withSkyRotation(double newSkyRotationDegrees) {
        return new Scene(
                name,
                description,
                camera,
                views,
                light,
                materials,
                plane,
                spheres,
                meshes,
                skybox,
                newSkyRotationDegrees,
                skyStrength,
                ambient,
                settings,
                physics,
                pour);
    }

    public Scene withSkyStrength(double newSkyStrength) {
        return new Scene(
                name,
                description,
                camera,
                views,
                light,
                materials,
                plane,
                spheres,
                meshes,
                skybox,
                skyRotationDegrees,
                newSkyStrength,
                ambient,
                settings,
                physics,
                pour);
    }

    public Scene withAmbient(double newAmbient) {
        return new Scene(
                name,
                description,
                camera,
                views,
                light,
                materials,
                plane,
                spheres,
                meshes,
                skybox,
                skyRotationDegrees,
                skyStrength,
                newAmbient,
                settings,
                physics,
                pour);
    }

    public Scene withSettings(RenderSettings newSettings) {
        return new Scene(
                name,
                description,
                camera,
                views,
                light,
                materials,
                plane,
                spheres,
                meshes,
                skybox,
                skyRotationDegrees,
                skyStrength,
                ambient,
                newSettings,
                physics,
                pour);
    }

    public Scene withPhysics(Physics newPhysics) {
        return new Scene(
                name,
                description,
                camera,
                views,
                light,
                materials,
                plane,
                spheres,
                meshes,
                skybox,
                skyRotationDegrees,
                skyStrength,
                ambient,
                settings,
                newPhysics,
                pour);
    }

    public Scene withPour(Pour newPour) {
        return new Scene(
                name,
                description,
                camera,
                views,
                light,
                materials,
                plane,
                spheres,
                meshes,
                skybox,
                skyRotationDegrees,
                skyStrength,
                ambient,
                settings,
                physics,
                Optional.of(newPour));
    }
}
