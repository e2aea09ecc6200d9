package dev.twister.gui.model;

import dev.twister.scene.Plane;
import dev.twister.scene.Scene;
import dev.twister.scene.Sphere;
import dev.twister.scene.Vector3;
import java.util.Comparator;
import java.util.List;
import java.util.SplittableRandom;
import java.util.stream.IntStream;

/** Throws a scene's spheres into the air above the plane, anywhere over it, none in another. */
public final class ThrownSpheres {
    private static final double SHARE_OF_PLANE = 0.6;

    /** How many places are tried for a sphere before it goes higher. */
    private static final int TRIES = 8;

    private ThrownSpheres() {}

    /**
     * The scene with its spheres elsewhere: over the middle of the plane, each clear of the plane, the light and those
     * that were placed before it.
     *
     * @param seed another one gives other places
     */
    public static Scene of(Scene scene, long seed) {
        SplittableRandom random = new SplittableRandom(seed);
        List<Sphere> spheres = scene.spheres();
        double largest = spheres.stream().mapToDouble(Sphere::radius).max().orElse(1);
        SpherePacking packing =
                new SpherePacking(Math.max(largest, scene.light().radius()));
        packing.add(scene.light().position(), scene.light().radius());
        Sphere[] thrown = new Sphere[spheres.size()];
        Plane plane = scene.plane();
        double low = plane.height();
        // On a plane that is too small for them they would pile up to the sky.
        double half = Math.max(SHARE_OF_PLANE * plane.size() / 2, 2 * largest * Math.cbrt(spheres.size()));
        // The large ones first: they find no room between small ones.
        for (int index : order(spheres)) {
            Sphere sphere = spheres.get(index);
            double top = 4 * largest;
            Vector3 place = place(random, half, low + sphere.radius(), top);
            for (int tries = 1; !packing.isFree(place, sphere.radius()); tries++) {
                top = tries % TRIES == 0 ? top * 1.5 : top;
                place = place(random, half, low + sphere.radius(), top);
            }
            packing.add(place, sphere.radius());
            thrown[index] = new Sphere(place, sphere.radius(), sphere.color(), sphere.reflectivity());
        }
        return scene.withSpheres(List.of(thrown));
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
