package dev.twister.engine.vector.frame;

import dev.twister.engine.vector.lanes.Lanes;
import dev.twister.kernel.Layout;
import dev.twister.world.Bodies;
import dev.twister.world.FrameInput;
import java.util.Arrays;

/** The spheres around the meshes as columns, so that lanes can hold meshes, and the boxes of those that can be seen. */
public final class MeshColumns {
    /** What has this radius is never met. */
    private static final float NOTHING_THERE = -1e30f;

    public float[] x = {};
    public float[] y = {};
    public float[] z = {};

    /** Far below zero for the blanks that fill the last packet. */
    public float[] radius = {};

    /** How many meshes there are, without the blanks. */
    public int count;

    /** Of a box: low x, y, z and high x, y, z. */
    public static final int BOX_STRIDE = 6;

    public float[] boxes = {};

    /** The body of each box. */
    public int[] boxBodies = {};

    public int boxCount;

    void take(FrameInput input) {
        count = input.bodyEnd() - Math.max(input.bodyCount(), input.bodies().firstMesh());
        int padded = (count + Lanes.COUNT - 1) / Lanes.COUNT * Lanes.COUNT;
        if (x.length != padded) {
            x = new float[padded];
            y = new float[padded];
            z = new float[padded];
            radius = new float[padded];
        }
        Arrays.fill(radius, NOTHING_THERE);
        for (int mesh = 0; mesh < count; mesh++) {
            int body = input.bodies().firstMesh() + mesh;
            x[mesh] = input.bodies().center(body, 0);
            y[mesh] = input.bodies().center(body, 1);
            z[mesh] = input.bodies().center(body, 2);
            radius[mesh] = input.bodies().size(body);
        }
        boxCount = 0;
        if (count > 0) {
            takeBoxes(input.bodies());
        }
    }

    /** Of the leaves of the hierarchy over the meshes, each of which holds one. */
    private void takeBoxes(Bodies bodies) {
        float[] hierarchy = bodies.hierarchy();
        int nodes = Layout.spheresLength(bodies.firstMesh()) + 1;
        int instances = nodes + Layout.NODE_STRIDE * (int) hierarchy[nodes - 1];
        if (boxBodies.length < count) {
            boxBodies = new int[count];
            boxes = new float[BOX_STRIDE * count];
        }
        for (int node = nodes; node < instances; node += Layout.NODE_STRIDE) {
            if (hierarchy[node + Layout.NODE_SPHERES] > 0f) {
                int instance = instances + Layout.INSTANCE_STRIDE * (int) hierarchy[node + Layout.NODE_LINK];
                boxBodies[boxCount] = (int) hierarchy[instance + Layout.INSTANCE_BODY];
                for (int axis = 0; axis < 3; axis++) {
                    float center = hierarchy[node + Layout.NODE_CENTER + axis];
                    float half = hierarchy[node + Layout.NODE_HALF + axis];
                    boxes[BOX_STRIDE * boxCount + axis] = center - half;
                    boxes[BOX_STRIDE * boxCount + 3 + axis] = center + half;
                }
                boxCount++;
            }
        }
    }
}
