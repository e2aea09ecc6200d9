package dev.twister.mesh.gltf;

import dev.twister.mesh.MeshException;
import dev.twister.mesh.input.QuotedText;
import dev.twister.mesh.input.Warnings;
import java.io.IOException;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;

/**
 * An animation of a glTF file.
 *
 * @param seconds the time of its last key
 */
record GltfAnimation(String name, double seconds, List<Channel> channels) {
    private static final String WEIGHTS = "weights";

    /**
     * What changes one property of a node.
     *
     * @param first place of the property among the numbers of {@link GltfSkeleton}; 0 for weights
     */
    record Channel(int node, boolean isOfWeights, int first, GltfSampler sampler) {}

    GltfAnimation {
        channels = List.copyOf(channels);
    }

    /** The nodes whose weights of morph targets some animation changes. */
    static Set<Integer> morphed(GltfPlace root) {
        Set<Integer> nodes = new HashSet<>();
        for (GltfPlace animation : root.at("animations").items()) {
            for (GltfPlace channel : animation.at("channels").items()) {
                GltfPlace target = channel.at("target");
                if (target.at("path").textOr("").equals(WEIGHTS)
                        && target.at("node").exists()
                        && target.at("node").isIndex(root.at("nodes"))) {
                    nodes.add(target.at("node").index(root.at("nodes")));
                }
            }
        }
        return nodes;
    }

    /** The animations of a file. One that cannot be played has no channels, and is told. */
    static List<GltfAnimation> all(GltfPlace root, GltfAccessors accessors, Warnings warnings) throws IOException {
        List<GltfAnimation> animations = new ArrayList<>();
        GltfSampler.Values values = new GltfSampler.Values(accessors);
        for (GltfPlace animation : root.at("animations").items()) {
            String name = animation.at("name").textOr("");
            try {
                animations.add(of(animation, name, root, values, warnings));
            } catch (MeshException problem) {
                warnings.add(problem, "; the animation is not played, and the mesh is shown at rest");
                animations.add(new GltfAnimation(name, 0, List.of()));
            }
        }
        return animations;
    }

    private static GltfAnimation of(
            GltfPlace animation, String name, GltfPlace root, GltfSampler.Values values, Warnings warnings)
            throws IOException {
        List<Channel> channels = new ArrayList<>();
        Map<List<Integer>, GltfSampler> samplers = new HashMap<>();
        double seconds = 0;
        for (GltfPlace channel : animation.at("channels").items()) {
            GltfPlace target = channel.at("target");
            String path = target.at("path").text();
            if (path.equals("pointer") || !target.at("node").exists()) {
                warnings.add("an animation changes other things than nodes; not played");
                continue;
            }
            int node = target.at("node").index(root.at("nodes"));
            int first = first(target.at("path"), path, root.at("nodes").at(node));
            int elements = path.equals(WEIGHTS) ? 1 : path.equals("rotation") ? 4 : 3;
            int components = path.equals(WEIGHTS) ? targets(root, node, target) : elements;
            int number = channel.at("sampler").index(animation.at("samplers"));
            List<Integer> key = List.of(number, components, elements);
            GltfSampler sampler = samplers.get(key);
            if (sampler == null) {
                sampler = GltfSampler.of(animation.at("samplers").at(number), components, elements, values);
                samplers.put(key, sampler);
            }
            seconds = Math.max(seconds, sampler.seconds());
            channels.add(new Channel(node, path.equals(WEIGHTS), first, sampler));
        }
        return new GltfAnimation(name, seconds, channels);
    }

    private static int first(GltfPlace place, String path, GltfPlace node) {
        if (!path.equals(WEIGHTS) && node.at("matrix").exists()) {
            throw place.failure("is " + path + ", but " + node + " has a matrix");
        }
        return switch (path) {
            case "translation", WEIGHTS -> 0;
            case "rotation" -> GltfSkeleton.ROTATION;
            case "scale" -> GltfSkeleton.SCALE;
            default ->
                throw place.failure(
                        "is " + QuotedText.text(path) + "; expected translation, rotation, scale or weights");
        };
    }

    /** The number of the morph targets of a node's mesh. */
    private static int targets(GltfPlace root, int node, GltfPlace target) {
        GltfPlace mesh = root.at("nodes").at(node).at("mesh");
        if (!mesh.exists()) {
            throw target.failure("has weights for a node without a mesh");
        }
        int targets =
                mesh.in(root.at("meshes")).at("primitives").at(0).at("targets").size();
        if (targets == 0) {
            throw target.failure("has weights for a mesh without morph targets");
        }
        return targets;
    }
}
