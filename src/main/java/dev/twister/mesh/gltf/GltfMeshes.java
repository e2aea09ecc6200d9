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
import dev.twister.scene.Vector3;
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
    private long triangles;
    private int degenerateTriangles;

    GltfMeshes(
            Bytes file,
            GltfPlace root,
            GltfBuffers buffers,
            GltfMaterials materials,
            double smoothDegrees,
            Warnings warnings) {
        this.file = file;
        this.root = root;
        this.buffers = buffers;
        this.accessors = new GltfAccessors(root, buffers);
        this.nodes = new GltfNodes(root.at("nodes"));
        this.materials = materials;
        this.smoothDegrees = smoothDegrees;
        this.warnings = warnings;
    }

    List<TriangleMesh> meshes() {
        return meshes;
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
        MeshAssembly.Assembled assembled =
                MeshAssembly.assemble(soup(primitive, pose, positions, corners, material), Axes.Y_UP, smoothDegrees);
        degenerateTriangles += assembled.degenerateTriangles();
        if (assembled.meshByMaterial().isEmpty()) {
            return Optional.empty();
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

    private TriangleSoup soup(
            GltfPlace primitive, GltfPose pose, GltfAccessor positions, int[] corners, GltfMaterials.Textured material)
            throws IOException {
        GltfPlace attributes = primitive.at("attributes");
        GltfPosed posed = GltfPosed.of(root, primitive, pose, nodes, accessors, positions.count());
        Optional<GltfAccessor> normals = attribute(attributes.at("NORMAL"), 3, positions);
        Optional<GltfAccessor> colors = attribute(attributes.at("COLOR_0"), COLOR, positions);
        boolean bumpy = material.material().maps().normal().isPresent();
        Optional<GltfAccessor> tangents =
                bumpy && normals.isPresent() ? attribute(attributes.at("TANGENT"), 4, positions) : Optional.empty();
        if (attributes.at("COLOR_1").exists()) {
            warnings.add("there are several colors for each vertex; the first are read");
        }
        used.set(corners, positions.count());
        TriangleSoup soup = new TriangleSoup(used.vertices().length, corners.length / 3);
        // One attribute after the other, because each usually has its own region in the file.
        for (int vertex : used.vertices()) {
            addPosition(soup, posed.place(positions, vertex));
        }
        soup.warnOfUnusable(warnings);
        if (normals.isPresent()) {
            addNormals(soup, posed, normals.get(), used.vertices());
        }
        addCoordinates(soup, attributes, positions, material.coordinates());
        if (colors.isPresent()) {
            addColors(soup, colors.get(), used.vertices());
        }
        if (tangents.isPresent()) {
            addTangents(soup, posed, tangents.get(), used.vertices());
        }
        for (int i = 0; i < corners.length; i += 3) {
            soup.triangle(used.number(corners[i]), used.number(corners[i + 1]), used.number(corners[i + 2]));
        }
        return soup;
    }

    private static void addNormals(TriangleSoup soup, GltfPosed posed, GltfAccessor normals, int[] used)
            throws IOException {
        for (int vertex : used) {
            Vector3 normal = posed.normal(normals, vertex);
            soup.normal(normal.x(), normal.y(), normal.z());
        }
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

    private static void addTangents(TriangleSoup soup, GltfPosed posed, GltfAccessor tangents, int[] used)
            throws IOException {
        for (int vertex : used) {
            Vector3 tangent = posed.tangent(tangents, vertex);
            for (double value : new double[] {tangent.x(), tangent.y(), tangent.z()}) {
                soup.tangents.add(Math.abs(value) <= 2 ? (float) value : 0);
            }
            soup.tangentSigns.add(tangents.get(vertex, 3) < 0 ? -1 : 1);
        }
    }

    private static void addPosition(TriangleSoup soup, Vector3 place) {
        if (MeshLimits.areCoordinates(place.x(), place.y(), place.z())) {
            soup.position(place.x(), place.y(), place.z());
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
