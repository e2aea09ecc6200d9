package dev.twister.mesh;

import dev.twister.scene.Vector3;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;

/**
 * The content of a mesh file.
 *
 * @param meshes distinct meshes; several parts may share one
 * @param parts at least one
 * @param embeddedImages PNG, JPEG or WebP data in the file, by the texture path of the parts' materials: the file's own
 *     path, followed by the image's number
 * @param degenerateTriangles number of dropped triangles without area
 * @param surroundings the lights and cameras of a glTF file's scene
 */
public record MeshFile(
        List<TriangleMesh> meshes,
        List<MeshPart> parts,
        Map<Path, byte[]> embeddedImages,
        int degenerateTriangles,
        FileSurroundings surroundings) {
    public MeshFile {
        meshes = List.copyOf(meshes);
        parts = List.copyOf(parts);
        embeddedImages = Map.copyOf(embeddedImages);
    }

    /** Without lights and cameras. */
    public MeshFile(
            List<TriangleMesh> meshes,
            List<MeshPart> parts,
            Map<Path, byte[]> embeddedImages,
            int degenerateTriangles) {
        this(meshes, parts, embeddedImages, degenerateTriangles, FileSurroundings.NONE);
    }

    /** The box around all parts. */
    public Box bounds() {
        return bounds(Affine.IDENTITY);
    }

    /**
     * The box around all parts.
     *
     * @param turn applied to the file's coordinates first
     */
    public Box bounds(Affine turn) {
        Box bounds = Box.NONE;
        for (MeshPart part : parts) {
            Affine placement = turn.of(part.placement());
            float[] positions = meshes.get(part.mesh()).positions();
            for (int at = 0; at < positions.length; at += 3) {
                bounds = bounds.with(placement.point(new Vector3(positions[at], positions[at + 1], positions[at + 2])));
            }
        }
        return bounds;
    }

    /** Number of triangles of all parts; triangles of a shared mesh count for each part. */
    public long shownTriangles() {
        return parts.stream()
                .mapToLong(part -> meshes.get(part.mesh()).triangles())
                .sum();
    }
}
