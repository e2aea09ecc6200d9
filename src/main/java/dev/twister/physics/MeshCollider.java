package dev.twister.physics;

import dev.twister.mesh.Affine;
import dev.twister.mesh.MeshException;
import dev.twister.mesh.MeshFile;
import dev.twister.mesh.MeshPart;
import dev.twister.mesh.MeshPlacement;
import dev.twister.mesh.TriangleMesh;
import dev.twister.scene.Mesh;
import dev.twister.scene.Scene;
import dev.twister.scene.Vector3;
import dev.twister.world.SceneMeshes;
import java.util.Arrays;
import java.util.function.IntConsumer;

/**
 * Fixed triangles that bodies can touch from both sides.
 *
 * <p>A body touches a triangle at the surface point nearest to its center. At an edge that two triangles share, one
 * triangle's nearest point is not the surface's if the other triangle comes nearer. Then only the other one is touched,
 * so that a body rolling over flat ground is not deflected by interior edges.
 */
final class MeshCollider {
    /** A collider without triangles. */
    static final MeshCollider EMPTY = new MeshCollider(new double[0]);

    private static final int NOTHING = -1;

    /** Limit for all meshes together, counting each instance. */
    private static final int MOST_TRIANGLES = 50_000_000;

    /** Most triangles per leaf. */
    private static final int LEAF = 4;

    /** Doubles per box: minimum and maximum of x, y and z. */
    private static final int BOX = 6;

    /** {@code double[9 * triangles]}: three corners of x, y, z each, in meters. */
    private final double[] corners;

    /** {@code int[3 * triangles]}: the triangle across the edge from corner k to the next one, or {@link #NOTHING}. */
    private final int[] neighbors;

    /** {@code int[triangles]}: triangle numbers, contiguous per node. */
    private final int[] order;

    /** {@code double[6 * nodes]}: boxes of a complete binary tree; node k has the children 2 k + 1 and 2 k + 2. */
    private final double[] boxes;

    /**
     * @param corners {@code double[9 * triangles]}: three corners with x, y and z each, in meters; no triangle may be
     *     degenerate
     */
    MeshCollider(double[] corners) {
        this.corners = corners;
        int triangles = corners.length / 9;
        neighbors = TriangleBorders.neighbors(corners);
        order = new int[triangles];
        Arrays.setAll(order, triangle -> triangle);
        int leaves = Integer.highestOneBit(Math.max(1, 2 * Math.ceilDiv(triangles, LEAF) - 1));
        boxes = new double[BOX * (2 * leaves - 1)];
        build(0, 0, triangles);
    }

    /**
     * The meshes of a scene in world coordinates.
     *
     * @throws IllegalArgumentException if one of the scene's meshes has not been read
     * @throws MeshException if they have more than {@value #MOST_TRIANGLES} triangles in total
     */
    static MeshCollider of(Scene scene, SceneMeshes meshes) {
        long triangles = scene.meshes().stream()
                .mapToLong(mesh -> meshes.file(mesh).shownTriangles())
                .sum();
        if (triangles > MOST_TRIANGLES) {
            throw new MeshException("the scene's meshes show " + triangles
                    + " triangles together; physics takes at most " + MOST_TRIANGLES + "; use fewer or simpler meshes");
        }
        double[] corners = new double[(int) (9 * triangles)];
        int end = 0;
        for (Mesh mesh : scene.meshes()) {
            MeshFile file = meshes.file(mesh);
            Affine placement = MeshPlacement.of(mesh);
            for (MeshPart part : file.parts()) {
                end = place(file.meshes().get(part.mesh()), placement.of(part.placement()), corners, end);
            }
        }
        return end == 0 ? EMPTY : new MeshCollider(Arrays.copyOf(corners, end));
    }

    /** Writes the placed triangles except degenerate ones; returns the end. */
    private static int place(TriangleMesh mesh, Affine placement, double[] corners, int start) {
        float[] positions = mesh.positions();
        int end = start;
        for (int corner = 0; corner < mesh.corners().length; corner++) {
            int vertex = 3 * mesh.corners()[corner];
            Vector3 place =
                    placement.point(new Vector3(positions[vertex], positions[vertex + 1], positions[vertex + 2]));
            corners[end++] = place.x();
            corners[end++] = place.y();
            corners[end++] = place.z();
            if (corner % 3 == 2 && !TriangleContact.hasArea(corners, end - 9)) {
                end -= 9;
            }
        }
        return end;
    }

    int triangles() {
        return order.length;
    }

    /** The largest absolute coordinate, in meters. */
    double largestCoordinate() {
        double largest = 0;
        for (double coordinate : corners) {
            largest = Math.max(largest, Math.abs(coordinate));
        }
        return largest;
    }

    /** Calls back for each triangle in the leaves whose boxes the ball overlaps. */
    void near(double x, double y, double z, double reach, IntConsumer found) {
        if (order.length > 0) {
            near(0, 0, order.length, x, y, z, reach, found);
        }
    }

    /** The contact data of a triangle; see {@link TriangleContact#meet}. */
    TriangleContact contact(int triangle) {
        return new TriangleContact(corners, triangle);
    }

    /**
     * Whether the triangle's nearest point is on an edge and the neighbor across it is nearer to the point.
     *
     * @param contact the triangle's contact, after {@code meet} with the point
     */
    boolean isNearerAcross(int triangle, TriangleContact contact) {
        return isNearerAcross(triangle, contact, 0)
                || isNearerAcross(triangle, contact, 1)
                || isNearerAcross(triangle, contact, 2);
    }

    private boolean isNearerAcross(int triangle, TriangleContact contact, int border) {
        int other = neighbors[3 * triangle + border];
        return contact.isOn(border) && other != NOTHING && contact.leansOver(corners, triangle, border, other);
    }

    private void build(int node, int from, int to) {
        double[] box = {
            Double.POSITIVE_INFINITY, Double.NEGATIVE_INFINITY,
            Double.POSITIVE_INFINITY, Double.NEGATIVE_INFINITY,
            Double.POSITIVE_INFINITY, Double.NEGATIVE_INFINITY
        };
        for (int index = from; index < to; index++) {
            for (int number = 0; number < 9; number++) {
                double coordinate = corners[9 * order[index] + number];
                int axis = number % 3;
                box[2 * axis] = Math.min(box[2 * axis], coordinate);
                box[2 * axis + 1] = Math.max(box[2 * axis + 1], coordinate);
            }
        }
        System.arraycopy(box, 0, boxes, BOX * node, BOX);
        if (hasChildren(node)) {
            int axis = 0;
            for (int other = 1; other < 3; other++) {
                axis = box[2 * other + 1] - box[2 * other] > box[2 * axis + 1] - box[2 * axis] ? other : axis;
            }
            int middle = (from + to) >>> 1;
            split(from, to, middle, axis);
            build(2 * node + 1, from, middle);
            build(2 * node + 2, middle, to);
        }
    }

    private boolean hasChildren(int node) {
        return BOX * (2 * node + 2) < boxes.length;
    }

    /** Partitions the triangles around the middle by their centers along an axis (Hoare's selection). */
    private void split(int from, int to, int middle, int axis) {
        int low = from;
        int high = to - 1;
        while (low < high) {
            double pivot = center(order[(low + high) >>> 1], axis);
            int left = low;
            int right = high;
            while (left <= right) {
                while (center(order[left], axis) < pivot) {
                    left++;
                }
                while (center(order[right], axis) > pivot) {
                    right--;
                }
                if (left <= right) {
                    int swapped = order[left];
                    order[left] = order[right];
                    order[right] = swapped;
                    left++;
                    right--;
                }
            }
            low = middle > right ? left : low;
            high = middle < left ? right : high;
        }
    }

    private double center(int triangle, int axis) {
        return corners[9 * triangle + axis] + corners[9 * triangle + 3 + axis] + corners[9 * triangle + 6 + axis];
    }

    private void near(int node, int from, int to, double x, double y, double z, double reach, IntConsumer found) {
        int at = BOX * node;
        double outX = outside(x, boxes[at], boxes[at + 1]);
        double outY = outside(y, boxes[at + 2], boxes[at + 3]);
        double outZ = outside(z, boxes[at + 4], boxes[at + 5]);
        if (outX * outX + outY * outY + outZ * outZ <= reach * reach) {
            if (hasChildren(node)) {
                int middle = (from + to) >>> 1;
                near(2 * node + 1, from, middle, x, y, z, reach, found);
                near(2 * node + 2, middle, to, x, y, z, reach, found);
            } else {
                for (int index = from; index < to; index++) {
                    found.accept(order[index]);
                }
            }
        }
    }

    private static double outside(double place, double least, double largest) {
        return Math.max(0, Math.max(least - place, place - largest));
    }
}
