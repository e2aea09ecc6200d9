package dev.twister.explain;

import dev.twister.scene.Rgb;
import dev.twister.scene.Vector3;
import java.util.Optional;

/**
 * What path tracing does at a surface: it chooses an emitter, then a lobe and a direction.
 *
 * @param point in the scene's meters
 * @param normal a unit vector, on the ray's side
 * @param mirror probability of the reflecting lobe
 * @param matte probability of the matte lobe
 * @param glass probability of the transmitting lobe
 * @param emitter the chosen emitter; empty if there is none, or if the surface scatters into single directions alone
 * @param next the chosen lobe; empty at the last bounce, unless it is mirror-like
 */
public record Scattering(
        Vector3 point,
        Vector3 normal,
        Rgb albedo,
        double roughness,
        double mirror,
        double matte,
        double glass,
        Optional<EmitterChoice> emitter,
        Optional<LobeChoice> next) {
    /**
     * An emitter.
     *
     * @param body its number, {@link dev.twister.kernel.Layout#NOTHING} for the sky
     * @param probability of choosing it, in (0, 1]
     */
    public record EmitterChoice(int body, double probability) {}

    /**
     * A lobe.
     *
     * @param kind of the ray that it scatters
     * @param probability of choosing it, in (0, 1]
     * @param density per steradian with which all lobes together scatter into the direction; 0 if it is mirror-like
     * @param factor by which the throughput is multiplied, without Russian roulette
     * @param survival probability with which the path goes on; 1 on the first surfaces
     * @param goesOn whether it does
     */
    public record LobeChoice(
            RayKind kind, double probability, double density, Rgb factor, double survival, boolean goesOn) {}
}
