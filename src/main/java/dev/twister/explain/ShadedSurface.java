package dev.twister.explain;

import dev.twister.scene.Rgb;
import dev.twister.scene.Vector3;
import java.util.List;
import java.util.Optional;

/**
 * A surface that a ray has met, and the numbers of the equation there: {@code (1 - m) (1 - t) lit C} and each light's
 * {@code lightColor spec} are what the surface adds, {@code m lit + (1 - m) t F} the reflected and {@code (1 - m) t (1
 * - F) C} the refracted ray's part (the rough facet's weight aside).
 *
 * @param point in the scene's meters
 * @param normal N, a unit vector, towards the ray where it comes from inside a transparent body
 * @param albedo C, with checks and texture
 * @param reflectivity p in [0, 128]
 * @param roughness in [0, 1]
 * @param ior index of refraction; 0 where the body does not transmit
 * @param lights what each light does, at least one
 * @param lit {@code max(ambient, sum of k max(0, N.L) S)}
 * @param mirror m = p / 128; 0 at the last bounce
 * @param transmission t; 0 at the last bounce
 * @param reflectance F in [0, 1]; 0 where t is 0
 */
public record ShadedSurface(
        Vector3 point,
        Vector3 normal,
        Rgb albedo,
        double reflectivity,
        double roughness,
        double ior,
        List<LightPart> lights,
        double lit,
        double mirror,
        double transmission,
        double reflectance) {
    /** The only light, if there is no other. */
    public Optional<LightPart> onlyLight() {
        return Optional.of(lights.getFirst()).filter(_ -> lights.size() == 1);
    }

    /**
     * What a light does at a surface.
     *
     * @param light its number, from 0 in the scene's order
     * @param toLight L, a unit vector to the light's center
     * @param normalDotLight N.L
     * @param visible S in [0, 1]; 1 where it changes nothing, and there are no shadow rays
     * @param share k
     * @param specular spec, with S in it
     * @param shadowRays as many as the picture has shadow samples, or none
     */
    public record LightPart(
            int light,
            Vector3 toLight,
            double normalDotLight,
            double visible,
            double share,
            double specular,
            List<LightSample> shadowRays) {
        /** The light's part of lit: {@code k max(0, N.L) S}. */
        public double lit() {
            return share * Math.max(0, normalDotLight) * visible;
        }
    }
}
