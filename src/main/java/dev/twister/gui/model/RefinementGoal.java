package dev.twister.gui.model;

import dev.twister.scene.Integrator;
import dev.twister.scene.Material;
import dev.twister.scene.Scene;
import dev.twister.scene.Sphere;
import dev.twister.world.StageOrView;

/** How many samples per pixel a picture at rest gathers. */
public final class RefinementGoal {
    /** Smooths edges. */
    public static final int SHARP = 64;

    /** Of a scene with a lens, rough surfaces or path tracing: its noise is a 32nd of one sample's. */
    public static final int NOISY = 1024;

    private RefinementGoal() {}

    /** At least the scene's own number of samples; one for views of numbers, which are exact with one sample. */
    public static int samples(Scene scene, StageOrView shown) {
        return shown.isColor() ? samples(scene) : 1;
    }

    public static int samples(Scene scene) {
        return Math.max(isNoisy(scene) ? NOISY : SHARP, scene.rendering().samplesPerPixel());
    }

    private static boolean isNoisy(Scene scene) {
        return scene.rendering().integrator() == Integrator.PATH
                || scene.camera().aperture() > 0
                || isRough(scene.ground().material())
                || scene.pour().filter(pour -> isRough(pour.material())).isPresent()
                || hasRoughSphere(scene)
                || scene.meshes().stream()
                        .anyMatch(mesh ->
                                mesh.material().filter(RefinementGoal::isRough).isPresent());
    }

    // Asked for each picture while the camera moves, of up to half a million spheres.
    private static boolean hasRoughSphere(Scene scene) {
        for (Sphere sphere : scene.spheres()) {
            if (isRough(sphere.material())) {
                return true;
            }
        }
        return false;
    }

    /** A matte surface is the same, however rough. */
    private static boolean isRough(Material material) {
        return material.roughness() > 0 && (material.reflectivity() > 0 || material.transmission() > 0);
    }
}
