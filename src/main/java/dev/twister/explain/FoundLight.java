package dev.twister.explain;

import dev.twister.scene.Rgb;

/**
 * Light that a path finds: by a ray to a chosen emitter, or because a scattered ray meets one.
 *
 * @param radiance that the emitter sends along the ray
 * @param surfaceDensity density per steradian with which the surface scatters into this direction; 0 for the view ray
 *     and after a mirror-like reflection or refraction
 * @param emitterDensity density per steradian with which the choice of an emitter takes this direction
 * @param weight of multiple importance sampling, in [0, 1]
 */
public record FoundLight(Rgb radiance, double surfaceDensity, double emitterDensity, double weight) {}
