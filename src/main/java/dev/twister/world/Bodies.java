package dev.twister.world;

import dev.twister.kernel.Layout;
import dev.twister.kernel.Material;
import dev.twister.scene.Vector3;
import java.util.Arrays;

/**
 * The bodies as the kernel reads them; {@link Layout} has the places in the arrays, none of which changes. They have room for
 * all bodies that a scene may come to have; {@link FrameInput#bodyCount} tells how many of them are there.
 *
 * @param places {@code float[4 * room]}: each body's center, seen from the origin, and radius; the plane's is its
 *     square's center and side
 * @param looks {@code float[8 * room]}: each body's color (albedo; the light's radiance; the plane's first color),
 *     reflectivity in [0, 128], roughness, transmission, index of refraction and texture
 * @param hierarchy over the spheres that are there: see {@link SphereHierarchy}; its length depends on the room alone
 * @param materials {@link Material#PLAIN} where no body, there or not, has more looks than color and reflectivity, else
 *     {@link Material#ANY}
 * @param origin where all coordinates of the input begin, in the scene's own: near the camera, as floats lose digits
 *     far away
 */
@SuppressWarnings("ArrayRecordComponent") // identity is what counts, see FrameInput
public record Bodies(float[] places, float[] looks, float[] hierarchy, int materials, Vector3 origin) {
    /** How many bodies there may come to be. */
    public int room() {
        return places.length / Layout.PLACE_STRIDE;
    }

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
        return new Bodies(places, looks, newHierarchy, materials, origin);
    }

    Bodies withLooksOf(Bodies earlier) {
        return Arrays.equals(earlier.looks, looks)
                ? new Bodies(places, earlier.looks, hierarchy, materials, origin)
                : this;
    }
}
