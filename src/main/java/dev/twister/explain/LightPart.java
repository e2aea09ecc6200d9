package dev.twister.explain;

import dev.twister.scene.Vector3;
import java.util.List;

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
