package dev.twister.mesh.gltf;

import dev.twister.mesh.Affine;
import java.util.Arrays;

/** The nodes of a glTF file with their transforms, whether the scene shows them or not. */
final class GltfNodes {
    private static final int NONE = -1;

    private final GltfPlace nodes;
    private final int[] parents;

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

    /** The transform from a node's coordinates to the file's. */
    Affine placement(int node) {
        Affine placement = GltfTransform.of(nodes.at(node));
        int steps = 0;
        for (int parent = parents[node]; parent != NONE; parent = parents[parent]) {
            if (++steps > parents.length) {
                throw nodes.at(node).failure("is its own ancestor; nodes must form a tree");
            }
            placement = GltfTransform.of(nodes.at(parent)).of(placement);
        }
        return placement;
    }
}
