package dev.twister.mesh.gltf;

import java.util.ArrayList;
import java.util.List;
import java.util.OptionalInt;
import java.util.Set;

/**
 * A mesh as a node shows it at rest.
 *
 * @param mesh its number in the file
 * @param skin the number of the skin that moves its vertices
 * @param weights of its morph targets; missing ones are 0
 * @param node the node, if an animation changes its weights
 */
record GltfPose(int mesh, OptionalInt skin, List<Double> weights, OptionalInt node) {
    GltfPose {
        weights = List.copyOf(weights);
    }

    /** The pose of a mesh without a node. */
    static GltfPose of(GltfPlace root, int mesh) {
        return new GltfPose(mesh, OptionalInt.empty(), weights(root.at("meshes").at(mesh)), OptionalInt.empty());
    }

    /**
     * The pose of a node's mesh.
     *
     * @param morphed the nodes whose weights an animation changes
     */
    static GltfPose of(GltfPlace root, int number, Set<Integer> morphed) {
        GltfPlace node = root.at("nodes").at(number);
        int mesh = node.at("mesh").index(root.at("meshes"));
        OptionalInt skin = node.at("skin").exists()
                ? OptionalInt.of(node.at("skin").index(root.at("skins")))
                : OptionalInt.empty();
        GltfPlace source =
                node.at("weights").exists() ? node : root.at("meshes").at(mesh);
        return new GltfPose(
                mesh, skin, weights(source), morphed.contains(number) ? OptionalInt.of(number) : OptionalInt.empty());
    }

    GltfPose withoutSkin() {
        return new GltfPose(mesh, OptionalInt.empty(), weights, node);
    }

    double[] weightArray() {
        return weights.stream().mapToDouble(Double::doubleValue).toArray();
    }

    private static List<Double> weights(GltfPlace source) {
        List<Double> weights = new ArrayList<>();
        for (GltfPlace weight : source.at("weights").items()) {
            weights.add(weight.number());
        }
        return weights;
    }
}
