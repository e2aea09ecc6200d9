package dev.twister.mesh.gltf;

import dev.twister.mesh.Affine;
import dev.twister.mesh.input.MeshLimits;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** The instances of a node's mesh: {@code EXT_mesh_gpu_instancing}. */
final class GltfInstances {
    static final String EXTENSION = "EXT_mesh_gpu_instancing";

    private GltfInstances() {}

    /** Their transforms to the node's coordinates: one that changes nothing for a node without the extension. */
    static List<Affine> of(GltfPlace node, GltfAccessors accessors) throws IOException {
        GltfPlace attributes = node.at("extensions").at(EXTENSION).at("attributes");
        Optional<GltfAccessor> translations = accessor(attributes.at("TRANSLATION"), 3, accessors);
        Optional<GltfAccessor> rotations = accessor(attributes.at("ROTATION"), 4, accessors);
        Optional<GltfAccessor> scales = accessor(attributes.at("SCALE"), 3, accessors);
        Optional<GltfAccessor> first = translations.or(() -> rotations).or(() -> scales);
        if (first.isEmpty()) {
            return List.of(Affine.IDENTITY);
        }
        int count = first.get().count();
        if (count > MeshLimits.PARTS) {
            throw first.get().place().failure("has " + count + " instances; at most " + MeshLimits.PARTS + " are read");
        }
        List<Affine> instances = new ArrayList<>();
        for (int i = 0; i < count; i++) {
            instances.add(GltfTransform.of(
                    values(translations, i, 0, 0, 0), values(rotations, i, 0, 0, 0, 1), values(scales, i, 1, 1, 1)));
        }
        return instances;
    }

    private static Optional<GltfAccessor> accessor(GltfPlace number, int components, GltfAccessors accessors)
            throws IOException {
        return number.exists() ? Optional.of(accessors.at(number, components)) : Optional.empty();
    }

    private static double[] values(Optional<GltfAccessor> accessor, int index, double... fallback) throws IOException {
        if (accessor.isEmpty()) {
            return fallback;
        }
        if (index >= accessor.get().count()) {
            throw accessor.get().place().failure("has fewer instances than the accessors beside it");
        }
        double[] values = new double[fallback.length];
        for (int i = 0; i < values.length; i++) {
            values[i] = accessor.get().get(index, i);
        }
        return values;
    }
}
