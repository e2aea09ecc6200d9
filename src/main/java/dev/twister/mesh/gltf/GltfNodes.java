package dev.twister.mesh.gltf;

import dev.twister.mesh.Affine;
import java.util.ArrayDeque;
import java.util.Arrays;
import java.util.Deque;
import java.util.HashMap;
import java.util.Map;

/** The nodes of a glTF file with their transforms at rest, whether the scene shows them or not. */
final class GltfNodes {
    static final int NONE = -1;

    private final GltfPlace nodes;
    private final int[] parents;
    private final Map<Integer, Affine> placements = new HashMap<>();

    GltfNodes(GltfPlace nodes) {
        this.nodes = nodes;
        parents = new int[nodes.size()];
        Arrays.fill(parents, NONE);
        for (int node = 0; node < parents.length; node++) {
            for (GltfPlace child : nodes.at(node).at("children").items()) {
                parents[child.index(nodes)] = node;
            }
        }
    }

    GltfPlace at(int node) {
        return nodes.at(node);
    }

    /** The node that has it as a child, or {@link #NONE}. */
    int parent(int node) {
        return parents[node];
    }

    /** The transform from a node's coordinates to the file's. */
    Affine placement(int node) {
        Deque<Integer> below = new ArrayDeque<>();
        int above = node;
        while (above != NONE && !placements.containsKey(above)) {
            if (below.size() > parents.length) {
                throw nodes.at(node).failure("is its own ancestor; nodes must form a tree");
            }
            below.push(above);
            above = parents[above];
        }
        Affine placement = above == NONE ? Affine.IDENTITY : placements.get(above);
        for (int next : below) {
            placement = placement.of(GltfTransform.of(nodes.at(next)));
            placements.put(next, placement);
        }
        return placement;
    }
}
