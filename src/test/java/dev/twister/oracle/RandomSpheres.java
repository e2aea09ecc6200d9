package dev.twister.oracle;

import static dev.twister.oracle.RandomScenes.between;

import dev.twister.scene.Ground;
import dev.twister.scene.Sphere;
import dev.twister.scene.Vector3;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;

/** No, few or many spheres: on and in the ground, apart, touching, overlapping, and as large as a planet below. */
final class RandomSpheres {
    private RandomSpheres() {}

    static List<Sphere> spheres(Random random, Ground plane) {
        int count = switch (random.nextInt(8)) {
            case 0 -> 0;
            case 1 -> 1;
            case 2, 3 -> 30 + random.nextInt(60);
            default -> 2 + random.nextInt(8);
        };
        double largest = count > 10 ? 0.9 : 3;
        List<Sphere> spheres = new ArrayList<>();
        for (int i = 0; i < count; i++) {
            double radius = between(random, 0.05, largest);
            spheres.add(Sphere.of(
                    position(random, plane, spheres, radius),
                    radius,
                    RandomScenes.albedo(random),
                    RandomScenes.reflectivity(random)));
        }
        if (random.nextInt(10) == 0) {
            double radius = between(random, 20, 300);
            spheres.add(Sphere.of(
                    new Vector3(between(random, -5, 5), plane.height() - radius + between(random, -1, 1), 0),
                    radius,
                    RandomScenes.albedo(random),
                    RandomScenes.reflectivity(random)));
        }
        return spheres;
    }

    private static Vector3 position(Random random, Ground plane, List<Sphere> others, double radius) {
        Vector3 anywhere = new Vector3(between(random, -5, 5), between(random, -1, 6), between(random, -5, 5));
        return switch (random.nextInt(5)) {
            case 0 -> new Vector3(anywhere.x(), plane.height() + radius, anywhere.z());
            case 1 ->
                others.isEmpty()
                        ? anywhere
                        : beside(random, others.getLast(), others.getLast().radius() + radius);
            case 2 -> others.isEmpty() ? anywhere : beside(random, others.getLast(), radius * random.nextDouble());
            default -> anywhere;
        };
    }

    private static Vector3 beside(Random random, Sphere other, double distance) {
        Vector direction = new Vector(random.nextGaussian(), random.nextGaussian(), random.nextGaussian())
                .normalized()
                .times(distance);
        return new Vector3(
                other.position().x() + direction.x(),
                other.position().y() + direction.y(),
                other.position().z() + direction.z());
    }
}
