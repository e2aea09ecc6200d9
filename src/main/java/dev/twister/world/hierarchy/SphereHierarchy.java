package dev.twister.world.hierarchy;

import dev.twister.kernel.Layout;
import dev.twister.world.Bodies;
import dev.twister.world.table.InstanceTable;
import java.util.Arrays;

/**
 * Builds bounding volume hierarchies over the spheres: binary trees of boxes, split by the surface area heuristic
 * (Goldsmith and Salmon 1987), which is evaluated at the borders of equal bins (Wald 2007), on all cores.
 *
 * <p>A hierarchy follows the places in one array, see {@link Layout}: the spheres in the order of the leaves, then the
 * nodes, the root first. A node over n spheres reserves room for its 2 n - 2 descendants directly after its children or
 * its elder sibling's room. Its location therefore does not depend on the order in which threads finish; leaves of
 * several spheres leave gaps of zeros. The length depends only on the room for bodies, not on the number of present
 * ones.
 */
public final class SphereHierarchy {
    /** With fewer spheres a loop over all is at least as fast; see {@code docs/decisions/010}. */
    public static final int FEWEST_SPHERES = 16;

    /** Testing eight spheres takes about as long as testing two boxes and their content. */
    private static final int MOST_IN_LEAF = 8;

    /** From this number of spheres on, the upper levels are split by cells. */
    private static final int FEWEST_FOR_CELLS = 4096;

    private SphereHierarchy() {}

    /**
     * {@link Bodies#floats} without meshes: the places, then a new hierarchy over the present spheres. For few spheres
     * it is a single leaf, and its traversal is a loop over all spheres.
     *
     * @param places {@link Layout#PLACE_STRIDE} floats for each body
     * @param bodies number of present bodies, including light and plane
     */
    public static float[] of(float[] places, int bodies) {
        return of(places, bodies, places.length / Layout.PLACE_STRIDE, new float[0]);
    }

    /**
     * As above, followed by the meshes' hierarchy.
     *
     * @param room maximum number of bodies without meshes
     * @param instances the array of {@link InstanceTable}
     */
    public static float[] of(float[] places, int bodies, int room, float[] instances) {
        int spheres = bodies - Layout.FIRST_SPHERE;
        int end = places.length + Layout.spheresLength(room);
        float[] floats = Arrays.copyOf(places, end + instances.length);
        System.arraycopy(instances, 0, floats, end, instances.length);
        fill(floats, places.length, bodies, spheres < FEWEST_SPHERES ? FEWEST_SPHERES : MOST_IN_LEAF);
        return floats;
    }

    /**
     * An array of {@link #of} with the same hierarchy over the spheres, but other places of the other bodies.
     *
     * @param floats the array, of as many bodies
     */
    public static float[] kept(float[] floats, float[] places, int room, float[] instances) {
        int end = places.length + Layout.spheresLength(room);
        float[] changed = Arrays.copyOf(floats, end + instances.length);
        int spheres = Layout.PLACE_STRIDE * room;
        System.arraycopy(places, 0, changed, 0, Layout.PLACE_STRIDE * Layout.FIRST_SPHERE);
        System.arraycopy(places, spheres, changed, spheres, places.length - spheres);
        System.arraycopy(instances, 0, changed, end, instances.length);
        return changed;
    }

    /**
     * As the first, with another size of the leaves.
     *
     * @param mostInLeaf largest number of spheres per leaf, at least 1
     */
    public static float[] of(float[] places, int bodies, int mostInLeaf) {
        int room = places.length / Layout.PLACE_STRIDE;
        float[] floats = Arrays.copyOf(places, places.length + Layout.spheresLength(room));
        fill(floats, places.length, bodies, mostInLeaf);
        return floats;
    }

    /**
     * Place of the root.
     *
     * @param end number of places
     * @param bodies number of present bodies, including light and plane
     */
    public static int root(int end, int bodies) {
        return Layout.PLACE_STRIDE * end + Layout.SPHERE_STRIDE * (bodies - Layout.FIRST_SPHERE);
    }

    private static void fill(float[] floats, int start, int bodies, int mostInLeaf) {
        int spheres = bodies - Layout.FIRST_SPHERE;
        int root = start + Layout.SPHERE_STRIDE * spheres;
        if (spheres >= FEWEST_FOR_CELLS) {
            SphereCells cells = new SphereCells(floats, bodies);
            new CellTree(cells, floats, start, root, mostInLeaf).invoke();
        } else {
            for (int sphere = 0; sphere < spheres; sphere++) {
                writeSphere(floats, start + Layout.SPHERE_STRIDE * sphere, floats, Layout.FIRST_SPHERE + sphere);
            }
            new Subtree(floats, root, root + Layout.NODE_STRIDE, start, root, 0, mostInLeaf).invoke();
        }
    }

    /** Writes a sphere, laid out as in {@link Layout}. */
    static void writeSphere(float[] to, int at, float[] places, int body) {
        System.arraycopy(places, Layout.PLACE_STRIDE * body, to, at, Layout.PLACE_STRIDE);
        to[at + Layout.SPHERE_BODY] = body;
    }
}
