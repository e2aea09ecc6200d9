package dev.twister.mesh;

import dev.twister.scene.Vector3;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;

/**
 * What a mesh file holds.
 *
 * @param meshes each once, however many parts show it
 * @param parts at least one
 * @param embeddedImages PNG or JPEG files inside the file, by the path that the parts' materials have as their texture:
 *     the file's own with the image's number after it
 * @param degenerateTriangles how many triangles without an area were left out
 */
public record MeshFile(
        List<TriangleMesh> meshes, List<MeshPart> parts, Map<Path, byte[]> embeddedImages, int degenerateTriangles) {
    public MeshFile {
        meshes = List.copyOf(meshes);
        parts = List.copyOf(parts);
        embeddedImages = Map.copyOf(embeddedImages);
    }

    /** The box around all that the parts show. */
    public Bounds bounds() {
        Bounds bounds = Bounds.NONE;
        for (MeshPart part : parts) {
            float[] positions = meshes.get(part.mesh()).positions();
            for (int at = 0; at < positions.length; at += 3) {
                bounds = bounds.with(
                        part.placement().point(new Vector3(positions[at], positions[at + 1], positions[at + 2])));
            }
        }
        return bounds;
    }

    /** All triangles that the parts show, a shared mesh's as often as it is shown. */
    public long shownTriangles() {
        return parts.stream()
                .mapToLong(part -> meshes.get(part.mesh()).triangles())
                .sum();
    }
}
