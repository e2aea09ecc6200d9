package dev.twister.mesh.gltf;

import dev.twister.mesh.MeshException;
import dev.twister.mesh.input.QuotedText;
import dev.twister.mesh.input.Warnings;
import java.util.ArrayList;
import java.util.BitSet;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.IntStream;

/** Which nodes of a glTF file are shown. */
final class GltfScenes {
    private GltfScenes() {}

    /**
     * The roots of the visible nodes: those of a scene, or all nodes without a parent if the file has no scenes.
     *
     * @param wanted the scene's name or number; empty for the default one, else the first
     * @throws MeshException if there is no such scene; the message lists them
     */
    static List<Integer> roots(GltfPlace root, String wanted, Warnings warnings) {
        GltfPlace scenes = root.at("scenes");
        GltfPlace nodes = root.at("nodes");
        if (scenes.size() == 0 && wanted.isEmpty()) {
            return withoutParent(nodes);
        }
        return indices(scene(root, wanted, warnings).at("nodes"), nodes);
    }

    static List<Integer> indices(GltfPlace list, GltfPlace nodes) {
        return list.items().stream().map(number -> number.index(nodes)).toList();
    }

    private static GltfPlace scene(GltfPlace root, String wanted, Warnings warnings) {
        GltfPlace scenes = root.at("scenes");
        if (wanted.isEmpty()) {
            boolean chosen = root.at("scene").exists();
            if (scenes.size() > 1) {
                warnings.add("there are several scenes: " + list(scenes) + "; the " + (chosen ? "default" : "first")
                        + " one is read");
            }
            return chosen ? root.at("scene").in(scenes) : scenes.at(0);
        }
        for (GltfPlace scene : scenes.items()) {
            if (scene.at("name").textOr("").equals(wanted)) {
                return scene;
            }
        }
        for (int index = 0; index < scenes.size(); index++) {
            if (wanted.equals(Integer.toString(index))) {
                return scenes.at(index);
            }
        }
        throw scenes.failure(
                scenes.size() == 0
                        ? "has no scenes, but " + QuotedText.text(wanted) + " is asked for"
                        : "has no scene " + QuotedText.text(wanted) + "; expected one of: " + list(scenes));
    }

    private static String list(GltfPlace scenes) {
        return IntStream.range(0, scenes.size())
                .mapToObj(index -> name(scenes.at(index), index))
                .collect(Collectors.joining(", "));
    }

    private static String name(GltfPlace scene, int index) {
        String name = scene.at("name").textOr("");
        return name.isEmpty() ? Integer.toString(index) : index + " (" + QuotedText.text(name) + ")";
    }

    private static List<Integer> withoutParent(GltfPlace nodes) {
        BitSet children = new BitSet();
        for (GltfPlace node : nodes.items()) {
            for (GltfPlace child : node.at("children").items()) {
                children.set(child.index(nodes));
            }
        }
        List<Integer> roots = new ArrayList<>();
        for (int node = children.nextClearBit(0); node < nodes.size(); node = children.nextClearBit(node + 1)) {
            roots.add(node);
        }
        return roots;
    }
}
