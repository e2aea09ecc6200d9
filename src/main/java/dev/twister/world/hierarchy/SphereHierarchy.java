package dev.twister.world.hierarchy;

import dev.twister.kernel.Layout;
import dev.twister.world.Bodies;
import dev.twister.world.table.InstanceTable;
import java.util.Arrays;

/**
 * Builds bounding volume hierarchies over the spheres: binary trees of boxes, see {@link Subtree}. A hierarchy follows
 * the places in one array, see {@link Layout}: the spheres in the order of the leaves, then the nodes, the root first.
 * The length depends only on the room for bodies, not on the number of present ones.
 */
public final class SphereHierarchy {
    /** With fewer spheres a loop over all is at least as fast; see {@code docs/decisions/010}. */
    public static final int FEWEST_SPHERES = 16;

    /** Testing eight spheres takes about as long as testing two boxes and their content. */
    private static final int MOST_IN_LEAF = 8;

    /** From this number of spheres on, the upper levels are split by cells. */
    private static final int FEWEST_FOR_CELLS = 4096;

    private static final int[] NO_LIGHTS = {};

    /** Of the box around all, for the rounding of its own sides. */
    private static final float GROWTH = 1 + 0x1p-20f;

    /**
     * Tells by its identity whether two inputs have the same hierarchy over the spheres, though other numbers of the
     * array that has it differ. No part of the picture: all are equal.
     */
    public record Identity() {}

    private SphereHierarchy() {}

    /**
     * {@link Bodies#floats} without meshes and lights after the first: the places, then a new hierarchy over the
     * present spheres. For few spheres it is a single leaf, and its traversal is a loop over all spheres.
     *
     * @param places {@link Layout#PLACE_STRIDE} floats for each body
     * @param bodies number of present bodies, including light and plane
     */
    public static float[] of(float[] places, int bodies) {
        return of(places, bodies, NO_LIGHTS, leaves(bodies), places.length / Layout.PLACE_STRIDE, new float[0]);
    }

    /**
     * As above, with lights, followed by the meshes' hierarchy.
     *
     * @param lights the bodies of lights, other than the first body, that are spheres
     * @param end one more than the highest number of a sphere, present or not, lights included
     * @param instances the array of {@link InstanceTable}
     */
    public static float[] of(float[] places, int bodies, int[] lights, int end, float[] instances) {
        return of(places, bodies, lights, leaves(bodies), end, instances);
    }

    /**
     * As the first, with lights and another size of the leaves.
     *
     * @param mostInLeaf largest number of spheres per leaf, at least 1
     */
    public static float[] of(float[] places, int bodies, int[] lights, int mostInLeaf) {
        return of(places, bodies, lights, mostInLeaf, places.length / Layout.PLACE_STRIDE, new float[0]);
    }

    private static float[] of(float[] places, int bodies, int[] lights, int mostInLeaf, int end, float[] instances) {
        int behind = places.length + Layout.spheresLength(end - Layout.FIRST_SPHERE);
        float[] floats = Arrays.copyOf(places, behind + instances.length);
        System.arraycopy(instances, 0, floats, behind, instances.length);
        fill(floats, places.length, bodies, lights, mostInLeaf);
        addLights(floats, places.length, bodies, lights);
        return floats;
    }

    /**
     * An array of {@link #of} with the same hierarchy over the spheres without lights, but other places of the other
     * bodies.
     *
     * @param floats the array, with as many bodies and lights
     */
    public static float[] kept(
            float[] floats, float[] places, int bodies, int[] lights, int room, int end, float[] instances) {
        int behind = places.length + Layout.spheresLength(end - Layout.FIRST_SPHERE);
        float[] changed = Arrays.copyOf(floats, behind + instances.length);
        int spheres = Layout.PLACE_STRIDE * room;
        System.arraycopy(places, 0, changed, 0, Layout.PLACE_STRIDE * Layout.FIRST_SPHERE);
        System.arraycopy(places, spheres, changed, spheres, places.length - spheres);
        System.arraycopy(instances, 0, changed, behind, instances.length);
        addLights(changed, places.length, bodies, lights);
        return changed;
    }

    private static int leaves(int bodies) {
        return bodies - Layout.FIRST_SPHERE < FEWEST_SPHERES ? FEWEST_SPHERES : MOST_IN_LEAF;
    }

    /**
     * Place of the root over all spheres.
     *
     * @param end number of places
     * @param bodies number of present bodies, including light and plane
     * @param lights number of lights that are among the spheres
     */
    public static int root(int end, int bodies, int lights) {
        return Layout.PLACE_STRIDE * end + Layout.SPHERE_STRIDE * (bodies - Layout.FIRST_SPHERE + lights);
    }

    /** Place of the root over the spheres that are no lights; the root over the lights follows it. */
    public static int shadowRoot(int root, int lights) {
        return lights > 0 ? root + Layout.NODE_STRIDE : root;
    }

    private static void fill(float[] floats, int start, int bodies, int[] lights, int mostInLeaf) {
        int spheres = bodies - Layout.FIRST_SPHERE;
        int root = shadowRoot(start + Layout.SPHERE_STRIDE * (spheres + lights.length), lights.length);
        int room = root + (lights.length > 0 ? 2 : 1) * Layout.NODE_STRIDE;
        Spheres ordered = new Spheres(floats, start, mostInLeaf);
        if (spheres >= FEWEST_FOR_CELLS) {
            SphereCells cells = new SphereCells(floats, bodies, ordered);
            new Subtree(cells, floats, root, room, 0, cells.count, 0).invoke();
        } else {
            for (int sphere = 0; sphere < spheres; sphere++) {
                writeSphere(floats, start + Layout.SPHERE_STRIDE * sphere, floats, Layout.FIRST_SPHERE + sphere);
            }
            new Subtree(ordered, floats, root, room, 0, spheres, 0).invoke();
        }
    }

    /** Writes the lights' part of the hierarchy and the root above both parts. */
    private static void addLights(float[] floats, int start, int bodies, int[] lights) {
        if (lights.length > 0) {
            int spheres = bodies - Layout.FIRST_SPHERE;
            int from = start + Layout.SPHERE_STRIDE * spheres;
            int root = from + Layout.SPHERE_STRIDE * lights.length;
            int first = root + Layout.NODE_STRIDE;
            int second = first + Layout.NODE_STRIDE;
            int room = second + (1 + Math.max(0, 2 * spheres - 2)) * Layout.NODE_STRIDE;
            for (int light = 0; light < lights.length; light++) {
                writeSphere(floats, from + Layout.SPHERE_STRIDE * light, floats, lights[light]);
            }
            Spheres ordered = new Spheres(floats, from, MOST_IN_LEAF);
            new Subtree(ordered, floats, second, room, 0, lights.length, 1).invoke();
            join(floats, root, spheres > 0 ? first : second, second);
            floats[root + Layout.NODE_LINK] = first;
            floats[root + Layout.NODE_SPHERES] = -1;
        }
    }

    /** Writes the box around two nodes'. */
    private static void join(float[] floats, int to, int first, int second) {
        for (int axis = 0; axis < 3; axis++) {
            float low = Math.min(side(floats, first + axis, -1), side(floats, second + axis, -1));
            float high = Math.max(side(floats, first + axis, 1), side(floats, second + axis, 1));
            floats[to + Layout.NODE_CENTER + axis] = 0.5f * (low + high);
            floats[to + Layout.NODE_HALF + axis] = GROWTH * 0.5f * (high - low);
        }
    }

    private static float side(float[] floats, int at, int sign) {
        return floats[at + Layout.NODE_CENTER] + sign * floats[at + Layout.NODE_HALF];
    }

    /** Writes a sphere, laid out as in {@link Layout}. */
    static void writeSphere(float[] to, int at, float[] places, int body) {
        System.arraycopy(places, Layout.PLACE_STRIDE * body, to, at, Layout.PLACE_STRIDE);
        to[at + Layout.SPHERE_BODY] = body;
    }
}
