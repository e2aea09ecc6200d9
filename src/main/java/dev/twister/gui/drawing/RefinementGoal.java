package dev.twister.gui.drawing;

import dev.twister.scene.Material;
import dev.twister.scene.Scene;
import dev.twister.scene.Sphere;
import dev.twister.world.StageOrView;
import java.util.List;

/** How many samples per pixel a picture at rest gathers, and the noise at which it stops earlier. */
public final class RefinementGoal {
    /** Smooths edges. */
    public static final int SHARP = 64;

    /** Of a scene with a lens, rough surfaces or path tracing: its noise is a 32nd of one sample's. */
    public static final int NOISY = 1024;

    /** All samples are gathered. */
    public static final double NO_NOISE = 0;

    /** What the window offers. */
    public static final List<Double> NOISES = List.of(NO_NOISE, 0.05, 0.02, 0.01, 0.005, 0.002);

    private static final double PERCENT = 100;

    private RefinementGoal() {}

    /** At least the scene's own number of samples; one for views of numbers, which are exact with one sample. */
    public static int samples(Scene scene, StageOrView shown) {
        return shown.isColor() ? samples(scene) : 1;
    }

    static int samples(Scene scene) {
        return Math.max(isNoisy(scene) ? NOISY : SHARP, scene.rendering().samplesPerPixel());
    }

    private static boolean isNoisy(Scene scene) {
        return scene.rendering().integrator().isNoisy()
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

    /** The displayed text of a noise, relative to white. */
    public static String noiseLabel(double goal) {
        return goal == NO_NOISE ? "never" : goal * PERCENT + " %";
    }
}
