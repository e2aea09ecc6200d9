package dev.twister.gui.model;

import dev.twister.scene.Vector3;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/** Spheres in a grid whose cells are as wide as the largest of them, so that only neighbours can touch. */
final class SpherePacking {
    private final Map<Cell, List<Placed>> cells = new HashMap<>();
    private final double side;

    private record Cell(long x, long y, long z) {}

    private record Placed(Vector3 center, double radius) {}

    /**
     * An empty packing.
     *
     * @param largest no sphere's radius is larger
     */
    SpherePacking(double largest) {
        side = 2 * largest;
    }

    void add(Vector3 center, double radius) {
        cells.computeIfAbsent(cell(center), _ -> new ArrayList<>()).add(new Placed(center, radius));
    }

    /** Whether a sphere there would touch none. */
    boolean isFree(Vector3 center, double radius) {
        Cell middle = cell(center);
        for (long x = middle.x() - 1; x <= middle.x() + 1; x++) {
            for (long y = middle.y() - 1; y <= middle.y() + 1; y++) {
                for (long z = middle.z() - 1; z <= middle.z() + 1; z++) {
                    for (Placed other : cells.getOrDefault(new Cell(x, y, z), List.of())) {
                        if (touches(other, center, radius)) {
                            return false;
                        }
                    }
                }
            }
        }
        return true;
    }

    private static boolean touches(Placed other, Vector3 center, double radius) {
        double x = other.center().x() - center.x();
        double y = other.center().y() - center.y();
        double z = other.center().z() - center.z();
        double reach = other.radius() + radius;
        return x * x + y * y + z * z <= reach * reach;
    }

    private Cell cell(Vector3 place) {
        return new Cell((long) Math.floor(place.x() / side), (long) Math.floor(place.y() / side), (long)
                Math.floor(place.z() / side));
    }
}
