package dev.twister.world;

import dev.twister.kernel.Layout;
import java.util.Arrays;

/**
 * Location of a mesh in the array of all meshes, see {@link Layout}.
 *
 * @param start index of its first float
 * @param length number of floats
 */
record MeshPlace(int start, int length, int nodes, int triangles, int normals, int texturePlaces) {
    static MeshPlace of(int start, MeshGeometry geometry) {
        return new MeshPlace(
                start,
                geometry.floats().length,
                geometry.nodes(),
                geometry.triangles(),
                geometry.normals(),
                geometry.texturePlaces());
    }

    MeshGeometry geometry(float[] all) {
        return new MeshGeometry(
                nodes, triangles, normals, texturePlaces, Arrays.copyOfRange(all, start, start + length));
    }

    boolean isEmpty() {
        return triangles == 0;
    }
}
