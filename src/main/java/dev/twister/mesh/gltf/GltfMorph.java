package dev.twister.mesh.gltf;

import dev.twister.scene.Vector3;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;

/**
 * The morph targets of a primitive that have a weight.
 *
 * @param targets displacements of one attribute
 */
record GltfMorph(List<Target> targets) {
    /** Displacements of all vertices, and their factor. */
    record Target(GltfAccessor displacements, double weight) {}

    GltfMorph {
        targets = List.copyOf(targets);
    }

    /**
     * The targets of an attribute.
     *
     * @param weights one per target; missing ones are 0
     * @param vertices their number
     */
    static GltfMorph of(
            GltfPlace primitive, String attribute, List<Double> weights, GltfAccessors accessors, int vertices)
            throws IOException {
        List<Target> targets = new ArrayList<>();
        GltfPlace places = primitive.at("targets");
        for (int i = 0; i < Math.min(places.size(), weights.size()); i++) {
            GltfPlace number = places.at(i).at(attribute);
            if (weights.get(i) != 0 && number.exists()) {
                GltfAccessor displacements = accessors.at(number, 3);
                if (displacements.count() != vertices) {
                    throw displacements
                            .place()
                            .failure("has " + displacements.count() + " elements, but the primitive has " + vertices
                                    + " vertices");
                }
                targets.add(new Target(displacements, weights.get(i)));
            }
        }
        return new GltfMorph(targets);
    }

    /** A vertex's position or normal, displaced. */
    Vector3 moved(int vertex, Vector3 place) throws IOException {
        Vector3 moved = place;
        for (Target target : targets) {
            GltfAccessor by = target.displacements();
            moved = moved.plus(
                    new Vector3(by.get(vertex, 0), by.get(vertex, 1), by.get(vertex, 2)).times(target.weight()));
        }
        return moved;
    }
}
