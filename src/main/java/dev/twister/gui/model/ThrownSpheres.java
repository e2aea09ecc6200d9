package dev.twister.gui.model;

import dev.twister.scene.Scene;
import dev.twister.scene.Sphere;
import dev.twister.scene.Vector3;
import dev.twister.scene.property.SceneLimits;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.SplittableRandom;
import java.util.stream.IntStream;

/** Throws a scene's spheres into the air above the plane, anywhere over it, none in another. */
public final class ThrownSpheres {
    private static final double SHARE_OF_PLANE = 0.6;

    /** How many places are tried for a sphere before it goes higher. */
    private static final int TRIES = 8;

    /** How much higher it goes then. */
    private static final double GROWTH = 1.5;

    private ThrownSpheres() {}

    /**
     * The scene with its spheres elsewhere: over the middle of the plane, each clear of the plane, the lights and those
     * that were placed before it. Only spheres so large that there is no such place in all that a scene may span are in
     * others.
     *
     * @param seed another one gives other places
     */
    public static Scene of(Scene scene, long seed) {
        SplittableRandom random = new SplittableRandom(seed);
        List<Sphere> spheres = scene.spheres();
        double largest = spheres.stream().mapToDouble(Sphere::radius).max().orElse(1);
        SpherePacking packing = new SpherePacking(scene.lights(), largest);
        Sphere[] thrown = new Sphere[spheres.size()];
        double half = half(scene);
        double top = 0;
        // The large ones first: they find no room between small ones.
        for (int index : order(spheres)) {
            Sphere sphere = spheres.get(index);
            double low = SceneLimits.POSITION.clamp(scene.ground().height() + sphere.radius());
            double highest = SceneLimits.POSITION.max() - low;
            // A place that had no room for the previous sphere has none for this one.
            top = Math.min(Math.max(4 * largest, top / GROWTH), highest);
            Vector3 place = place(random, half, low, top);
            for (int tries = 1; !packing.isFree(place, sphere.radius()); tries++) {
                if (tries % TRIES == 0) {
                    if (top == highest) {
                        break;
                    }
                    top = Math.min(GROWTH * top, highest);
                }
                place = place(random, half, low, top);
            }
            packing.add(place, sphere.radius());
            thrown[index] = at(place, sphere);
        }
        return scene.withSpheres(List.of(thrown));
    }

    /** Whether a scene that was edited while its spheres were thrown can have the places that were found. */
    public static boolean fit(Scene thrown, Scene edited) {
        return thrown.ground().equals(edited.ground())
                && thrown.lights().equals(edited.lights())
                && Arrays.equals(radii(thrown), radii(edited));
    }

    /** The edited scene with the places found for its spheres; call it only if they {@link #fit}. */
    public static Scene placed(Scene thrown, Scene edited) {
        List<Sphere> spheres = edited.spheres();
        return edited.withSpheres(IntStream.range(0, spheres.size())
                .mapToObj(index -> at(thrown.spheres().get(index).position(), spheres.get(index)))
                .toList());
    }

    private static double[] radii(Scene scene) {
        return scene.spheres().stream().mapToDouble(Sphere::radius).toArray();
    }

    private static Sphere at(Vector3 place, Sphere sphere) {
        return sphere.withPosition(place);
    }

    /** Half the width of the area in which spheres are placed. On a small plane they would pile up without a limit. */
    private static double half(Scene scene) {
        double cubes = scene.spheres().stream()
                .mapToDouble(sphere -> Math.pow(sphere.radius(), 3))
                .sum();
        return SceneLimits.POSITION.clamp(
                Math.max(SHARE_OF_PLANE * scene.ground().size() / 2, 2 * Math.cbrt(cubes)));
    }

    private static List<Integer> order(List<Sphere> spheres) {
        return IntStream.range(0, spheres.size())
                .boxed()
                .sorted(Comparator.comparingDouble(
                                (Integer index) -> spheres.get(index).radius())
                        .reversed())
                .toList();
    }

    private static Vector3 place(SplittableRandom random, double half, double low, double top) {
        return new Vector3(
                half * (2 * random.nextDouble() - 1),
                low + top * random.nextDouble(),
                half * (2 * random.nextDouble() - 1));
    }
}
