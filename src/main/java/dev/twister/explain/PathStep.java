package dev.twister.explain;

import dev.twister.kernel.Layout;
import dev.twister.scene.Rgb;
import dev.twister.scene.Vector3;
import java.util.Optional;

/**
 * A ray of a pixel's path, and what it meets.
 *
 * @param parent the index of the step whose surface it leaves; {@link #NO_PARENT} for the view ray
 * @param bounce how many surfaces the path has left before, 0 for the view ray
 * @param origin in the scene's meters
 * @param direction a unit vector
 * @param inside whether it goes through the inside of a transparent body
 * @param throughput what part of the radiance it finds reaches the pixel
 * @param body what it meets, as view {@code body} numbers it: {@link Layout#NOTHING} is the sky, {@link Layout#LIGHT}
 *     the first light, {@link Layout#PLANE} the plane, spheres follow
 * @param distance in meters; 0 where it meets nothing
 * @param shading of the surface it meets; none for a light and the sky, and in path tracing
 * @param light found in path tracing
 * @param scattering at the surface in path tracing
 * @param adds radiance that the step adds to the pixel's sample
 */
public record PathStep(
        int parent,
        RayKind kind,
        int bounce,
        Vector3 origin,
        Vector3 direction,
        boolean inside,
        Rgb throughput,
        int body,
        double distance,
        Optional<ShadedSurface> shading,
        Optional<FoundLight> light,
        Optional<Scattering> scattering,
        Rgb adds) {
    public static final int NO_PARENT = -1;

    /**
     * Light that a path finds: by a ray to a chosen emitter, or because a scattered ray meets one.
     *
     * @param radiance that the emitter sends along the ray
     * @param surfaceDensity density per steradian with which the surface scatters into this direction; 0 for the view
     *     ray and after a mirror-like reflection or refraction
     * @param emitterDensity density per steradian with which the choice of an emitter takes this direction
     * @param weight of multiple importance sampling, in [0, 1]
     */
    public record FoundLight(Rgb radiance, double surfaceDensity, double emitterDensity, double weight) {}
}
