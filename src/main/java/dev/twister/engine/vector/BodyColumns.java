package dev.twister.engine.vector;

import dev.twister.kernel.Layout;
import dev.twister.world.FrameInput;

/**
 * The bodies: as columns, so that lanes can hold bodies, and in rows, so that what shading asks of one lies in one cache line.
 * Kept while the input's arrays are the same.
 */
final class BodyColumns {
    /** No distance undercuts it: what has this radius is never met. */
    private static final float NOTHING_THERE = -1e30f;

    /** What {@link #surfaces} tell of a body: its centre, its radius, red, green, blue and its reflectivity. */
    static final int SURFACE_NUMBERS = 8;

    private static final int RED = 4;
    private static final int GREEN = 5;
    private static final int BLUE = 6;
    private static final int REFLECTIVITY = 7;

    float[] x = {};
    float[] y = {};
    float[] z = {};

    /** The light's and the spheres'; far below zero for the plane and for the blanks that fill the last packet. */
    float[] radius = {};

    /** All that shading asks, {@value #SURFACE_NUMBERS} numbers a body, body by body. */
    float[] surfaces = {};

    /** The same in columns of {@link Lanes#COUNT}, from {@link Lanes#BORDER} on, where so many hold all bodies. */
    final float[] surfaceColumns = new float[Lanes.BORDER + SURFACE_NUMBERS * Lanes.COUNT];

    /** Light, plane and spheres, without the blanks. */
    int count;

    private FrameInput source;

    @SuppressWarnings("ReferenceEquality") // an input's arrays never change
    void take(FrameInput input) {
        boolean same = source != null
                && source.bodies() == input.bodies()
                && source.bodyPositions() == input.bodyPositions()
                && source.bodySizes() == input.bodySizes()
                && source.bodyColors() == input.bodyColors()
                && source.bodyReflectivities() == input.bodyReflectivities();
        if (!same) {
            copy(input);
        }
        source = input;
    }

    private void copy(FrameInput input) {
        count = input.bodies();
        int padded = (count + Lanes.COUNT - 1) / Lanes.COUNT * Lanes.COUNT;
        if (x.length != padded) {
            x = new float[padded];
            y = new float[padded];
            z = new float[padded];
            radius = new float[padded];
            surfaces = new float[SURFACE_NUMBERS * padded];
        }
        for (int body = 0; body < count; body++) {
            x[body] = input.bodyPositions()[3 * body];
            y[body] = input.bodyPositions()[3 * body + 1];
            z[body] = input.bodyPositions()[3 * body + 2];
            radius[body] = input.bodySizes()[body];
            copySurface(input, body);
        }
        if (fitLanes()) {
            for (int at = 0; at < SURFACE_NUMBERS * count; at++) {
                int column = Lanes.BORDER + at % SURFACE_NUMBERS * Lanes.COUNT;
                surfaceColumns[column + at / SURFACE_NUMBERS] = surfaces[at];
            }
        }
        radius[Layout.PLANE] = NOTHING_THERE;
        for (int blank = count; blank < padded; blank++) {
            radius[blank] = NOTHING_THERE;
        }
    }

    private void copySurface(FrameInput input, int body) {
        int at = SURFACE_NUMBERS * body;
        surfaces[at] = x[body];
        surfaces[at + 1] = y[body];
        surfaces[at + 2] = z[body];
        surfaces[at + 3] = radius[body];
        surfaces[at + RED] = input.bodyColors()[3 * body];
        surfaces[at + GREEN] = input.bodyColors()[3 * body + 1];
        surfaces[at + BLUE] = input.bodyColors()[3 * body + 2];
        surfaces[at + REFLECTIVITY] = input.bodyReflectivities()[body];
    }

    /** Whether one vector holds a number of all bodies. */
    boolean fitLanes() {
        return count <= Lanes.COUNT;
    }

    float red(int body) {
        return surfaces[SURFACE_NUMBERS * body + RED];
    }

    float green(int body) {
        return surfaces[SURFACE_NUMBERS * body + GREEN];
    }

    float blue(int body) {
        return surfaces[SURFACE_NUMBERS * body + BLUE];
    }

    float reflectivity(int body) {
        return surfaces[SURFACE_NUMBERS * body + REFLECTIVITY];
    }
}
