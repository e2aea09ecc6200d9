package dev.twister.scene;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Random;

/** Puts a scene's spheres anywhere over its plane, so that none touches another, the ground or the light. */
public final class SphereShuffle {
    /** The share of the space over the plane that the spheres take at first. */
    private static final double DENSITY = 0.08;

    private static final int TRIES_PER_GROWTH = 50;
    private static final double GROWTH = 1.1;

    private final Scene scene;
    private final Random random;
    private final double cell;
    private final Map<Vector3, List<Sphere>> cells = new HashMap<>();
    private double ceiling;

    private SphereShuffle(Scene scene, long seed) {
        this.scene = scene;
        random = new Random(seed);
        double largest =
                scene.spheres().stream().mapToDouble(Sphere::radius).max().orElse(1);
        cell = 2 * largest;
        double volume = scene.spheres().stream()
                .mapToDouble(sphere -> 4 * Math.PI / 3 * sphere.radius() * sphere.radius() * sphere.radius())
                .sum();
        double side = scene.plane().size();
        ceiling = 2 * largest + volume / (side * side) / DENSITY;
    }

    /**
     * The scene with its spheres elsewhere; what is poured stays as it is.
     *
     * @param seed another one gives other places, the same one the same
     */
    public static Scene of(Scene scene, long seed) {
        return scene.withSpheres(new SphereShuffle(scene, seed).placed());
    }

    private List<Sphere> placed() {
        List<Sphere> placed = new ArrayList<>();
        for (Sphere sphere : scene.spheres()) {
            Sphere moved = clear(sphere);
            cells.computeIfAbsent(cell(moved.position()), _ -> new ArrayList<>())
                    .add(moved);
            placed.add(moved);
        }
        return placed;
    }

    // Darts are thrown until one lands clear of all others; the space grows upwards where it is full.
    private Sphere clear(Sphere sphere) {
        Sphere dart = thrown(sphere);
        for (int tries = 1; !isClear(dart); tries++) {
            ceiling *= tries % TRIES_PER_GROWTH == 0 ? GROWTH : 1;
            dart = thrown(sphere);
        }
        return dart;
    }

    private Sphere thrown(Sphere sphere) {
        double radius = sphere.radius();
        double reach = Math.max(0, scene.plane().size() / 2 - radius);
        double height = Math.max(0, ceiling - 2 * radius);
        Vector3 position = new Vector3(
                reach * (2 * random.nextDouble() - 1),
                scene.plane().height() + radius + height * random.nextDouble(),
                reach * (2 * random.nextDouble() - 1));
        return new Sphere(position, radius, sphere.color(), sphere.reflectivity());
    }

    private boolean isClear(Sphere dart) {
        Light light = scene.light();
        if (touch(dart, light.position(), light.radius())) {
            return false;
        }
        Vector3 middle = cell(dart.position());
        for (int x = -1; x <= 1; x++) {
            for (int y = -1; y <= 1; y++) {
                for (int z = -1; z <= 1; z++) {
                    Vector3 near = new Vector3(middle.x() + x + 0.0, middle.y() + y + 0.0, middle.z() + z + 0.0);
                    boolean met = cells.getOrDefault(near, List.of()).stream()
                            .anyMatch(sphere -> touch(dart, sphere.position(), sphere.radius()));
                    if (met) {
                        return false;
                    }
                }
            }
        }
        return true;
    }

    private static boolean touch(Sphere dart, Vector3 position, double radius) {
        double x = dart.position().x() - position.x();
        double y = dart.position().y() - position.y();
        double z = dart.position().z() - position.z();
        double least = dart.radius() + radius;
        return x * x + y * y + z * z <= least * least;
    }

    // Adding 0 turns -0.0 into 0.0, which a record tells apart.
    private Vector3 cell(Vector3 place) {
        return new Vector3(
                Math.floor(place.x() / cell) + 0.0,
                Math.floor(place.y() / cell) + 0.0,
                Math.floor(place.z() / cell) + 0.0);
    }
}
