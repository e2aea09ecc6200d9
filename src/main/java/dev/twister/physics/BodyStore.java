package dev.twister.physics;

import dev.twister.scene.Light;
import dev.twister.scene.Physics;
import dev.twister.scene.Plane;
import dev.twister.scene.Scene;
import dev.twister.scene.Sphere;
import dev.twister.scene.Vector3;
import java.util.Arrays;
import java.util.List;

/**
 * The bodies' numbers: body 0 is the light, the others are spheres, in an order that changes so that what is near in
 * space is near in memory. Those of one body lie together, because a contact needs all of two bodies.
 */
final class BodyStore {
    static final int LIGHT = 0;
    static final int FIRST_SPHERE = 1;

    /** Numbers for each body: places 0 to 11. */
    static final int STRIDE = 12;

    /** The center, in meters: x, y, z. */
    static final int POSITION = 0;

    /** In meters. */
    static final int RADIUS = 3;

    /**
     * What the center moved in the last sub-step, in meters: the position less the previous one of Verlet's method,
     * which is kept instead of that one because it loses no digits far from the origin.
     */
    static final int MOVE = 4;

    /** 1 for the largest sphere of the scene; 0 for what no contact moves, which is the light and what sleeps. */
    static final int INVERSE_MASS = 7;

    /** What the contacts' impulses of the last sub-step come to in {@link #MOVE}: the next one starts with them. */
    static final int SUPPORT = 8;

    /** How long {@link #SUPPORT} was when it was last added to {@link #MOVE}; 0 for what sleeps. */
    static final int CARRIED = 11;

    static final byte AWAKE = 0;
    static final byte ASLEEP = 1;

    /** Roused since the last search: its other contacts are not known before the next one. */
    static final byte WOKEN = 2;

    /** In place of calm steps, until the loads of its contacts are in balance again. */
    private static final int JUST_WOKEN = -1;

    final double[] numbers;

    /** How far from the center something may touch the body until the pairs are looked for again, in meters. */
    final double[] reach;

    /** Where the centers were one step ago: 3 for each body. */
    final double[] before;

    /** For how many sub-steps a body counts as held up by others: above 0 where it lay on them a moment ago. */
    final byte[] held;

    final byte[] state;

    /** 1 above the plane, -1 below it: kept while over or under the square, so that no force presses a body through. */
    final byte[] side;

    /** Whether the walls keep it in: it was between them, and fits, when it came. */
    final boolean[] walled;

    /** Which of the scene's spheres a body is, from 0; -1 for the light. */
    final int[] sphere;

    /** Steps that it has been nearly at rest on others. */
    final int[] calmSteps;

    /** The bodies that are there: the light and the first spheres. */
    int count = FIRST_SPHERE;

    private double smallestRadius = Double.POSITIVE_INFINITY;
    private final double largestRadius;
    private final double halfSide;
    private final double planeHeight;
    private final boolean walls;

    BodyStore(Scene scene, List<Sphere> spheres) {
        int room = FIRST_SPHERE + spheres.size();
        numbers = new double[STRIDE * room];
        before = new double[3 * room];
        held = new byte[room];
        reach = new double[room];
        state = new byte[room];
        side = new byte[room];
        walled = new boolean[room];
        calmSteps = new int[room];
        sphere = new int[room];
        Plane plane = scene.plane();
        halfSide = plane.size() / 2;
        planeHeight = plane.height();
        Physics physics = scene.physics();
        walls = physics.walls();
        largestRadius = spheres.stream().mapToDouble(Sphere::radius).max().orElse(1);
        Light light = scene.light();
        putLight(light);
        sphere[LIGHT] = -1;
        // Never woken, for nothing moves it; so it never looks for pairs itself.
        state[LIGHT] = ASLEEP;
    }

    /** Lets the next sphere be there. */
    void add(Vector3 position, double radius) {
        put(count, position, radius);
        sphere[count] = count - FIRST_SPHERE;
        smallestRadius = Math.min(smallestRadius, radius);
        count++;
    }

    /** Puts the light somewhere, which nothing moves. */
    void putLight(Light light) {
        put(LIGHT, light.position(), light.radius());
        numbers[STRIDE * LIGHT + INVERSE_MASS] = 0;
    }

    /** Puts a body where one of another store is, and was one step ago. */
    void putWhere(int body, BodyStore other, int from) {
        int at = STRIDE * from + POSITION;
        Vector3 place = new Vector3(other.numbers[at], other.numbers[at + 1], other.numbers[at + 2]);
        put(body, place, numbers[STRIDE * body + RADIUS]);
        System.arraycopy(other.before, 3 * from, before, 3 * body, 3);
    }

    /** For each of the scene's spheres that is there, which body it is. */
    int[] bodiesOfSpheres() {
        int[] places = new int[count - FIRST_SPHERE];
        for (int body = FIRST_SPHERE; body < count; body++) {
            places[sphere[body]] = body;
        }
        return places;
    }

    /** Sets how far a body moves in a sub-step. */
    void setMove(int body, double x, double y, double z) {
        int at = STRIDE * body + MOVE;
        numbers[at] = x;
        numbers[at + 1] = y;
        numbers[at + 2] = z;
    }

    /** Of the spheres that are there; infinite where there is none. */
    double smallestRadius() {
        return smallestRadius;
    }

    /**
     * Changes the bodies' order; the light stays the first.
     *
     * @param order for each place, the body that comes there
     */
    void reorder(int[] order) {
        double[] oldNumbers = Arrays.copyOf(numbers, STRIDE * count);
        double[] oldBefore = Arrays.copyOf(before, 3 * count);
        byte[] oldState = Arrays.copyOf(state, count);
        byte[] oldSide = Arrays.copyOf(side, count);
        boolean[] oldWalled = Arrays.copyOf(walled, count);
        int[] oldCalmSteps = Arrays.copyOf(calmSteps, count);
        int[] oldSphere = Arrays.copyOf(sphere, count);
        for (int body = FIRST_SPHERE; body < count; body++) {
            int old = order[body];
            System.arraycopy(oldNumbers, STRIDE * old, numbers, STRIDE * body, STRIDE);
            System.arraycopy(oldBefore, 3 * old, before, 3 * body, 3);
            state[body] = oldState[old];
            side[body] = oldSide[old];
            walled[body] = oldWalled[old];
            calmSteps[body] = oldCalmSteps[old];
            sphere[body] = oldSphere[old];
        }
    }

    private void put(int body, Vector3 position, double radius) {
        int at = STRIDE * body;
        numbers[at + POSITION] = position.x();
        numbers[at + POSITION + 1] = position.y();
        numbers[at + POSITION + 2] = position.z();
        numbers[at + RADIUS] = radius;
        numbers[at + INVERSE_MASS] = inverseMass(radius);
        System.arraycopy(numbers, at + POSITION, before, 3 * body, 3);
        boolean above = position.y() >= planeHeight;
        boolean over = Math.abs(position.x()) <= halfSide && Math.abs(position.z()) <= halfSide;
        side[body] = (byte) (above ? 1 : -1);
        walled[body] = walls && above && over && radius <= halfSide;
    }

    /** Lets a body rest where it is. */
    void sleep(int body) {
        state[body] = ASLEEP;
        calmSteps[body] = 0;
        int at = STRIDE * body;
        Arrays.fill(numbers, at + MOVE, at + MOVE + 3, 0);
        clearSupport(body);
        numbers[at + INVERSE_MASS] = 0;
        numbers[at + CARRIED] = 0;
    }

    /**
     * Says that a sphere that sleeps is to be awake from the next search on. Until then it is as firm as it was, but
     * for what hits it.
     */
    void rouse(int body) {
        state[body] = WOKEN;
        calmSteps[body] = JUST_WOKEN;
    }

    /** Lets a sphere that slept be moved. */
    void free(int body) {
        int at = STRIDE * body;
        numbers[at + INVERSE_MASS] = inverseMass(numbers[at + RADIUS]);
    }

    /** Whether it has slept, and its contacts' loads are not what they would be if it had not. */
    boolean isJustWoken(int body) {
        return calmSteps[body] == JUST_WOKEN;
    }

    /** Says that the loads of a body's contacts are in balance. */
    void setBraced(int body) {
        calmSteps[body] = Math.max(0, calmSteps[body]);
    }

    void clearSupport(int body) {
        int at = STRIDE * body + SUPPORT;
        Arrays.fill(numbers, at, at + 3, 0);
    }

    /** Of a sphere that contacts move; 1 for the largest one. */
    double inverseMass(double radius) {
        double ratio = largestRadius / radius;
        return ratio * ratio * ratio;
    }
}
