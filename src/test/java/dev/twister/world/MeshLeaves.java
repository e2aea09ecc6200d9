package dev.twister.world;

import dev.twister.kernel.Layout;

/** Meshes whose triangles are all in one leaf, in the same order, so that a walk is the plain loop. */
public final class MeshLeaves {
    private MeshLeaves() {}

    /** The same bodies of one mesh. */
    public static Bodies ofOne(Bodies bodies) {
        float[] hierarchy = bodies.hierarchy();
        float[] meshes = bodies.meshes().clone();
        int triangles = (int)
                hierarchy[Layout.spheresLength(bodies.room()) + 1 + Layout.NODE_STRIDE + Layout.INSTANCE_TRIANGLES];
        meshes[Layout.NODE_LINK] = 0;
        meshes[Layout.NODE_SPHERES] = triangles;
        return new Bodies(
                bodies.places(),
                bodies.looks(),
                hierarchy,
                meshes,
                bodies.room(),
                bodies.firstMesh(),
                bodies.materials(),
                bodies.origin());
    }
}
