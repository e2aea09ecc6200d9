package dev.twister.world;

import dev.twister.kernel.Layout;

/** Meshes with all triangles in one leaf in the same order, so that traversal is the brute-force loop. */
public final class MeshLeaves {
    private MeshLeaves() {}

    /** Returns the same bodies, all of one mesh shape, with one leaf. */
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
