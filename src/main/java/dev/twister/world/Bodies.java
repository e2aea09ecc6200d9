package dev.twister.world;

import dev.twister.kernel.Layout;
import dev.twister.kernel.Material;
import dev.twister.scene.Vector3;
import java.util.Arrays;

/**
 * The bodies as the kernel reads them. {@link Layout} describes the arrays, which are immutable. They have room for all
 * bodies that the scene may have; {@link FrameInput#bodyCount} is the number of present ones.
 *
 * @param places four floats per body: center relative to the origin, and radius; for the plane, its square's center and
 *     side; for a mesh, its bounding sphere
 * @param looks eight floats per body: color (albedo; the light's radiance; the plane's first color), reflectivity in
 *     [0, 128], roughness, transmission, index of refraction and texture
 * @param hierarchy hierarchies over the present spheres, see {@link SphereHierarchy}, and over the meshes; its length
 *     depends only on the room and the meshes
 * @param meshes the distinct meshes of the bodies
 * @param room maximum number of bodies without meshes; meshes are numbered from here
 * @param firstMesh the room, or {@link Layout#NO_MESHES} if no mesh is visible
 * @param materials {@link Material#PLAIN} if all bodies, present or not, have only color and reflectivity, else
 *     {@link Material#ANY}
 * @param origin origin of all coordinates of the input, in the scene's coordinates; near the camera, because floats
 *     lose precision far away
 */
@SuppressWarnings("ArrayRecordComponent") // identity is what counts, see FrameInput
public record Bodies(
        float[] places,
        float[] looks,
        float[] hierarchy,
        float[] meshes,
        int room,
        int firstMesh,
        int materials,
        Vector3 origin) {
    /** One coordinate of a body's center, in meters: axis 0 for x, 1 for y, 2 for z. */
    public float center(int body, int axis) {
        return places[Layout.PLACE_STRIDE * body + axis];
    }

    /** The radius of the light or a sphere, or the plane's side, in meters. */
    public float size(int body) {
        return places[Layout.PLACE_STRIDE * body + Layout.PLACE_SIZE];
    }

    /** {@link Material#PLAIN} or {@link Material#ANY}. */
    static int materials(float[] looks) {
        for (int look = 0; look < looks.length; look++) {
            if (look % Layout.LOOK_STRIDE > Layout.LOOK_REFLECTIVITY && looks[look] != 0) {
                return Material.ANY;
            }
        }
        return Material.PLAIN;
    }

    /** A body's center in the scene's coordinates, in meters. */
    public Vector3 centerInScene(int body) {
        return origin.plus(new Vector3(center(body, 0), center(body, 1), center(body, 2)));
    }

    /** A point of the scene relative to the origin. */
    public Vector3 seen(Vector3 place) {
        return place.minus(origin);
    }

    Bodies withHierarchy(float[] newHierarchy) {
        return new Bodies(places, looks, newHierarchy, meshes, room, firstMesh, materials, origin);
    }

    Bodies withLooksOf(Bodies earlier) {
        return Arrays.equals(earlier.looks, looks)
                ? new Bodies(places, earlier.looks, hierarchy, meshes, room, firstMesh, materials, origin)
                : this;
    }
}
