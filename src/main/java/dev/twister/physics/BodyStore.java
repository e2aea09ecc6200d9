package dev.twister.physics;

import dev.twister.scene.Ground;
import dev.twister.scene.Light;
import dev.twister.scene.Physics;
import dev.twister.scene.Scene;
import dev.twister.scene.Sphere;
import dev.twister.scene.Vector3;
import dev.twister.scene.light.Lights;
import java.util.Arrays;
import java.util.List;

/**
 * The state of all bodies in arrays. The lights come first, then the spheres, in an order that changes so that
 * neighbors in space are close in memory. A body's values are contiguous, because a contact needs all values of two
 * bodies.
 */
final class BodyStore {
    static final int FIRST_LIGHT = 0;

    /** Doubles per body in {@link #numbers}, at the offsets below. */
    static final int STRIDE = 12;

    /** Center x, y and z, in meters. */
    static final int POSITION = 0;

    /** Radius in meters. */
    static final int RADIUS = 3;

    /**
     * Displacement of the center in the last sub-step, in meters: Verlet's current position minus the previous one. It
     * is stored instead of the previous position because it keeps its precision far from the origin.
     */
    static final int MOVE = 4;

    /**
     * Inverse mass, 1 for the largest sphere of the scene; 0 for bodies that contacts do not move: the lights and
     * sleeping ones.
     */
    static final int INVERSE_MASS = 7;

    /** Sum of the contacts' impulses of the last sub-step as a displacement; warm-starts the next sub-step. */
    static final int SUPPORT = 8;

    /** Length of {@link #SUPPORT} when it was last added to {@link #MOVE}; 0 while asleep. */
    static final int CARRIED = 11;

    static final byte AWAKE = 0;
    static final byte ASLEEP = 1;

    /** Woken since the last search: its remaining contacts are unknown until the next one. */
    static final byte WOKEN = 2;

    /** Value of {@link #calmSteps} until the loads of the body's contacts are in balance again. */
    private static final int JUST_WOKEN = -1;

    final double[] numbers;

    /** Distance from the center within which contacts are possible until the next search, in meters. */
    final double[] reach;

    /** Centers one step ago: 3 doubles per body, in meters. */
    final double[] before;

    /** Number of sub-steps for which the body still counts as supported by others. */
    final byte[] held;

    final byte[] state;

    /** 1 above the plane, -1 below. It stays constant over the square, so that no force presses a body through. */
    final byte[] side;

    /** Whether the walls confine the body: it was between them at the start, and fits. */
    final boolean[] walled;

    /** The sphere's number in the scene, from 0; -1 for a light. */
    final int[] sphere;

    /** Number of consecutive steps in which the body was almost at rest on others. */
    final int[] calmSteps;

    /** The first sphere's body: number of lights. */
    final int firstSphere;

    /** Number of present bodies: the lights that have a place, and the first spheres. */
    int count;

    private double smallestRadius = Double.POSITIVE_INFINITY;
    private final double largestRadius;
    private final double halfSide;
    private final double planeHeight;
    private final boolean walls;

    BodyStore(Scene scene, List<Sphere> spheres) {
        firstSphere = scene.lights().placed().size();
        count = firstSphere;
        int room = firstSphere + spheres.size();
        numbers = new double[STRIDE * room];
        before = new double[3 * room];
        held = new byte[room];
        reach = new double[room];
        state = new byte[room];
        side = new byte[room];
        walled = new boolean[room];
        calmSteps = new int[room];
        sphere = new int[room];
        Ground plane = scene.ground();
        halfSide = plane.size() / 2;
        planeHeight = plane.height();
        Physics physics = scene.physics();
        walls = physics.walls();
        largestRadius = spheres.stream().mapToDouble(Sphere::radius).max().orElse(1);
        putLights(scene.lights());
        Arrays.fill(sphere, FIRST_LIGHT, firstSphere, -1);
        // Nothing moves a light, so it never wakes and never searches for pairs.
        Arrays.fill(state, FIRST_LIGHT, firstSphere, ASLEEP);
    }

    /** Adds the next sphere. */
    void add(Vector3 position, double radius) {
        put(count, position, radius);
        sphere[count] = count - firstSphere;
        smallestRadius = Math.min(smallestRadius, radius);
        count++;
    }

    /** Moves the lights, as many as there are, which are fixed during the simulation. */
    void putLights(Lights lights) {
        int body = FIRST_LIGHT;
        for (Light light : lights.placed()) {
            put(body, light.position(), light.radius());
            numbers[STRIDE * body + INVERSE_MASS] = 0;
            body++;
        }
    }

    boolean isLight(int body) {
        return body < firstSphere;
    }

    /** Copies a body's position, and that of one step ago, from another store. */
    void putWhere(int body, BodyStore other, int from) {
        int at = STRIDE * from + POSITION;
        Vector3 place = new Vector3(other.numbers[at], other.numbers[at + 1], other.numbers[at + 2]);
        put(body, place, numbers[STRIDE * body + RADIUS]);
        System.arraycopy(other.before, 3 * from, before, 3 * body, 3);
    }

    /** The body number of each present sphere of the scene. */
    int[] bodiesOfSpheres() {
        int[] places = new int[count - firstSphere];
        for (int body = firstSphere; body < count; body++) {
            places[sphere[body]] = body;
        }
        return places;
    }

    /** Sets a body's displacement per sub-step, in meters. */
    void setMove(int body, double x, double y, double z) {
        int at = STRIDE * body + MOVE;
        numbers[at] = x;
        numbers[at + 1] = y;
        numbers[at + 2] = z;
    }

    /** Smallest radius of the present spheres; infinite if there are none. */
    double smallestRadius() {
        return smallestRadius;
    }

    /**
     * Changes the order of the spheres.
     *
     * @param order for each new place, the body's old number
     */
    void reorder(int[] order) {
        double[] oldNumbers = Arrays.copyOf(numbers, STRIDE * count);
        double[] oldBefore = Arrays.copyOf(before, 3 * count);
        byte[] oldState = Arrays.copyOf(state, count);
        byte[] oldSide = Arrays.copyOf(side, count);
        byte[] oldHeld = Arrays.copyOf(held, count);
        boolean[] oldWalled = Arrays.copyOf(walled, count);
        int[] oldCalmSteps = Arrays.copyOf(calmSteps, count);
        int[] oldSphere = Arrays.copyOf(sphere, count);
        for (int body = firstSphere; body < count; body++) {
            int old = order[body];
            System.arraycopy(oldNumbers, STRIDE * old, numbers, STRIDE * body, STRIDE);
            System.arraycopy(oldBefore, 3 * old, before, 3 * body, 3);
            state[body] = oldState[old];
            side[body] = oldSide[old];
            held[body] = oldHeld[old];
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

    /** Puts a body to sleep. */
    void sleep(int body) {
        state[body] = ASLEEP;
        calmSteps[body] = 0;
        int at = STRIDE * body;
        Arrays.fill(numbers, at + MOVE, at + MOVE + 3, 0);
        clearSupport(body);
        numbers[at + INVERSE_MASS] = 0;
        numbers[at + CARRIED] = 0;
    }

    /** Wakes a sleeping sphere at the next search. Until then it stays immovable, except for impacts. */
    void rouse(int body) {
        state[body] = WOKEN;
        calmSteps[body] = JUST_WOKEN;
    }

    /** Lets contacts move a sphere that slept. */
    void free(int body) {
        int at = STRIDE * body;
        numbers[at + INVERSE_MASS] = inverseMass(numbers[at + RADIUS]);
    }

    /** Whether the body has woken and the loads of its contacts are not in balance yet. */
    boolean isJustWoken(int body) {
        return calmSteps[body] == JUST_WOKEN;
    }

    /** Records that the loads of a body's contacts are in balance. */
    void setBraced(int body) {
        calmSteps[body] = Math.max(0, calmSteps[body]);
    }

    void clearSupport(int body) {
        int at = STRIDE * body + SUPPORT;
        Arrays.fill(numbers, at, at + 3, 0);
    }

    /** The inverse mass of a movable sphere; 1 for the largest one. */
    double inverseMass(double radius) {
        double ratio = largestRadius / radius;
        return ratio * ratio * ratio;
    }

    /**
     * Adds a weighted vector to three consecutive values of a body.
     *
     * @param numbers see {@link #numbers}
     * @param at index of the first value
     */
    static void add(double[] numbers, int at, double weight, double x, double y, double z) {
        numbers[at] += weight * x;
        numbers[at + 1] += weight * y;
        numbers[at + 2] += weight * z;
    }
}
