package dev.twister.mesh.gltf;

import dev.twister.mesh.Affine;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/**
 * The nodes of a glTF file that something depends on, with all nodes above them: their transforms at any time. Each has
 * ten numbers: translation, rotation as a quaternion, scale.
 */
final class GltfSkeleton {
    static final int ROTATION = 3;
    static final int SCALE = 7;

    private static final int NUMBERS = 10;

    private final Map<Integer, Integer> places = new HashMap<>();
    private final List<Integer> parents = new ArrayList<>();
    private final List<Affine> matrices = new ArrayList<>();
    private final List<Boolean> hasMatrix = new ArrayList<>();
    private final List<double[]> rest = new ArrayList<>();

    /** Adds a node, and those above it that are missing. */
    void add(int node, GltfNodes nodes) {
        List<Integer> missing = new ArrayList<>();
        for (int next = node; next != GltfNodes.NONE && !places.containsKey(next); next = nodes.parent(next)) {
            missing.add(next);
        }
        for (int next : missing.reversed()) {
            GltfPlace place = nodes.at(next);
            parents.add(places.getOrDefault(nodes.parent(next), GltfNodes.NONE));
            places.put(next, places.size());
            matrices.add(GltfTransform.of(place));
            hasMatrix.add(place.at("matrix").exists());
            rest.add(GltfTransform.numbers(place));
        }
    }

    /** The numbers of all nodes at rest. */
    double[] numbers() {
        double[] numbers = new double[NUMBERS * rest.size()];
        for (int place = 0; place < rest.size(); place++) {
            System.arraycopy(rest.get(place), 0, numbers, NUMBERS * place, NUMBERS);
        }
        return numbers;
    }

    boolean has(int node) {
        return places.containsKey(node);
    }

    /** Place of a node's first number. */
    int first(int node) {
        return NUMBERS * places.get(node);
    }

    /** The transform from the coordinates of each node to the file's. */
    Map<Integer, Affine> placements(double[] numbers) {
        List<Affine> placed = new ArrayList<>();
        for (int place = 0; place < parents.size(); place++) {
            Affine own = hasMatrix.get(place) ? matrices.get(place) : GltfTransform.of(numbers, NUMBERS * place);
            placed.add(
                    parents.get(place) == GltfNodes.NONE
                            ? own
                            : placed.get(parents.get(place)).of(own));
        }
        Map<Integer, Affine> placements = new HashMap<>();
        places.forEach((node, place) -> placements.put(node, placed.get(place)));
        return placements;
    }
}
