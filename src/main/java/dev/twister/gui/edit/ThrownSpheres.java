package dev.twister.gui.edit;

import dev.twister.scene.Light;
import dev.twister.scene.Scene;
import dev.twister.scene.Sphere;
import dev.twister.scene.Vector3;
import dev.twister.scene.light.Lights;
import dev.twister.scene.property.SceneLimits;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
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

    /**
     * Spheres of which the larger ones come first, in grids, each for spheres of about one size: in that of a large one
     * there would be room for thousands of small ones in a cell.
     */
    static final class SpherePacking {
        private final List<Grid> grids = new ArrayList<>();

        private record Cell(long x, long y, long z) {}

        private record Placed(Vector3 center, double radius) {}

        /**
         * A packing around lights.
         *
         * @param largest no sphere's radius is larger
         */
        SpherePacking(Lights lights, double largest) {
            double largestLight =
                    lights.list().stream().mapToDouble(Light::radius).max().orElseThrow();
            grids.add(new Grid(Math.max(largest, largestLight)));
            lights.list().forEach(light -> grids.getFirst().add(new Placed(light.position(), light.radius())));
        }

        /** Adds a sphere that is no larger than those that were added before. */
        void add(Vector3 center, double radius) {
            if (2 * radius < grids.getLast().largest) {
                grids.add(new Grid(radius));
            }
            grids.getLast().add(new Placed(center, radius));
        }

        /** Whether a sphere there would touch none. */
        boolean isFree(Vector3 center, double radius) {
            return grids.stream().noneMatch(grid -> grid.touches(center, radius));
        }

        /** Its cells are as wide as its largest sphere, so that only neighbors can touch. */
        private static final class Grid {
            private final Map<Cell, List<Placed>> cells = new HashMap<>();
            private final double largest;

            Grid(double largest) {
                this.largest = largest;
            }

            void add(Placed sphere) {
                cells.computeIfAbsent(cellOf(sphere.center()), _ -> new ArrayList<>())
                        .add(sphere);
            }

            boolean touches(Vector3 center, double radius) {
                double reach = largest + radius;
                Cell first = cellOf(center.map(place -> place - reach));
                Cell last = cellOf(center.map(place -> place + reach));
                for (long x = first.x(); x <= last.x(); x++) {
                    for (long y = first.y(); y <= last.y(); y++) {
                        for (long z = first.z(); z <= last.z(); z++) {
                            for (Placed other : cells.getOrDefault(new Cell(x, y, z), List.of())) {
                                if (SpherePacking.touches(other, center, radius)) {
                                    return true;
                                }
                            }
                        }
                    }
                }
                return false;
            }

            private Cell cellOf(Vector3 place) {
                return new Cell(cell(place.x()), cell(place.y()), cell(place.z()));
            }

            private long cell(double place) {
                return (long) Math.floor(place / (2 * largest));
            }
        }

        private static boolean touches(Placed other, Vector3 center, double radius) {
            Vector3 apart = other.center().minus(center);
            double reach = other.radius() + radius;
            return apart.dot(apart) <= reach * reach;
        }
    }
}
