package dev.twister.mesh.gltf;

import dev.twister.mesh.Affine;
import dev.twister.scene.Vector3;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * The vertices of a primitive at rest: displaced by morph targets, then moved by a skin.
 *
 * @param places morph targets of positions
 * @param normals morph targets of normals
 * @param skin the skin, if there is one
 */
record GltfPosed(GltfMorph places, GltfMorph normals, Optional<Skinned> skin) {
    /** A skin, and how a primitive is bound to it. */
    record Skinned(GltfSkin skin, GltfSkin.Binding binding) {}

    static GltfPosed of(
            GltfPlace root, GltfPlace primitive, GltfPose pose, GltfNodes nodes, GltfAccessors accessors, int vertices)
            throws IOException {
        Optional<Skinned> skin = pose.skin().isPresent()
                ? Optional.of(new Skinned(
                        GltfSkin.of(root, pose.skin().getAsInt(), nodes, accessors),
                        GltfSkin.Binding.of(primitive.at("attributes"), accessors, vertices)))
                : Optional.empty();
        return new GltfPosed(
                GltfMorph.of(primitive, "POSITION", pose.weights(), accessors, vertices),
                GltfMorph.of(primitive, "NORMAL", pose.weights(), accessors, vertices),
                skin);
    }

    Vector3 place(GltfAccessor positions, int vertex) throws IOException {
        Vector3 place = places.moved(vertex, vector(positions, vertex));
        return skin.isPresent() ? movement(vertex).point(place) : place;
    }

    /** The normal; not normalized. */
    Vector3 normal(GltfAccessor accessor, int vertex) throws IOException {
        Vector3 normal = normals.moved(vertex, vector(accessor, vertex));
        return skin.isPresent() ? movement(vertex).normal(normal) : normal;
    }

    /** The direction of a tangent. */
    Vector3 tangent(GltfAccessor tangents, int vertex) throws IOException {
        Vector3 tangent = vector(tangents, vertex);
        return skin.isPresent() ? movement(vertex).direction(tangent).normalized() : tangent;
    }

    private Affine movement(int vertex) throws IOException {
        Skinned skinned = skin.orElseThrow();
        return skinned.skin().movement(skinned.binding(), vertex);
    }

    private static Vector3 vector(GltfAccessor accessor, int vertex) throws IOException {
        return new Vector3(accessor.get(vertex, 0), accessor.get(vertex, 1), accessor.get(vertex, 2));
    }

    /**
     * The morph targets of a primitive that have a weight.
     *
     * @param targets displacements of one attribute
     */
    private record GltfMorph(List<Target> targets) {
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
}
