package dev.twister.gui.model;

import dev.twister.scene.Light;
import dev.twister.scene.Vector3;
import dev.twister.scene.light.Lights;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/**
 * Spheres of which the larger ones come first, in grids, each for spheres of about one size: in that of a large one
 * there would be room for thousands of small ones in a cell.
 */
final class SpherePacking {
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
