package dev.twister.mesh.gltf;

import dev.twister.mesh.Affine;
import dev.twister.mesh.MeshException;
import dev.twister.mesh.TriangleMesh;
import dev.twister.mesh.assembly.Axes;
import dev.twister.mesh.assembly.MeshAssembly;
import dev.twister.mesh.assembly.TriangleSoup;
import dev.twister.mesh.input.Bytes;
import dev.twister.mesh.input.MeshLimits;
import dev.twister.mesh.input.TextureLayout;
import dev.twister.mesh.input.Warnings;
import dev.twister.scene.Material;
import java.io.IOException;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/** The meshes of a glTF file; each primitive becomes a separate mesh. */
final class GltfMeshes {
    private static final int TRIANGLES = 4;
    private static final int STRIP = 5;
    private static final int FAN = 6;

    /** Number of components of a color: three or four. */
    private static final int COLOR = 0;

    private static final String DRACO = "KHR_draco_mesh_compression";

    /**
     * A primitive with triangles.
     *
     * @param placement transform from the mesh's coordinates to the primitive's, in Twister's axes
     */
    record Primitive(int mesh, Affine placement, Material material) {}

    /** What the vertices of a primitive have that moves with them. */
    record Attributes(GltfAccessor positions, Optional<GltfAccessor> normals, Optional<GltfAccessor> tangents) {}

    private final Bytes file;
    private final GltfPlace root;
    private final GltfBuffers buffers;
    private final GltfAccessors accessors;
    private final GltfMaterials materials;
    private final double smoothDegrees;
    private final Warnings warnings;
    private final List<TriangleMesh> meshes = new ArrayList<>();
    private final UsedVertices used = new UsedVertices();
    private final GltfNodes nodes;
    private final Map<GltfPose, List<Primitive>> read = new HashMap<>();
    private final Map<Integer, GltfSkin> skins = new HashMap<>();
    private final Map<Integer, GltfDeformed> deformed = new HashMap<>();
    private final boolean isAnimated;
    private long triangles;
    private int degenerateTriangles;

    GltfMeshes(
            Bytes file,
            GltfPlace root,
            GltfBuffers buffers,
            GltfAccessors accessors,
            GltfNodes nodes,
            GltfMaterials materials,
            double smoothDegrees,
            Warnings warnings) {
        this.file = file;
        this.root = root;
        this.buffers = buffers;
        this.accessors = accessors;
        this.nodes = nodes;
        this.isAnimated = root.at("animations").size() > 0;
        this.materials = materials;
        this.smoothDegrees = smoothDegrees;
        this.warnings = warnings;
    }

    List<TriangleMesh> meshes() {
        return meshes;
    }

    /** The meshes whose vertices move, by their number; none in a file without animations. */
    Map<Integer, GltfDeformed> deformed() {
        return deformed;
    }

    int degenerateTriangles() {
        return degenerateTriangles;
    }

    /** The transforms of the instances of a node's mesh to the node's coordinates. */
    List<Affine> instances(GltfPlace node) throws IOException {
        try {
            return GltfInstances.of(node, accessors);
        } catch (MeshException problem) {
            warnings.add(problem, "; shown once");
            return List.of(Affine.IDENTITY);
        }
    }

    /** The primitives of one of the file's meshes in a pose, which are read at the first call. */
    List<Primitive> primitives(GltfPose pose) throws IOException {
        List<Primitive> known = read.get(pose);
        if (known == null) {
            known = new ArrayList<>();
            for (GltfPlace primitive :
                    root.at("meshes").at(pose.mesh()).at("primitives").items()) {
                readPrimitive(primitive, pose).ifPresent(known::add);
            }
            read.put(pose, known);
        }
        return known;
    }

    /** Whether a normal map or a stretched highlight follows the surface's tangents. */
    private static boolean hasTangents(Material material) {
        return material.maps().normal().isPresent()
                || material.finish().clearcoat().normalMap().isPresent()
                || material.finish().anisotropy().strength() > 0;
    }

    private Optional<Primitive> readPrimitive(GltfPlace primitive, GltfPose pose) throws IOException {
        long mode = primitive.at("mode").countOr(TRIANGLES);
        GltfPlace attributes = primitive.at("attributes");
        if (mode < TRIANGLES || mode > FAN || !attributes.at("POSITION").exists()) {
            warnings.add("there are points or lines, or triangles without positions; not read");
            return Optional.empty();
        }
        GltfAccessor positions = accessors.at(attributes.at("POSITION"), 3);
        if (positions.isEmpty()) {
            throw positions
                    .place()
                    .failure(
                            primitive.at("extensions").at(DRACO).exists()
                                    ? "is compressed by " + DRACO
                                            + ", which is not read; export the file without compression"
                                    : "has no bufferView, so that all positions are the same");
        }
        int[] corners = corners(primitive, (int) mode, positions.count());
        GltfMaterials.Textured material = materials.of(primitive);
        boolean bumpy = hasTangents(material.material());
        Optional<GltfAccessor> normals = attribute(attributes.at("NORMAL"), 3, positions);
        Attributes moving = new Attributes(
                positions,
                normals,
                bumpy && normals.isPresent() ? attribute(attributes.at("TANGENT"), 4, positions) : Optional.empty());
        used.set(corners, positions.count());
        Optional<GltfDeformation> deformation = deformation(primitive, pose, moving);
        TriangleSoup soup = soup(primitive, pose, moving, corners, material, deformation);
        soup.traced = isAnimated && deformation.isPresent();
        MeshAssembly.Assembled assembled = MeshAssembly.assemble(soup, Axes.Y_UP, smoothDegrees);
        degenerateTriangles += assembled.degenerateTriangles();
        if (assembled.meshByMaterial().isEmpty()) {
            return Optional.empty();
        }
        if (soup.traced) {
            deformed.put(
                    meshes.size(),
                    new GltfDeformed(
                            deformation.orElseThrow(),
                            pose,
                            assembled.center(),
                            soup.vertexPositions.toArray(),
                            soup.vertexNormals.toArray()));
        }
        meshes.add(assembled.meshByMaterial().firstEntry().getValue());
        return Optional.of(new Primitive(meshes.size() - 1, assembled.placement(), material.material()));
    }

    private Optional<GltfAccessor> attribute(GltfPlace number, int components, GltfAccessor positions)
            throws IOException {
        if (!number.exists()) {
            return Optional.empty();
        }
        GltfAccessor accessor = components == COLOR ? accessors.ofColors(number) : accessors.at(number, components);
        if (accessor.count() != positions.count()) {
            throw accessor.place()
                    .failure("has " + accessor.count() + " elements, but the positions beside it are "
                            + positions.count());
        }
        return Optional.of(accessor);
    }

    /** What moves the vertices of a primitive, at rest or in animations; empty if nothing does. */
    private Optional<GltfDeformation> deformation(GltfPlace primitive, GltfPose pose, Attributes attributes)
            throws IOException {
        boolean morphs = primitive.at("targets").size() > 0
                && (pose.node().isPresent() || pose.weights().stream().anyMatch(weight -> weight != 0));
        return pose.skin().isPresent() || morphs
                ? Optional.of(GltfDeformation.of(primitive, accessors, attributes, used.vertices(), skin(pose)))
                : Optional.empty();
    }

    private Optional<GltfSkin> skin(GltfPose pose) throws IOException {
        if (pose.skin().isEmpty()) {
            return Optional.empty();
        }
        int number = pose.skin().getAsInt();
        if (!skins.containsKey(number)) {
            skins.put(number, GltfSkin.of(root, number, accessors));
        }
        return Optional.of(skins.get(number));
    }

    private TriangleSoup soup(
            GltfPlace primitive,
            GltfPose pose,
            Attributes moving,
            int[] corners,
            GltfMaterials.Textured material,
            Optional<GltfDeformation> deformation)
            throws IOException {
        GltfPlace attributes = primitive.at("attributes");
        GltfAccessor positions = moving.positions();
        Optional<GltfAccessor> colors = attribute(attributes.at("COLOR_0"), COLOR, positions);
        if (attributes.at("COLOR_1").exists()) {
            warnings.add("there are several colors for each vertex; the first are read");
        }
        TriangleSoup soup = new TriangleSoup(used.vertices().length, corners.length / 3);
        if (deformation.isPresent()) {
            List<Affine> movements = deformation
                    .get()
                    .binding()
                    .map(binding -> binding.skin().movements(nodes::placement))
                    .orElse(List.of());
            addMoved(soup, deformation.get().moved(pose.weightArray(), movements));
        } else {
            addStill(soup, moving, used.vertices());
        }
        soup.warnOfUnusable(warnings);
        addCoordinates(soup, attributes, positions, material.coordinates());
        if (colors.isPresent()) {
            addColors(soup, colors.get(), used.vertices());
        }
        if (moving.tangents().isPresent()) {
            for (int vertex : used.vertices()) {
                soup.tangentSigns.add(moving.tangents().get().get(vertex, 3) < 0 ? -1 : 1);
            }
        }
        for (int i = 0; i < corners.length; i += 3) {
            soup.triangle(used.number(corners[i]), used.number(corners[i + 1]), used.number(corners[i + 2]));
        }
        return soup;
    }

    private static void addMoved(TriangleSoup soup, GltfDeformation.Moved moved) {
        double[] positions = moved.positions();
        for (int at = 0; at < positions.length; at += 3) {
            addPosition(soup, positions[at], positions[at + 1], positions[at + 2]);
        }
        double[] normals = moved.normals();
        for (int at = 0; at < normals.length; at += 3) {
            soup.normal(normals[at], normals[at + 1], normals[at + 2]);
        }
        double[] tangents = moved.tangents();
        for (int at = 0; at < tangents.length; at += 3) {
            double length = Math.sqrt(tangents[at] * tangents[at]
                    + tangents[at + 1] * tangents[at + 1]
                    + tangents[at + 2] * tangents[at + 2]);
            for (int axis = 0; axis < 3; axis++) {
                addTangent(soup, tangents[at + axis] / length);
            }
        }
    }

    /** One attribute after the other, because each usually has its own region in the file. */
    private static void addStill(TriangleSoup soup, Attributes attributes, int[] used) throws IOException {
        GltfAccessor positions = attributes.positions();
        for (int vertex : used) {
            addPosition(soup, positions.get(vertex, 0), positions.get(vertex, 1), positions.get(vertex, 2));
        }
        if (attributes.normals().isPresent()) {
            GltfAccessor normals = attributes.normals().get();
            for (int vertex : used) {
                soup.normal(normals.get(vertex, 0), normals.get(vertex, 1), normals.get(vertex, 2));
            }
        }
        if (attributes.tangents().isPresent()) {
            for (int vertex : used) {
                for (int axis = 0; axis < 3; axis++) {
                    addTangent(soup, attributes.tangents().get().get(vertex, axis));
                }
            }
        }
    }

    private static void addTangent(TriangleSoup soup, double value) {
        soup.tangents.add(Math.abs(value) <= 2 ? (float) value : 0);
    }

    private void addCoordinates(
            TriangleSoup soup, GltfPlace attributes, GltfAccessor positions, List<GltfTextures.Coordinates> needed)
            throws IOException {
        List<Optional<GltfAccessor>> sets = new ArrayList<>();
        for (GltfTextures.Coordinates set : needed) {
            sets.add(attribute(attributes.at("TEXCOORD_" + set.set()), 2, positions));
        }
        if (sets.stream().noneMatch(Optional::isPresent)) {
            return;
        }
        for (int number = 0; number < sets.size(); number++) {
            TextureLayout layout = needed.get(number).layout();
            for (int vertex : used.vertices()) {
                double u = sets.get(number).isPresent() ? sets.get(number).get().get(vertex, 0) : 0;
                double v = sets.get(number).isPresent() ? sets.get(number).get().get(vertex, 1) : 0;
                if (number == 0) {
                    soup.textureCoordinates(layout.u(u, v), layout.v(u, v));
                } else {
                    soup.furtherCoordinates(number, layout.u(u, v), layout.v(u, v));
                }
            }
        }
    }

    private static void addColors(TriangleSoup soup, GltfAccessor colors, int[] used) throws IOException {
        for (int vertex : used) {
            double opacity = colors.hasFourComponents() ? colors.get(vertex, 3) : 1;
            soup.color(colors.get(vertex, 0), colors.get(vertex, 1), colors.get(vertex, 2), opacity);
        }
    }

    private static void addPosition(TriangleSoup soup, double x, double y, double z) {
        if (MeshLimits.areCoordinates(x, y, z)) {
            soup.position(x, y, z);
        } else {
            soup.missingPosition();
        }
    }

    /** Three vertex numbers per triangle, for triangle lists, strips and fans. */
    private int[] corners(GltfPlace primitive, int mode, int vertices) throws IOException {
        GltfPlace number = primitive.at("indices");
        Optional<GltfAccessor> indices = number.exists() ? Optional.of(accessors.at(number, 1)) : Optional.empty();
        int count = indices.map(GltfAccessor::count).orElse(vertices);
        int triangleCount = mode == TRIANGLES ? count / 3 : Math.max(0, count - 2);
        triangles += triangleCount;
        if (triangles > MeshLimits.TRIANGLES) {
            throw primitive.failure("brings the file to " + MeshLimits.tooManyTriangles(triangles));
        }
        if (triangles > MeshLimits.trianglesOf(file.length() + buffers.openedBytes())) {
            throw primitive.failure("brings the file to " + triangles + " triangles, too many for its "
                    + (file.length() + buffers.openedBytes()) + " bytes; its primitives share their data");
        }
        int[] listed = new int[mode == TRIANGLES ? 3 * triangleCount : count];
        for (int i = 0; i < listed.length; i++) {
            double index = indices.isPresent() ? indices.get().get(i, 0) : i;
            if (!(index >= 0 && index < vertices) || index != (int) index) {
                throw indices.orElseThrow()
                        .place()
                        .failure("has the vertex " + (long) index + "; there are " + vertices);
            }
            listed[i] = (int) index;
        }
        return mode == TRIANGLES ? listed : unrolled(listed, mode, triangleCount);
    }

    private static int[] unrolled(int[] listed, int mode, int triangleCount) {
        int[] corners = new int[3 * triangleCount];
        for (int i = 0; i < triangleCount; i++) {
            boolean odd = mode == STRIP && i % 2 == 1;
            corners[3 * i] = listed[mode == FAN ? 0 : odd ? i + 1 : i];
            corners[3 * i + 1] = listed[odd ? i : i + 1];
            corners[3 * i + 2] = listed[i + 2];
        }
        return corners;
    }
}
