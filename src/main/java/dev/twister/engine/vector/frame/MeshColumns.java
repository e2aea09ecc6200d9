package dev.twister.engine.vector.frame;

import dev.twister.engine.vector.lanes.Lanes;
import dev.twister.kernel.Layout;
import dev.twister.world.FrameInput;
import java.util.Arrays;

/** The meshes' bounding spheres in columns, for loads into lanes. */
public final class MeshColumns {
    /** Radius of entries that are never hit. */
    private static final float NOTHING_THERE = -1e30f;

    public float[] x = {};
    public float[] y = {};
    public float[] z = {};

    /** Radii in meters; {@link #NOTHING_THERE} for the padding of the last packet. */
    public float[] radius = {};

    /** More than any number of bodies, and exact as a float. */
    private static final int ABOVE_ALL = 1 << 30;

    /** Number of meshes, without padding. */
    public int count;

    /** Body number of the first mesh; above all others if there are no meshes. */
    public int firstBody;

    /** Lowest and highest y of the visible meshes, in meters. */
    float lowest;

    float highest;

    public void take(FrameInput input) {
        int first = input.bodies().firstMesh();
        count = first > 0 ? input.bodyEnd() - Math.max(input.bodyCount(), first) : 0;
        firstBody = count > 0 ? first : ABOVE_ALL;
        int padded = (count + Lanes.COUNT - 1) / Lanes.COUNT * Lanes.COUNT;
        if (x.length != padded) {
            x = new float[padded];
            y = new float[padded];
            z = new float[padded];
            radius = new float[padded];
        }
        Arrays.fill(radius, NOTHING_THERE);
        for (int mesh = 0; mesh < count; mesh++) {
            int body = firstBody + mesh;
            x[mesh] = input.bodies().center(body, 0);
            y[mesh] = input.bodies().center(body, 1);
            z[mesh] = input.bodies().center(body, 2);
            radius[mesh] = input.bodies().size(body);
        }
        if (count > 0) {
            float[] floats = input.bodies().floats();
            int root = input.bodies().instances() + 1;
            float middle = floats[root + Layout.NODE_CENTER + 1];
            float half = floats[root + Layout.NODE_HALF + 1];
            lowest = middle - half;
            highest = middle + half;
        }
    }
}
