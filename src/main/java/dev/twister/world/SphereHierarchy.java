package dev.twister.world;

import dev.twister.kernel.Layout;

/**
 * Builds bounding volume hierarchies over the spheres: binary trees of boxes, split where the surface area heuristic
 * says (Goldsmith and Salmon 1987), tried at the borders of equal bins (Wald 2007), on all cores.
 *
 * <p>A hierarchy is one array, laid out as {@link Layout} says: the spheres in the order of the leaves, then the nodes,
 * the root first. A node over n spheres has room for the 2 n - 2 nodes below it right behind its children or its elder
 * sibling's room, so that its place does not depend on which thread came first; leaves of more than one sphere leave
 * gaps of zeros. The length depends on the room for bodies alone, not on how many are there yet.
 */
public final class SphereHierarchy {
    /** With fewer spheres the plain loop is as fast or faster: {@code docs/decisions/010}. */
    static final int FEWEST_SPHERES = 32;

    /** Eight spheres are tested about as fast as two boxes and what is left in them. */
    private static final int MOST_IN_LEAF = 8;

    /** From this number of spheres on, the upper levels are split by cells, each of many spheres. */
    private static final int FEWEST_FOR_CELLS = 4096;

    private SphereHierarchy() {}

    /** How many floats a hierarchy with room for that number of bodies has. */
    public static int length(int room) {
        return Layout.spheresLength(room);
    }

    /**
     * A new hierarchy over the first spheres of these bodies; where they are few it is a single leaf, and walking it is
     * the plain loop over all spheres.
     *
     * @param places {@link Bodies#places}
     * @param bodies how many are there now, light and plane included
     */
    public static float[] of(float[] places, int bodies) {
        return of(places, bodies, places.length / Layout.PLACE_STRIDE, new float[0]);
    }

    /**
     * The same, and the meshes' part after it.
     *
     * @param room how many of the bodies there may come to be without meshes
     * @param instances {@link InstanceTable}'s
     */
    static float[] of(float[] places, int bodies, int room, float[] instances) {
        int spheres = bodies - Layout.FIRST_SPHERE;
        float[] hierarchy = new float[Layout.spheresLength(room) + instances.length];
        System.arraycopy(instances, 0, hierarchy, Layout.spheresLength(room), instances.length);
        fill(hierarchy, places, bodies, spheres < FEWEST_SPHERES ? FEWEST_SPHERES : MOST_IN_LEAF);
        return hierarchy;
    }

    /**
     * The same, with leaves of another size.
     *
     * @param mostInLeaf at least 1
     */
    public static float[] of(float[] places, int bodies, int mostInLeaf) {
        float[] hierarchy = new float[Layout.spheresLength(places.length / Layout.PLACE_STRIDE)];
        fill(hierarchy, places, bodies, mostInLeaf);
        return hierarchy;
    }

    private static void fill(float[] hierarchy, float[] places, int bodies, int mostInLeaf) {
        int spheres = bodies - Layout.FIRST_SPHERE;
        int root = Layout.root(bodies);
        if (spheres >= FEWEST_FOR_CELLS) {
            SphereCells cells = new SphereCells(places, bodies);
            new CellTree(cells, hierarchy, root, mostInLeaf).invoke();
        } else {
            for (int body = Layout.FIRST_SPHERE; body < bodies; body++) {
                writeSphere(hierarchy, Layout.root(body), places, body);
            }
            new Subtree(hierarchy, root, root + Layout.NODE_STRIDE, 0, root, 0, mostInLeaf).invoke();
        }
    }

    /** Writes a sphere as {@link Layout} has it. */
    static void writeSphere(float[] to, int at, float[] places, int body) {
        System.arraycopy(places, Layout.PLACE_STRIDE * body, to, at, Layout.PLACE_STRIDE);
        to[at + Layout.SPHERE_BODY] = body;
    }
}
