package dev.twister.gui;

import dev.twister.gui.model.BodyNumber;
import dev.twister.physics.SameSpheres;
import dev.twister.scene.Sphere;
import java.util.List;

/**
 * Which body of a picture is which one of the scene, which may have been edited since the picture was asked for. See
 * {@link BodyNumber}.
 *
 * @param pictured the spheres that the picture shows
 * @param standing the spheres that the scene has now
 * @param renumbered whether spheres came or went in between: as many as before may be others
 */
record PictureBodies(List<Sphere> pictured, List<Sphere> standing, boolean renumbered) {
    /** The scene's body that is this one of the picture. */
    int inScene(int body) {
        return same(standing, pictured, body);
    }

    /** The picture's body that is this one of the scene. */
    int inPicture(int body) {
        return same(pictured, standing, body);
    }

    private int same(List<Sphere> wanted, List<Sphere> given, int body) {
        int index = BodyNumber.sphere(body);
        // As long as spheres neither come nor go, each keeps its number; half a million need not be counted for each
        // picture.
        if (index < 0 || !renumbered) {
            return body;
        }
        // Poured ones are in the picture, but not in the scene: which is which is not known.
        int found = index < given.size() ? SameSpheres.byPlace(wanted, given)[index] : SameSpheres.NONE;
        return found == SameSpheres.NONE ? BodyNumber.NONE : BodyNumber.ofSphere(found);
    }
}
