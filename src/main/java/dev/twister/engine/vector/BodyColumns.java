package dev.twister.engine.vector;

import dev.twister.kernel.Layout;
import dev.twister.world.FrameInput;

/** The bodies as columns, so that lanes can hold bodies; kept while the input's arrays are the same. */
final class BodyColumns {
    /** No distance undercuts it: what has this radius is never met. */
    private static final float NOTHING_THERE = -1e30f;

    float[] x = {};
    float[] y = {};
    float[] z = {};

    /** The light's and the spheres'; far below zero for the plane and for the blanks that fill the last packet. */
    float[] radius = {};

    float[] red = {};
    float[] green = {};
    float[] blue = {};
    float[] reflectivity = {};

    /** The columns above in their order: all that shading asks of a body. */
    float[][] surfaces = {x, y, z, radius, red, green, blue, reflectivity};

    /** Light, plane and spheres, without the blanks. */
    int count;

    /** The light and all spheres: what culling starts from. */
    final BodyList round = new BodyList();

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
            red = new float[padded];
            green = new float[padded];
            blue = new float[padded];
            reflectivity = new float[padded];
            surfaces = new float[][] {x, y, z, radius, red, green, blue, reflectivity};
            round.reserve(padded);
        }
        round.clear();
        for (int body = 0; body < count; body++) {
            x[body] = input.bodyPositions()[3 * body];
            y[body] = input.bodyPositions()[3 * body + 1];
            z[body] = input.bodyPositions()[3 * body + 2];
            radius[body] = input.bodySizes()[body];
            red[body] = input.bodyColors()[3 * body];
            green[body] = input.bodyColors()[3 * body + 1];
            blue[body] = input.bodyColors()[3 * body + 2];
            reflectivity[body] = input.bodyReflectivities()[body];
            if (body != Layout.PLANE) {
                round.add(body);
            }
        }
        radius[Layout.PLANE] = NOTHING_THERE;
        for (int blank = count; blank < padded; blank++) {
            radius[blank] = NOTHING_THERE;
        }
    }
}
