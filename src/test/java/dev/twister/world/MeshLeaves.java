package dev.twister.world;

import dev.twister.kernel.Layout;

/** Meshes with all triangles in one leaf in the same order, so that traversal is the brute-force loop. */
public final class MeshLeaves {
    private MeshLeaves() {}

    /** Returns the same bodies, all of one mesh shape, with one leaf. */
    public static Bodies ofOne(Bodies bodies) {
        float[] meshes = bodies.meshes().clone();
        int instance = bodies.instances() + 1 + Layout.NODE_STRIDE;
        meshes[Layout.NODE_LINK] = 0;
        meshes[Layout.NODE_SPHERES] = bodies.floats()[instance + Layout.INSTANCE_TRIANGLES];
        return new Bodies(
                bodies.floats(),
                bodies.looks(),
                meshes,
                bodies.room(),
                bodies.sphereEnd(),
                bodies.end(),
                bodies.firstMesh(),
                bodies.materials(),
                bodies.origin(),
                bodies.hierarchy());
    }
}
