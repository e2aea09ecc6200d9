package dev.twister.world;

import dev.twister.kernel.Layout;
import dev.twister.kernel.Variant;
import dev.twister.scene.Vector3;
import dev.twister.world.hierarchy.SphereHierarchy;

/**
 * The bodies as the kernel reads them. {@link Layout} describes the arrays, which are immutable. They have room for all
 * bodies that the scene may have; {@link FrameInput#bodyCount} is the number of present ones.
 *
 * @param floats the array {@code bodies} of {@link Layout}: places relative to the origin, then the hierarchies over
 *     the present spheres, see {@link SphereHierarchy}, and over the meshes; its length depends only on the room, the
 *     lights and the meshes
 * @param looks the array {@code looks} of {@link Layout}: materials, then the maps' table
 * @param meshes the distinct meshes of the bodies
 * @param room maximum number of bodies without meshes and lights after the first; these lights are numbered from here
 * @param sphereEnd one more than the highest number of a sphere, lights included
 * @param end one more than the highest body number, including meshes
 * @param firstMesh the first body after the lights, or {@link Layout#NO_MESHES} if no mesh is visible
 * @param materials bits of {@link Variant}: what the materials of all bodies, present or not, need of the kernel, and
 *     whether present spheres are in one place
 * @param origin origin of all coordinates of the input, in the scene's coordinates; near the camera, because floats
 *     lose precision far away
 */
@SuppressWarnings("ArrayRecordComponent") // identity is what counts, see FrameInput
public record Bodies(
        float[] floats,
        float[] looks,
        float[] meshes,
        int room,
        int sphereEnd,
        int end,
        int firstMesh,
        int materials,
        Vector3 origin,
        SphereHierarchy.Identity hierarchy) {
    /** One coordinate of a body's center, in meters: axis 0 for x, 1 for y, 2 for z. */
    public float center(int body, int axis) {
        return floats[Layout.PLACE_STRIDE * body + axis];
    }

    /** The radius of a light or a sphere, or the plane's side, in meters. */
    public float size(int body) {
        return floats[Layout.PLACE_STRIDE * body + Layout.PLACE_SIZE];
    }

    /** Whether some body transmits light and takes a part of it. */
    public boolean absorb() {
        boolean absorb = false;
        for (int body = Layout.FIRST_SPHERE; body < end && !plain() && !absorb; body++) {
            int absorption = Layout.LOOK_STRIDE * body + Layout.LOOK_ABSORPTION;
            absorb = isMedium(body) && looks[absorption] + looks[absorption + 1] + looks[absorption + 2] > 0;
        }
        return absorb;
    }

    /** Whether a body transmits light and has an inside. */
    public boolean isMedium(int body) {
        int look = Layout.LOOK_STRIDE * body;
        return looks[look + Layout.LOOK_TRANSMISSION] > 0 && looks[look + Layout.LOOK_SHEET] == 0;
    }

    /** Place of the first sphere of the spheres' hierarchy. */
    public int spheres() {
        return Layout.PLACE_STRIDE * end;
    }

    /** Place of the meshes' hierarchy. */
    public int instances() {
        return spheres() + Layout.spheresLength(sphereEnd - Layout.FIRST_SPHERE);
    }

    /** Place of the maps' table in the looks. */
    public int textures() {
        return Layout.LOOK_STRIDE * end;
    }

    /** A body's center in the scene's coordinates, in meters. */
    public Vector3 centerInScene(int body) {
        return origin.plus(new Vector3(center(body, 0), center(body, 1), center(body, 2)));
    }

    /** A point of the scene relative to the origin. */
    public Vector3 seen(Vector3 place) {
        return place.minus(origin);
    }

    /** Whether the other ones have the same hierarchy over the spheres, in the same place. */
    @SuppressWarnings("ReferenceEquality") // see SphereHierarchy.Identity
    public boolean hasHierarchyOf(Bodies other) {
        return hierarchy == other.hierarchy;
    }

    /** Whether all bodies, present or not, have only color and reflectivity. */
    public boolean plain() {
        return materials == 0;
    }

    Bodies withLooks(float[] newLooks) {
        return new Bodies(floats, newLooks, meshes, room, sphereEnd, end, firstMesh, materials, origin, hierarchy);
    }

    Bodies withFloats(float[] newFloats) {
        return new Bodies(
                newFloats,
                looks,
                meshes,
                room,
                sphereEnd,
                end,
                firstMesh,
                materials,
                origin,
                new SphereHierarchy.Identity());
    }
}
