package dev.twister.mesh.shape;

import dev.twister.mesh.MeshException;
import dev.twister.mesh.MeshFile;
import dev.twister.mesh.assembly.Axes;
import dev.twister.mesh.assembly.MeshAssembly;
import dev.twister.mesh.assembly.MeshAssembly.Assembled;
import dev.twister.mesh.assembly.TriangleSoup;
import dev.twister.mesh.input.MeshLimits;
import dev.twister.scene.Material;
import dev.twister.scene.Triangles;
import dev.twister.scene.Vector3;

/** Makes a mesh of triangles that come from code. */
public final class TrianglesOfCode {
    private TrianglesOfCode() {}

    /**
     * The mesh of these triangles.
     *
     * @throws MeshException if no triangle has an area, or there are too many
     */
    public static MeshFile file(Triangles triangles, double smoothDegrees) {
        if (triangles.triangleCount() > MeshLimits.TRIANGLES) {
            throw new MeshException(triangles.name() + ": " + MeshLimits.tooManyTriangles(triangles.triangleCount()));
        }
        Assembled assembled = MeshAssembly.assemble(soup(triangles), Axes.Y_UP, smoothDegrees);
        if (assembled.meshByMaterial().isEmpty()) {
            throw new MeshException(triangles.name() + ": holds no triangle with an area");
        }
        return assembled.file(triangles.name(), Material.DEFAULT);
    }

    /** As a file has them, with z toward the viewer: the mirrored winding is a file's. */
    private static TriangleSoup soup(Triangles triangles) {
        TriangleSoup soup = new TriangleSoup(triangles.vertexCount(), triangles.triangleCount());
        for (int vertex = 0; vertex < triangles.vertexCount(); vertex++) {
            Vector3 position = triangles.vertex(vertex);
            soup.position(position.x(), position.y(), -position.z());
        }
        for (int triangle = 0; triangle < triangles.triangleCount(); triangle++) {
            soup.triangle(triangles.corner(triangle, 0), triangles.corner(triangle, 1), triangles.corner(triangle, 2));
        }
        return soup;
    }
}
