package dev.twister.world.table;

import dev.twister.kernel.Layout;
import dev.twister.scene.Vector3;

/** The axis-aligned bounding box of a mesh body in world coordinates. */
record MeshBox(Vector3 low, Vector3 high) {
    private static final int CORNERS = 8;

    /** The box around the transformed corners of the mesh's own bounding box. */
    static MeshBox of(MeshBody body, float[] meshes) {
        Vector3 low = new Vector3(Double.MAX_VALUE, Double.MAX_VALUE, Double.MAX_VALUE);
        Vector3 high = new Vector3(-Double.MAX_VALUE, -Double.MAX_VALUE, -Double.MAX_VALUE);
        int root = body.place().start();
        for (int corner = 0; corner < CORNERS; corner++) {
            Vector3 point = body.placement()
                    .point(new Vector3(
                            side(meshes, root, 0, corner & 1),
                            side(meshes, root, 1, corner & 2),
                            side(meshes, root, 2, corner & 4)));
            low = low.map(point, Math::min);
            high = high.map(point, Math::max);
        }
        return new MeshBox(low, high);
    }

    private static double side(float[] meshes, int root, int axis, int isHigh) {
        double half = meshes[root + Layout.NODE_HALF + axis];
        return meshes[root + Layout.NODE_CENTER + axis] + (isHigh == 0 ? -half : half);
    }

    void write(float[] boxes, int at) {
        boxes[at] = Math.nextDown((float) low.x());
        boxes[at + 1] = Math.nextDown((float) low.y());
        boxes[at + 2] = Math.nextDown((float) low.z());
        boxes[at + 3] = Math.nextUp((float) high.x());
        boxes[at + 4] = Math.nextUp((float) high.y());
        boxes[at + 5] = Math.nextUp((float) high.z());
    }

    Vector3 center() {
        return low.plus(high).times(0.5);
    }

    /** Radius of the sphere around the box. */
    double radius() {
        return high.minus(low).length() / 2;
    }
}
