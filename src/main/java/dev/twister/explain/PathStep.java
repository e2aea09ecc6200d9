package dev.twister.explain;

import dev.twister.kernel.Layout;
import dev.twister.scene.Rgb;
import dev.twister.scene.Vector3;
import java.util.List;
import java.util.Locale;
import java.util.Optional;

/**
 * A ray of a pixel's path, and what it meets. A ray that passes the discs of suns has a step for each, and one for the
 * sky behind them.
 *
 * @param parent the index of the step whose surface it leaves; {@link #NO_PARENT} for the view ray
 * @param bounce how many surfaces the path has left before, 0 for the view ray
 * @param origin in the scene's meters
 * @param direction a unit vector
 * @param inside whether it goes through the inside of a transparent body
 * @param throughput what part of the radiance it finds reaches the pixel
 * @param body what it meets, as view {@code body} numbers it: {@link Layout#NOTHING} is the sky, {@link Layout#LIGHT}
 *     the first light, {@link Layout#PLANE} the plane, spheres follow
 * @param distance in meters; 0 where it meets the sky or a sun
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

    /** Where a ray of a path comes from. */
    public enum RayKind {
        /** From the camera. */
        VIEW,
        REFLECTED,
        REFRACTED,
        /** By a matte surface, in path tracing. */
        SCATTERED,
        /** To a chosen emitter, in path tracing. */
        EMITTER;

        /** Its name in texts and files, such as {@code reflected}. */
        public String id() {
            return name().toLowerCase(Locale.ROOT);
        }
    }

    /**
     * A surface that a ray has met, and the numbers of the equation there: {@code (1 - m) (1 - t) lit C} and each
     * light's {@code lightColor spec} are what the surface adds, {@code m lit + (1 - m) t F} the reflected and
     * {@code (1 - m) t (1 - F) C} the refracted ray's part (the rough facet's weight aside).
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
    }

    /**
     * What a light does at a surface.
     *
     * @param light its number, from 0 in the scene's order
     * @param toLight L, a unit vector to the light's center
     * @param normalDotLight N.L
     * @param visible S in [0, 1]; 1 where it changes nothing, and there are no shadow rays
     * @param cone the part of a spot's light that goes to the point, in [0, 1]; 1 for other lights
     * @param share k
     * @param specular spec, with S and cone in it
     * @param shadowRays as many as the picture has shadow samples, or none
     */
    public record LightPart(
            int light,
            Vector3 toLight,
            double normalDotLight,
            double visible,
            double cone,
            double share,
            double specular,
            List<LightSample> shadowRays) {
        /** The light's part of lit: {@code k max(0, N.L) S}, for a spot times the cone. */
        public double lit() {
            return share * Math.max(0, normalDotLight) * visible * cone;
        }
    }

    /**
     * A ray from a surface to a point of the light's disc.
     *
     * @param target the point, in the scene's meters
     * @param light what reaches the surface along it: 1, 0 where it is blocked, between them where bodies on its way
     *     transmit
     * @param blocker the nearest body on its way; {@link Layout#NOTHING} where all light passes
     */
    public record LightSample(Vector3 target, double light, int blocker) {}

    /**
     * What path tracing does at a surface: it chooses an emitter, then a lobe and a direction.
     *
     * @param point in the scene's meters
     * @param normal a unit vector, on the ray's side
     * @param lobes what the direction is chosen from
     * @param emitter the chosen emitter; empty if there is none, or if the surface scatters into single directions
     *     alone
     * @param next the chosen lobe; empty at the last bounce, unless it is mirror-like
     */
    public record Scattering(
            Vector3 point,
            Vector3 normal,
            Rgb albedo,
            double roughness,
            LobeProbabilities lobes,
            Optional<EmitterChoice> emitter,
            Optional<LobeChoice> next) {
        /**
         * The probabilities of the lobes, in [0, 1].
         *
         * @param mirror of the reflecting one
         * @param matte of the matte one
         * @param glass of the transmitting one
         * @param coat of the clear coat's
         * @param through of matte light that passes the surface
         */
        public record LobeProbabilities(double mirror, double matte, double glass, double coat, double through) {}

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
