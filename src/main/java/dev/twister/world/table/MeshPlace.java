package dev.twister.world.table;

import dev.twister.kernel.Layout;
import java.util.Arrays;

/**
 * Location of a mesh in the array of all meshes, see {@link Layout}.
 *
 * @param start index of its first float
 * @param length number of floats
 */
public record MeshPlace(int start, int length, MeshCounts counts) {
    public static MeshPlace of(int start, MeshGeometry geometry) {
        return new MeshPlace(start, geometry.floats().length, geometry.counts());
    }

    public MeshGeometry geometry(float[] all) {
        return new MeshGeometry(counts, Arrays.copyOfRange(all, start, start + length));
    }

    public boolean isEmpty() {
        return counts.triangles() == 0;
    }
}
