package dev.twister.world;

import dev.twister.kernel.Layout;
import dev.twister.kernel.Material;
import dev.twister.scene.Vector3;
import java.util.Arrays;

/**
 * The bodies as the kernel reads them; {@link Layout} has the places in the arrays, none of which changes. They have
 * room for all bodies that a scene may come to have; {@link FrameInput#bodyCount} tells how many of them are there.
 *
 * @param places four floats a body: each one's center, seen from the origin, and radius; the plane's is its square's
 *     center and side; a mesh's that of a sphere around it
 * @param looks eight floats a body: each body's color (albedo; the light's radiance; the plane's first color),
 *     reflectivity in [0, 128], roughness, transmission, index of refraction and texture
 * @param hierarchy over the spheres that are there: see {@link SphereHierarchy}, and over the meshes; its length
 *     depends on the room and the meshes alone
 * @param meshes the meshes that bodies show, each once
 * @param room how many bodies there may come to be without meshes, which come after them
 * @param firstMesh the room, or {@link Layout#NO_MESHES} where no mesh is seen
 * @param materials {@link Material#PLAIN} where no body, there or not, has more looks than color and reflectivity, else
 *     {@link Material#ANY}
 * @param origin where all coordinates of the input begin, in the scene's own: near the camera, as floats lose digits
 *     far away
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
    /** A coordinate of a body's center, in meters: 0 for x, 1 for y, 2 for z. */
    public float center(int body, int axis) {
        return places[Layout.PLACE_STRIDE * body + axis];
    }

    /** The light's or a sphere's radius, the plane's side, in meters. */
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

    /** A place of the scene, seen from the origin. */
    public Vector3 seen(Vector3 place) {
        return new Vector3(place.x() - origin.x(), place.y() - origin.y(), place.z() - origin.z());
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
