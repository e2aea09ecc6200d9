package dev.twister.mesh.gltf;

import dev.twister.mesh.input.MeshLimits;
import java.util.Arrays;
import java.util.BitSet;

/**
 * The vertices that a primitive uses, numbered from 0 in ascending order. Time and memory depend on the primitive's
 * corners, because many primitives may use few vertices each of a large list. Reused for all primitives of a file.
 */
final class UsedVertices {
    private int[] vertices = {};
    private boolean few;

    /** Number by vertex; not used if there are few. */
    private int[] numbers = {};

    /**
     * Takes a primitive.
     *
     * @param corners a vertex each
     * @param listed number of vertices in the list
     */
    void set(int[] corners, int listed) {
        few = listed / Long.SIZE > corners.length;
        if (few) {
            vertices = Arrays.stream(corners).sorted().distinct().toArray();
            return;
        }
        BitSet used = new BitSet(listed);
        for (int corner : corners) {
            used.set(corner);
        }
        vertices = used.stream().toArray();
        if (numbers.length < listed) {
            numbers = new int[Math.max(listed, Math.min(2 * numbers.length, MeshLimits.VERTICES))];
        }
        for (int number = 0; number < vertices.length; number++) {
            numbers[vertices[number]] = number;
        }
    }

    /** In ascending order; do not modify. */
    int[] vertices() {
        return vertices;
    }

    /** The number of a vertex that is used. */
    int number(int vertex) {
        return few ? Arrays.binarySearch(vertices, vertex) : numbers[vertex];
    }
}
