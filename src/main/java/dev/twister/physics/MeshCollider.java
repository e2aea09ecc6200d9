package dev.twister.physics;

import dev.twister.mesh.Affine;
import dev.twister.mesh.MeshException;
import dev.twister.mesh.MeshFile;
import dev.twister.mesh.MeshPart;
import dev.twister.mesh.MeshPlacement;
import dev.twister.mesh.TriangleMesh;
import dev.twister.scene.Mesh;
import dev.twister.scene.Scene;
import dev.twister.scene.TrackTarget;
import dev.twister.scene.Vector3;
import dev.twister.world.Animation;
import dev.twister.world.SceneMeshes;
import java.util.Arrays;
import java.util.function.DoubleFunction;
import java.util.function.IntConsumer;

/**
 * Triangles that bodies can touch from both sides; they are fixed, or move step by step as meshes do in a film.
 *
 * <p>A body touches a triangle at the surface point nearest to its center. At an edge that two triangles share, one
 * triangle's nearest point is not the surface's if the other triangle comes nearer. Then only the other one is touched,
 * so that a body rolling over flat ground is not deflected by interior edges.
 */
final class MeshCollider {
    private static final double[] RESTING = {};

    /** A collider without triangles. */
    static final MeshCollider EMPTY = new MeshCollider(new double[0]);

    private static final int NOTHING = -1;

    /** Limit for all meshes together, counting each instance. */
    private static final int MOST_TRIANGLES = 50_000_000;

    /** Most triangles per leaf. */
    private static final int LEAF = 4;

    /** Doubles per box: minimum and maximum of x, y and z. */
    private static final int BOX = 6;

    /** Where the corners are at a time of the film. */
    private final DoubleFunction<double[]> film;

    private final boolean moves;

    /** {@code double[9 * triangles]}: three corners of x, y, z each, in meters. */
    private final double[] corners;

    /** The corners' displacements per sub-step, in meters; empty while all rest. */
    private double[] drifts = RESTING;

    /** The longest displacement of a corner in the present step, in meters. */
    private double longest;

    private double time;

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
        this(corners, false, _ -> corners);
    }

    private MeshCollider(double[] corners, boolean moves, DoubleFunction<double[]> film) {
        this.film = film;
        this.moves = moves;
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
     * The meshes of a scene in world coordinates, where they are in the scene.
     *
     * @throws IllegalArgumentException if one of the scene's meshes has not been read
     * @throws MeshException if they have more than {@value #MOST_TRIANGLES} triangles in total
     */
    static MeshCollider of(Scene scene, SceneMeshes meshes) {
        double[] corners = corners(scene, meshes, false);
        return corners.length == 0 ? EMPTY : new MeshCollider(corners);
    }

    /** As above, but meshes move by their animations and tracks. */
    static MeshCollider ofFilm(Scene scene, SceneMeshes meshes) {
        Scene alone = scene.withTracks(scene.tracks().stream()
                .filter(track -> track.target().kind() == TrackTarget.Kind.MESH)
                .toList());
        if (!Animation.isOfMeshes(alone) && alone.tracks().isEmpty()) {
            return of(scene, meshes);
        }
        DoubleFunction<double[]> film = seconds -> corners(Animation.tracked(alone, seconds), meshes, true);
        return new MeshCollider(film.apply(0), true, film);
    }

    /** @param all whether triangles without area are among them, so that their number is always the same */
    private static double[] corners(Scene scene, SceneMeshes meshes, boolean all) {
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
            MeshFile file = meshes.posedFile(mesh);
            Affine placement = MeshPlacement.of(mesh);
            for (MeshPart part : file.parts()) {
                end = place(file.meshes().get(part.mesh()), placement.of(part.placement()), corners, end, all);
            }
        }
        return end == corners.length ? corners : Arrays.copyOf(corners, end);
    }

    /** Writes the placed triangles, all of them or those with an area; returns the end. */
    private static int place(TriangleMesh mesh, Affine placement, double[] corners, int start, boolean all) {
        float[] positions = mesh.positions();
        int end = start;
        for (int corner = 0; corner < mesh.corners().length; corner++) {
            int vertex = 3 * mesh.corners()[corner];
            Vector3 place =
                    placement.point(new Vector3(positions[vertex], positions[vertex + 1], positions[vertex + 2]));
            corners[end++] = place.x();
            corners[end++] = place.y();
            corners[end++] = place.z();
            if (!all && corner % 3 == 2 && !TriangleContact.hasArea(corners, end - 9)) {
                end -= 9;
            }
        }
        return end;
    }

    /**
     * Begins a step, at the end of which the triangles are where they are at a time of the film.
     *
     * @param seconds since the film's start
     * @return the longest displacement of a corner in the step, in meters
     */
    double begin(double seconds) {
        if (!moves) {
            return 0;
        }
        drifts = seconds == time ? RESTING : film.apply(seconds);
        time = seconds;
        double most = 0;
        for (int corner = 0; corner < drifts.length; corner += 3) {
            double square = 0;
            for (int axis = corner; axis < corner + 3; axis++) {
                drifts[axis] -= corners[axis];
                square += drifts[axis] * drifts[axis];
            }
            most = Math.max(most, square);
        }
        longest = Math.sqrt(most);
        refit(0, 0, order.length);
        return longest;
    }

    /** Sets in how many sub-steps the step is taken, before the first of them. */
    void divide(int substeps) {
        for (int i = 0; i < drifts.length; i++) {
            drifts[i] /= substeps;
        }
    }

    /** Moves the triangles on by a sub-step. */
    void advance() {
        for (int i = 0; i < drifts.length; i++) {
            corners[i] += drifts[i];
        }
    }

    /** The longest displacement of a corner in the present step, in meters; 0 while all rest. */
    double reach() {
        return longest;
    }

    /** Whether a triangle that moves by more than a length in the present step is within a distance of a point. */
    boolean isMovingNear(double x, double y, double z, double distance, double least) {
        boolean[] found = {false};
        near(x, y, z, distance + longest, triangle -> {
            TriangleContact contact = contact(triangle);
            contact.meet(x, y, z, 0, 0, 0, 0);
            found[0] |= contact.away() <= distance + longest && isMoving(triangle, least);
        });
        return found[0];
    }

    private boolean isMoving(int triangle, double least) {
        for (int corner = 9 * triangle; corner < 9 * triangle + 9; corner += 3) {
            if (Math.hypot(Math.hypot(drifts[corner], drifts[corner + 1]), drifts[corner + 2]) > least) {
                return true;
            }
        }
        return false;
    }

    /** The displacements that {@link TriangleContact#drift} takes; empty while all rest. */
    double[] drifts() {
        return drifts;
    }

    /** Whether a triangle has an area at present; one that moves may lose it. */
    boolean hasArea(int triangle) {
        return !moves || TriangleContact.hasArea(corners, 9 * triangle);
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
        double[] box = fit(node, from, to);
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

    /** Sets the box of a node around its triangles; returns a copy. */
    private double[] fit(int node, int from, int to) {
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
        return box;
    }

    /** Sets the boxes of a node and of all below it around their triangles, which have moved. */
    private void refit(int node, int from, int to) {
        if (hasChildren(node)) {
            int middle = (from + to) >>> 1;
            refit(2 * node + 1, from, middle);
            refit(2 * node + 2, middle, to);
            for (int end = 0; end < BOX; end++) {
                double one = boxes[BOX * (2 * node + 1) + end];
                double other = boxes[BOX * (2 * node + 2) + end];
                boxes[BOX * node + end] = end % 2 == 0 ? Math.min(one, other) : Math.max(one, other);
            }
        } else {
            fit(node, from, to);
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
                    if (hasArea(order[index])) {
                        found.accept(order[index]);
                    }
                }
            }
        }
    }

    private static double outside(double place, double least, double largest) {
        return Math.max(0, Math.max(least - place, place - largest));
    }
}
