package dev.twister.world.table;

import dev.twister.kernel.Layout;
import dev.twister.mesh.Affine;
import dev.twister.scene.Material;
import dev.twister.scene.Vector3;
import dev.twister.scene.material.Alpha;

/**
 * What a leaf of the hierarchy over the meshes has: an instance, or, of a mesh whose own hierarchy is one leaf, its
 * triangles in the world's coordinates, see {@link Layout#SMALL_INSTANCE}. For these, rays need not be transformed.
 *
 * @param triangles number of triangles; 0 for an instance
 * @param floats the triangles' data, without the instance's number; none for an instance
 */
@SuppressWarnings("ArrayRecordComponent") // never compared
record InstanceLeaf(MeshBox box, int triangles, float[] floats) {
    /** @param mayBeSmall whether the leaf may have triangles */
    static InstanceLeaf of(MeshBody body, float[] meshes, boolean mayBeSmall) {
        return mayBeSmall && body.place().counts().nodes() == 1 && isOpaque(body.material())
                ? inWorld(body, meshes)
                : new InstanceLeaf(MeshBox.of(body, meshes), 0, new float[0]);
    }

    /** Of other materials, rays need places in the mesh's coordinates, or meet the body once. */
    private static boolean isOpaque(Material material) {
        return material.transmission() == 0 && material.alpha().mode() == Alpha.Mode.OPAQUE;
    }

    private static InstanceLeaf inWorld(MeshBody body, float[] meshes) {
        int leaf = body.place().start();
        int first = leaf + Layout.NODE_STRIDE;
        int count = (int) meshes[leaf + Layout.NODE_SPHERES];
        float[] floats = new float[Layout.SMALL_TRIANGLES + Layout.TRIANGLE_STRIDE * count];
        Vector3 low = new Vector3(Double.MAX_VALUE, Double.MAX_VALUE, Double.MAX_VALUE);
        Vector3 high = low.times(-1);
        for (int corner = 0; corner < 3 * count; corner++) {
            int offset = Layout.TRIANGLE_STRIDE * (corner / 3) + 3 * (corner % 3);
            int at = first + offset;
            Vector3 inMesh = new Vector3(meshes[at], meshes[at + 1], meshes[at + 2]);
            Vector3 point = body.placement().point(inMesh);
            int place = Layout.SMALL_TRIANGLES + offset;
            floats[place] = (float) point.x();
            floats[place + 1] = (float) point.y();
            floats[place + 2] = (float) point.z();
            floats[Layout.SMALL_REACH] = Math.max(floats[Layout.SMALL_REACH], reach(body.placement(), inMesh));
            low = low.map(point, Math::min);
            high = high.map(point, Math::max);
        }
        return new InstanceLeaf(new MeshBox(low, high), count, floats);
    }

    /** The largest sum of magnitudes that the coordinates of a transformed point are sums of. */
    private static float reach(Affine placement, Vector3 point) {
        Vector3 sum = magnitude(placement.axisX().times(point.x()))
                .plus(magnitude(placement.axisY().times(point.y())))
                .plus(magnitude(placement.axisZ().times(point.z())))
                .plus(magnitude(placement.origin()));
        return (float) Math.max(Math.max(sum.x(), sum.y()), sum.z());
    }

    private static Vector3 magnitude(Vector3 vector) {
        return new Vector3(Math.abs(vector.x()), Math.abs(vector.y()), Math.abs(vector.z()));
    }
}
