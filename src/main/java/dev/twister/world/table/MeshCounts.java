package dev.twister.world.table;

import dev.twister.mesh.TriangleMesh;

/**
 * What a mesh has in the array of all meshes, see {@link dev.twister.kernel.Layout}.
 *
 * @param normals number of vertex normals: one per vertex or none
 * @param texturePlaces number of texture coordinates: some pairs per vertex or none
 * @param colors number of vertex colors: one per vertex or none
 * @param tangents number of vertex tangents: one per vertex or none
 */
record MeshCounts(int nodes, int triangles, int vertices, int normals, int texturePlaces, int colors, int tangents) {
    static MeshCounts of(TriangleMesh mesh, int nodes) {
        return new MeshCounts(
                nodes,
                mesh.triangles(),
                mesh.vertices(),
                mesh.normals().length / 3,
                mesh.textureCoordinates().length / 2,
                mesh.colors().length / 4,
                mesh.tangents().length / 4);
    }
}
