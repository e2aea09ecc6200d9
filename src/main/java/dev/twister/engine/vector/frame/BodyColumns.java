package dev.twister.engine.vector.frame;

import dev.twister.engine.vector.lanes.Lanes;
import dev.twister.kernel.Layout;
import dev.twister.world.FrameInput;

/**
 * The bodies in columns, for loads into lanes, and in rows, so that shading one body reads one cache line. Reused while
 * the input's arrays are the same.
 */
public final class BodyColumns {
    /** Radius of entries that are never hit. */
    private static final float NOTHING_THERE = -1e30f;

    /** Floats per body in {@link #surfaces}: center, radius, red, green, blue, reflectivity. */
    public static final int SURFACE_NUMBERS = 8;

    /** Offsets of y, z and radius from x. */
    public static final int Y = 1;

    public static final int Z = 2;
    public static final int RADIUS = 3;

    private static final int RED = 4;
    private static final int GREEN = 5;
    private static final int BLUE = 6;
    private static final int REFLECTIVITY = 7;

    public float[] x = {};
    public float[] y = {};
    public float[] z = {};

    /** Radii in meters; {@link #NOTHING_THERE} for the plane and for the padding of the last packet. */
    public float[] radius = {};

    /** The meshes' bounding spheres. */
    public final MeshColumns meshes = new MeshColumns();

    /**
     * The data for shading, {@value #SURFACE_NUMBERS} floats per body at its {@link #surfacePlaces}. Spheres are in the
     * order of the hierarchy's leaves, because neighbors are hit together. Meshes have their bounding spheres.
     */
    public float[] surfaces = {};

    /** The same in columns of {@link Lanes#COUNT} from {@link Lanes#BORDER} on, if {@link #fitLanes}. */
    public final float[] surfaceColumns = new float[Lanes.BORDER + SURFACE_NUMBERS * Lanes.COUNT];

    /** Per body, the start of its data in {@link #surfaces}. */
    public int[] surfacePlaces = {};

    /** Number of bodies (light, plane and spheres), without padding. */
    public int count;

    /** Lowest and highest y of the spheres and meshes, in meters. */
    float lowest;

    float highest;

    /** One more than the highest body number. */
    private int end;

    private FrameInput source;

    @SuppressWarnings("ReferenceEquality") // an input's arrays are immutable
    public void take(FrameInput input) {
        boolean sameSpheres = source != null
                && source.bodyCount() == input.bodyCount()
                && source.bodies().hasHierarchyOf(input.bodies())
                && source.bodies().looks() == input.bodies().looks();
        if (!sameSpheres || fitLanes() || input.bodyEnd() > count) {
            if (!sameSpheres || source.bodies().floats() != input.bodies().floats()) {
                copy(input);
            }
        } else {
            for (int body = 0; body < Layout.FIRST_SPHERE; body++) {
                copyPlace(input, body);
                copySurface(input, body, SURFACE_NUMBERS * body);
            }
            radius[Layout.PLANE] = NOTHING_THERE;
        }
        source = input;
    }

    private void copy(FrameInput input) {
        count = input.bodyCount();
        end = input.bodyEnd();
        int padded = (count + Lanes.COUNT - 1) / Lanes.COUNT * Lanes.COUNT;
        if (x.length != padded) {
            x = new float[padded];
            y = new float[padded];
            z = new float[padded];
            radius = new float[padded];
        }
        if (surfacePlaces.length < Math.max(padded, end)) {
            surfaces = new float[SURFACE_NUMBERS * Math.max(padded, end)];
            surfacePlaces = new int[Math.max(padded, end)];
        }
        float[] floats = input.bodies().floats();
        lowest = Float.MAX_VALUE;
        highest = -Float.MAX_VALUE;
        for (int body = 0; body < count; body++) {
            copyPlace(input, body);
            if (body >= Layout.FIRST_SPHERE) {
                lowest = Math.min(lowest, y[body] - radius[body]);
                highest = Math.max(highest, y[body] + radius[body]);
            }
        }
        int spheres = input.bodies().spheres();
        for (int place = 0; place < count; place++) {
            int sphere = place - Layout.FIRST_SPHERE;
            int body = sphere < 0 ? place : (int) floats[spheres + sphere * Layout.SPHERE_STRIDE + Layout.SPHERE_BODY];
            copySurface(input, body, SURFACE_NUMBERS * place);
        }
        for (int body = Math.max(count, input.bodies().firstMesh()); body < end; body++) {
            copySurface(input, body, SURFACE_NUMBERS * body);
        }
        meshes.take(input);
        if (meshes.count > 0) {
            lowest = Math.min(lowest, meshes.lowest);
            highest = Math.max(highest, meshes.highest);
        }
        if (fitLanes()) {
            for (int body = 0; body < end; body++) {
                for (int number = 0; number < SURFACE_NUMBERS; number++) {
                    surfaceColumns[Lanes.BORDER + number * Lanes.COUNT + body] = surfaces[surfacePlaces[body] + number];
                }
            }
        }
        radius[Layout.PLANE] = NOTHING_THERE;
        for (int blank = count; blank < padded; blank++) {
            radius[blank] = NOTHING_THERE;
        }
    }

    private void copyPlace(FrameInput input, int body) {
        float[] floats = input.bodies().floats();
        int place = Layout.PLACE_STRIDE * body;
        x[body] = floats[place];
        y[body] = floats[place + 1];
        z[body] = floats[place + 2];
        radius[body] = floats[place + Layout.PLACE_SIZE];
    }

    private void copySurface(FrameInput input, int body, int at) {
        surfacePlaces[body] = at;
        System.arraycopy(input.bodies().floats(), Layout.PLACE_STRIDE * body, surfaces, at, RADIUS + 1);
        System.arraycopy(
                input.bodies().looks(), Layout.LOOK_STRIDE * body, surfaces, at + RED, Layout.LOOK_REFLECTIVITY + 1);
    }

    /** Whether one vector holds a value for each body. */
    public boolean fitLanes() {
        return end <= Lanes.COUNT;
    }

    /** A sphere's radius, read from the cache line of its other shading data. */
    public float sphereRadius(int body) {
        return surfaces[surfacePlaces[body] + RADIUS];
    }

    public float red(int body) {
        return surfaces[surfacePlaces[body] + RED];
    }

    public float green(int body) {
        return surfaces[surfacePlaces[body] + GREEN];
    }

    public float blue(int body) {
        return surfaces[surfacePlaces[body] + BLUE];
    }

    public float reflectivity(int body) {
        return surfaces[surfacePlaces[body] + REFLECTIVITY];
    }
}
