package dev.twister.mesh.gltf;

import dev.twister.mesh.Affine;
import dev.twister.mesh.MeshException;
import dev.twister.mesh.MeshFile;
import dev.twister.mesh.MeshPart;
import dev.twister.mesh.MeshRig;
import dev.twister.mesh.assembly.MeshAssembly;
import dev.twister.mesh.input.Bytes;
import dev.twister.mesh.input.MeshLimits;
import dev.twister.mesh.input.QuotedText;
import dev.twister.mesh.input.Warnings;
import dev.twister.scene.Geometry;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.BitSet;
import java.util.Deque;
import java.util.List;
import java.util.Optional;
import java.util.Set;

/** Reads glTF 2.0 files, as JSON or GLB. */
public final class GltfReader {
    private static final Set<String> READ = Set.of(
            "EXT_meshopt_compression",
            "KHR_meshopt_compression",
            "KHR_materials_anisotropy",
            "KHR_materials_clearcoat",
            "KHR_materials_diffuse_transmission",
            "KHR_materials_dispersion",
            "KHR_materials_emissive_strength",
            "KHR_materials_ior",
            "KHR_materials_iridescence",
            "KHR_materials_pbrSpecularGlossiness",
            "KHR_materials_sheen",
            "KHR_materials_specular",
            "KHR_materials_transmission",
            "KHR_materials_unlit",
            "KHR_materials_volume",
            GltfImages.WEBP,
            GltfSurroundings.LIGHTS,
            "KHR_mesh_quantization",
            GltfInstances.EXTENSION,
            "KHR_texture_transform");

    /**
     * Starts of the names of extensions that describe no triangles, but looks, images, lights, sounds, behavior and
     * notes. A file is read without them, even where it requires them.
     */
    private static final List<String> WITHOUT_GEOMETRY = List.of(
            "KHR_materials_",
            "KHR_texture_",
            "EXT_texture_",
            "MSFT_texture_",
            "MSFT_packing_",
            "ADOBE_materials_",
            "KHR_techniques_webgl",
            "KHR_lights_",
            "EXT_lights_",
            "KHR_xmp",
            "KHR_animation_pointer",
            "KHR_audio",
            "KHR_interactivity",
            "KHR_node_hoverability",
            "KHR_node_selectability",
            "KHR_physics_",
            "EXT_structural_metadata",
            "EXT_mesh_features",
            "EXT_instance_features",
            "EXT_feature_metadata",
            "AGI_");

    private final Geometry.OfFile source;
    private final Path file;
    private final Bytes bytes;
    private final double smoothDegrees;
    private final Warnings warnings;
    private final List<MeshPart> parts = new ArrayList<>();
    private final List<GltfRig.Part> moving = new ArrayList<>();

    private Set<Integer> morphed = Set.of();

    /**
     * A node.
     *
     * @param placement transform to the file's coordinates, from the parent's while it waits, then from its own
     */
    private record Placed(int node, Affine placement) {
        /** In place of a node whose mesh is placed by joints, or of none. */
        static final Placed SKINNED = new Placed(GltfNodes.NONE, Affine.IDENTITY);

        Optional<Integer> number() {
            return node == GltfNodes.NONE ? Optional.empty() : Optional.of(node);
        }
    }

    public GltfReader(Geometry.OfFile source, Bytes bytes, double smoothDegrees, Warnings warnings) {
        this.source = source;
        file = source.path();
        this.bytes = bytes;
        this.smoothDegrees = smoothDegrees;
        this.warnings = warnings;
    }

    public MeshFile read() throws IOException {
        GltfDocument document = GltfDocument.read(bytes);
        GltfPlace root = document.root();
        checkVersion(root);
        checkExtensions(root);
        try (GltfBuffers buffers = new GltfBuffers(file, bytes, document)) {
            GltfImages images = new GltfImages(file, bytes, root, buffers, warnings);
            GltfAccessors accessors = new GltfAccessors(root, buffers);
            GltfNodes nodes = new GltfNodes(root.at("nodes"));
            GltfMeshes meshes = new GltfMeshes(
                    bytes,
                    root,
                    buffers,
                    accessors,
                    nodes,
                    new GltfMaterials(root, images, warnings),
                    smoothDegrees,
                    warnings);
            GltfSurroundings surroundings = new GltfSurroundings(root, warnings);
            placeAll(root, meshes, surroundings);
            if (parts.isEmpty()) {
                throw MeshAssembly.noTriangles(bytes, meshes.degenerateTriangles());
            }
            return new MeshFile(
                    meshes.meshes(),
                    parts,
                    images.embedded(),
                    meshes.degenerateTriangles(),
                    surroundings.all(),
                    rig(root, meshes, accessors, nodes, surroundings.carriers()));
        }
    }

    private static void checkVersion(GltfPlace root) {
        GltfPlace version = root.at("asset").at("version");
        if (!version.text().startsWith("2.")) {
            throw version.failure("is " + QuotedText.text(version.text()) + "; glTF 2.0 is read");
        }
    }

    private void checkExtensions(GltfPlace root) {
        for (GltfPlace required : root.at("extensionsRequired").items()) {
            String name = required.text();
            if (!READ.contains(name) && WITHOUT_GEOMETRY.stream().noneMatch(name::startsWith)) {
                throw required.failure("is " + QuotedText.text(name) + ", which is not read; " + advice(name));
            }
        }
        for (GltfPlace used : root.at("extensionsUsed").items()) {
            if (!READ.contains(used.text())) {
                warnings.add("the extension " + QuotedText.text(used.text()) + " is not read" + lost(used.text()));
            }
        }
    }

    private static String advice(String extension) {
        return extension.equals("KHR_draco_mesh_compression")
                ? "decompress the file: npx @gltf-transform/cli copy FILE OUTPUT"
                : "export the file without it";
    }

    private static String lost(String extension) {
        String loss = extension.contains("material") || extension.contains("texture")
                ? "; the colors that it gives are lost"
                : "";
        return switch (extension) {
            case "EXT_texture_avif" -> loss + "; convert: npx @gltf-transform/cli png FILE OUTPUT";
            case "KHR_texture_basisu" -> loss + "; convert: npx @gltf-transform/cli ktxdecompress FILE OUTPUT";
            default -> loss;
        };
    }

    /** What moves in the file's animations. */
    private MeshRig rig(
            GltfPlace root,
            GltfMeshes meshes,
            GltfAccessors accessors,
            GltfNodes nodes,
            GltfSurroundings.Carriers carriers)
            throws IOException {
        if (root.at("animations").size() == 0) {
            return MeshRig.NONE;
        }
        GltfSkeleton skeleton = new GltfSkeleton();
        for (GltfRig.Part part : moving) {
            part.node().ifPresent(node -> skeleton.add(node, nodes));
        }
        for (GltfDeformed deformed : meshes.deformed().values()) {
            deformed.deformation()
                    .binding()
                    .ifPresent(binding -> binding.skin().joints().forEach(joint -> skeleton.add(joint, nodes)));
        }
        carriers.lights().forEach(node -> skeleton.add(node, nodes));
        carriers.cameras().forEach(node -> skeleton.add(node, nodes));
        return new GltfRig(GltfAnimation.all(root, accessors, warnings), skeleton, moving, meshes.deformed(), carriers);
    }

    private void placeAll(GltfPlace root, GltfMeshes meshes, GltfSurroundings surroundings) throws IOException {
        GltfPlace nodes = root.at("nodes");
        morphed = GltfAnimation.morphed(root);
        Deque<Placed> waiting = new ArrayDeque<>();
        BitSet reached = new BitSet();
        reach(GltfScenes.roots(root, source.scene(), warnings), nodes, Affine.IDENTITY, waiting, reached);
        while (!waiting.isEmpty()) {
            Placed next = waiting.pop();
            GltfPlace node = nodes.at(next.node());
            Affine placement = next.placement().of(GltfTransform.of(node));
            if (node.at("mesh").exists()) {
                placePosed(next.node(), placement, root, meshes);
            }
            surroundings.add(node, next.node(), GltfTransform.turned(placement));
            reach(GltfScenes.indices(node.at("children"), nodes), nodes, placement, waiting, reached);
        }
        if (nodes.size() == 0) {
            for (int mesh = 0; mesh < root.at("meshes").size(); mesh++) {
                place(
                        root.at("meshes").at(mesh),
                        Placed.SKINNED,
                        Affine.IDENTITY,
                        GltfPose.of(root, mesh),
                        root,
                        meshes);
            }
        }
    }

    private static void reach(
            List<Integer> numbers, GltfPlace nodes, Affine parent, Deque<Placed> waiting, BitSet reached) {
        // The stack reverses the order: the first node must be placed first.
        for (int node : numbers.reversed()) {
            if (reached.get(node)) {
                throw nodes.at(node).failure("is in the scene twice, or its own ancestor; nodes must form a tree");
            }
            reached.set(node);
            waiting.push(new Placed(node, parent));
        }
    }

    /** Places a node's mesh: by the joints of its skin, or else by the node's own transform. */
    private void placePosed(int number, Affine placement, GltfPlace root, GltfMeshes meshes) throws IOException {
        GltfPlace node = root.at("nodes").at(number);
        GltfPose pose = GltfPose.of(root, number, morphed);
        if (pose.skin().isPresent()) {
            try {
                place(node, Placed.SKINNED, Affine.IDENTITY, pose, root, meshes);
                return;
            } catch (MeshException problem) {
                warnings.add(problem, "; shown without its skin");
            }
        }
        for (Affine instance : meshes.instances(node)) {
            place(node, new Placed(number, placement), instance, pose.withoutSkin(), root, meshes);
        }
    }

    private void place(GltfPlace node, Placed above, Affine instance, GltfPose pose, GltfPlace root, GltfMeshes meshes)
            throws IOException {
        Affine turned = GltfTransform.turned(above.placement().of(instance));
        boolean mayMove = root.at("animations").size() > 0 && GltfTransform.isNear(turned);
        if (!mayMove && !GltfTransform.isUsable(turned)) {
            warnings.add(node + " is flat, or far too large; not read");
            return;
        }
        GltfPlace source = root.at("meshes").at(pose.mesh());
        String name = node.at("name").textOr(source.at("name").textOr(""));
        for (GltfMeshes.Primitive primitive : meshes.primitives(pose)) {
            if (parts.size() == MeshLimits.PARTS) {
                throw node.failure("brings the file to more than " + MeshLimits.PARTS + " parts; join its meshes");
            }
            parts.add(new MeshPart(name, primitive.mesh(), turned.of(primitive.placement()), primitive.material()));
            moving.add(new GltfRig.Part(above.number(), instance, primitive.placement()));
        }
    }
}
