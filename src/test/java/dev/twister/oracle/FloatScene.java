package dev.twister.oracle;

import dev.twister.scene.Camera;
import dev.twister.scene.Ground;
import dev.twister.scene.Light;
import dev.twister.scene.Material;
import dev.twister.scene.Rgb;
import dev.twister.scene.Scene;
import dev.twister.scene.Shading;
import dev.twister.scene.Sphere;
import dev.twister.scene.Vector3;
import dev.twister.scene.light.Lights;

/**
 * Rounds a scene's numbers to floats. Engines receive floats; an oracle with a sphere at 0.1 instead of 0.10000000149
 * would render another scene and differ at every edge through no fault of the engine.
 */
final class FloatScene {
    private FloatScene() {}

    static Scene of(Scene scene) {
        return scene.withCamera(rounded(scene.camera()))
                .withLights(new Lights(
                        scene.lights().list().stream().map(FloatScene::rounded).toList()))
                .withGround(rounded(scene.ground()))
                .withSpheres(scene.spheres().stream().map(FloatScene::rounded).toList())
                .withShading(new Shading((float) scene.shading().ambient()));
    }

    /** Rounds as well, and scales all spheres by a factor. */
    static Scene grown(Scene scene, double factor) {
        return scene.withSpheres(scene.spheres().stream()
                .map(sphere -> sphere.withRadius(factor * sphere.radius()))
                .toList());
    }

    private static Camera rounded(Camera camera) {
        return camera.withPosition(rounded(camera.position()))
                .withAperture((float) camera.aperture())
                .withFocusDistance((float) camera.focusDistance());
    }

    private static Material rounded(Material material) {
        return material.withColor(rounded(material.color()))
                .withReflectivity((float) material.reflectivity())
                .withRoughness((float) material.roughness())
                .withTransmission((float) material.transmission())
                .withIor((float) material.ior())
                .withMetallic((float) material.metallic());
    }

    private static Light rounded(Light light) {
        return light.withPosition(rounded(light.position()))
                .withRadius((float) light.radius())
                .withColor(rounded(light.color()))
                .withShare((float) light.share());
    }

    private static Ground rounded(Ground plane) {
        return plane.withSize((float) plane.size())
                .withHeight((float) plane.height())
                .withMaterial(rounded(plane.material()))
                .withColors(rounded(plane.evenColor()), rounded(plane.oddColor()));
    }

    private static Sphere rounded(Sphere sphere) {
        return sphere.withPosition(rounded(sphere.position()))
                .withRadius((float) sphere.radius())
                .withMaterial(rounded(sphere.material()));
    }

    private static Vector3 rounded(Vector3 vector) {
        return new Vector3((float) vector.x(), (float) vector.y(), (float) vector.z());
    }

    private static Rgb rounded(Rgb color) {
        return new Rgb((float) color.red(), (float) color.green(), (float) color.blue());
    }
}
