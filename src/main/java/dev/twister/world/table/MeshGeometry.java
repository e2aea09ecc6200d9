package dev.twister.world.table;

import dev.twister.kernel.Layout;
import dev.twister.mesh.TriangleMesh;
import dev.twister.world.hierarchy.BoxTree;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;

/**
 * A mesh as the kernel reads it, see {@link Layout}.
 *
 * @param floats the data; its length is a multiple of {@link Layout#ALIGNMENT}
 */
@SuppressWarnings("ArrayRecordComponent") // never compared
public record MeshGeometry(MeshCounts counts, float[] floats) {
    /** Testing this many triangles takes about as long as testing two boxes and their content. */
    private static final int MOST_IN_LEAF = 4;

    public static MeshGeometry of(TriangleMesh mesh) {
        return of(mesh, MOST_IN_LEAF);
    }

    /**
     * As above, with another size of the leaves.
     *
     * @param mesh a mesh with at least one triangle
     */
    public static MeshGeometry of(TriangleMesh mesh, int mostInLeaf) {
        float[] boxes = boxes(mesh);
        int[] order = new int[mesh.triangles()];
        float[] nodes = BoxTree.nodes(new BoxTree.Boxes(boxes, order, mostInLeaf, triangle -> corners(mesh, triangle)));
        long length = nodes.length + (long) Layout.TRIANGLE_STRIDE * order.length;
        for (float[] values : attributes(mesh)) {
            length += values.length;
        }
        long aligned = (length + Layout.ALIGNMENT - 1) / Layout.ALIGNMENT * Layout.ALIGNMENT;
        float[] floats = new float[Math.toIntExact(aligned)];
        System.arraycopy(nodes, 0, floats, 0, nodes.length);
        int at = nodes.length;
        for (int triangle : order) {
            for (int corner = 0; corner < 3; corner++) {
                int vertex = mesh.corners()[3 * triangle + corner];
                System.arraycopy(mesh.positions(), 3 * vertex, floats, at + 3 * corner, 3);
                floats[at + Layout.TRIANGLE_VERTICES + corner] = vertex;
            }
            at += Layout.TRIANGLE_STRIDE;
        }
        for (float[] values : attributes(mesh)) {
            System.arraycopy(values, 0, floats, at, values.length);
            at += values.length;
        }
        return new MeshGeometry(MeshCounts.of(mesh, nodes.length / Layout.NODE_STRIDE), floats);
    }

    private static List<float[]> attributes(TriangleMesh mesh) {
        return List.of(mesh.normals(), mesh.textureCoordinates(), mesh.colors(), mesh.tangents());
    }

    /** The nine coordinates of a triangle, from its smallest corner on. */
    private static List<Float> corners(TriangleMesh mesh, int triangle) {
        List<List<Float>> turns = new ArrayList<>();
        for (int first = 0; first < 3; first++) {
            List<Float> coordinates = new ArrayList<>();
            for (int i = 0; i < 9; i++) {
                int vertex = mesh.corners()[3 * triangle + (first + i / 3) % 3];
                // -0 is 0.
                coordinates.add(mesh.positions()[3 * vertex + i % 3] + 0f);
            }
            turns.add(coordinates);
        }
        return Collections.min(
                turns, (one, other) -> Arrays.compare(one.toArray(Float[]::new), other.toArray(Float[]::new)));
    }

    private static float[] boxes(TriangleMesh mesh) {
        float[] boxes = new float[6 * mesh.triangles()];
        for (int triangle = 0; triangle < mesh.triangles(); triangle++) {
            int a = 3 * mesh.corners()[3 * triangle];
            int b = 3 * mesh.corners()[3 * triangle + 1];
            int c = 3 * mesh.corners()[3 * triangle + 2];
            for (int axis = 0; axis < 3; axis++) {
                float first = mesh.positions()[a + axis];
                float second = mesh.positions()[b + axis];
                float third = mesh.positions()[c + axis];
                boxes[6 * triangle + axis] = Math.min(Math.min(first, second), third);
                boxes[6 * triangle + 3 + axis] = Math.max(Math.max(first, second), third);
            }
        }
        return boxes;
    }
}
