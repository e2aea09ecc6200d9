package dev.twister.world.table;

import dev.twister.kernel.Layout;
import dev.twister.mesh.TriangleMesh;
import dev.twister.world.hierarchy.BoxTree;
import dev.twister.world.hierarchy.TriangleRefit;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.function.IntFunction;

/**
 * A mesh as the kernel reads it, see {@link Layout}.
 *
 * @param floats the data; its length is a multiple of {@link Layout#ALIGNMENT}
 */
@SuppressWarnings("ArrayRecordComponent") // never compared
public record MeshGeometry(MeshCounts counts, float[] floats) {
    /** Testing this many triangles takes about as long as testing two boxes and their content. */
    private static final int MOST_IN_LEAF = 4;

    /** Factor of the boxes' area, as a part of the root's, from which on a hierarchy is built anew. */
    private static final double MOST_GROWN = 1.25;

    /**
     * A mesh.
     *
     * @param mesh a mesh with at least one triangle
     * @param moves whether its vertices move, so that equal triangles may come apart
     */
    public static MeshGeometry of(TriangleMesh mesh, boolean moves) {
        return moves
                ? of(mesh, MOST_IN_LEAF, triangle -> triangle)
                : of(mesh, MOST_IN_LEAF, triangle -> corners(mesh, triangle));
    }

    /** A mesh at rest, with another size of the leaves. */
    public static MeshGeometry of(TriangleMesh mesh, int mostInLeaf) {
        return of(mesh, mostInLeaf, triangle -> corners(mesh, triangle));
    }

    private static MeshGeometry of(TriangleMesh mesh, int mostInLeaf, IntFunction<?> content) {
        float[] boxes = boxes(mesh);
        int[] order = new int[mesh.triangles()];
        float[] nodes = BoxTree.nodes(boxes, order, mostInLeaf, content);
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

    /**
     * The mesh with its vertices elsewhere. Its hierarchy is fitted to them, or built anew where that would take rays
     * through many more boxes. Depends on nothing but the mesh at rest and the new places.
     *
     * @param mesh with as many vertices, and the same triangles and texture coordinates
     * @return this object with other floats, or another one
     */
    public MeshGeometry moved(TriangleMesh mesh) {
        int at = Layout.NODE_STRIDE * counts.nodes();
        for (int triangle = 0; triangle < counts.triangles(); triangle++) {
            for (int corner = 0; corner < 3; corner++) {
                int vertex = 3 * (int) floats[at + Layout.TRIANGLE_VERTICES + corner];
                floats[at + 3 * corner] = mesh.positions()[vertex];
                floats[at + 3 * corner + 1] = mesh.positions()[vertex + 1];
                floats[at + 3 * corner + 2] = mesh.positions()[vertex + 2];
            }
            at += Layout.TRIANGLE_STRIDE;
        }
        for (float[] values : attributes(mesh)) {
            System.arraycopy(values, 0, floats, at, values.length);
            at += values.length;
        }
        double grown = TriangleRefit.fit(floats, counts.nodes());
        return grown > MOST_GROWN ? of(mesh, true) : this;
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
