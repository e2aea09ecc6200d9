package dev.twister.mesh.gltf;

import dev.twister.mesh.Affine;
import dev.twister.scene.Vector3;
import java.io.IOException;
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
}
