package dev.twister.oracle;

import dev.twister.scene.Camera;
import dev.twister.scene.Light;
import dev.twister.scene.Plane;
import dev.twister.scene.Rgb;
import dev.twister.scene.Scene;
import dev.twister.scene.Sphere;
import dev.twister.scene.Vector3;

/**
 * Rounds a scene's numbers to floats. Every engine is given floats; an oracle that draws a sphere at 0.1 where they
 * were given 0.10000000149 would draw another scene, and differ at every edge for a reason that is no engine's.
 */
final class FloatScene {
    private FloatScene() {}

    static Scene of(Scene scene) {
        Camera camera = scene.camera();
        Light light = scene.light();
        Plane plane = scene.plane();
        return new Scene(
                scene.name(),
                scene.description(),
                new Camera(
                        rounded(camera.position()),
                        camera.yawDegrees(),
                        camera.pitchDegrees(),
                        camera.fieldOfViewDegrees()),
                new Light(rounded(light.position()), (float) light.radius(), rounded(light.color())),
                new Plane(
                        (float) plane.size(),
                        (float) plane.height(),
                        rounded(plane.evenColor()),
                        rounded(plane.oddColor()),
                        (float) plane.reflectivity()),
                scene.spheres().stream().map(FloatScene::rounded).toList(),
                scene.skybox(),
                (float) scene.ambient(),
                scene.settings());
    }

    /** The same with all spheres larger by a factor. */
    static Scene grown(Scene scene, double factor) {
        return new Scene(
                scene.name(),
                scene.description(),
                scene.camera(),
                scene.light(),
                scene.plane(),
                scene.spheres().stream()
                        .map(sphere -> new Sphere(
                                sphere.position(), factor * sphere.radius(), sphere.color(), sphere.reflectivity()))
                        .toList(),
                scene.skybox(),
                scene.ambient(),
                scene.settings());
    }

    private static Sphere rounded(Sphere sphere) {
        return new Sphere(rounded(sphere.position()), (float) sphere.radius(), rounded(sphere.color()), (float)
                sphere.reflectivity());
    }

    private static Vector3 rounded(Vector3 vector) {
        return new Vector3((float) vector.x(), (float) vector.y(), (float) vector.z());
    }

    private static Rgb rounded(Rgb color) {
        return new Rgb((float) color.red(), (float) color.green(), (float) color.blue());
    }
}
