package dev.twister.world;

import dev.twister.kernel.Layout;
import java.util.Arrays;

/**
 * Location of a mesh in the array of all meshes, see {@link Layout}.
 *
 * @param start index of its first float
 * @param length number of floats
 */
record MeshPlace(int start, int length, MeshCounts counts) {
    static MeshPlace of(int start, MeshGeometry geometry) {
        return new MeshPlace(start, geometry.floats().length, geometry.counts());
    }

    MeshGeometry geometry(float[] all) {
        return new MeshGeometry(counts, Arrays.copyOfRange(all, start, start + length));
    }

    boolean isEmpty() {
        return counts.triangles() == 0;
    }
}
