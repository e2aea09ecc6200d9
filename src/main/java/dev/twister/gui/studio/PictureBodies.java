package dev.twister.gui.studio;

import dev.twister.gui.model.BodyEdits;
import dev.twister.gui.model.BodyNumber;
import dev.twister.physics.SameSpheres;
import dev.twister.scene.Mesh;
import dev.twister.scene.Scene;
import java.util.List;

/**
 * Which body of the scene that a picture shows is which one of the scene, which may have been edited since the picture
 * was asked for. See {@link BodyNumber}.
 *
 * @param pictured the scene that the picture shows
 * @param standing the scene as it is now
 * @param renumbered whether bodies came or went in between: as many as before may be others
 */
public record PictureBodies(Scene pictured, Scene standing, boolean renumbered) {
    /** The scene's body that is this one of the picture's scene. */
    public int inScene(int body) {
        return same(standing, pictured, body);
    }

    /** The body of the picture's scene that is this one of the scene. */
    public int inPicture(int body) {
        return same(pictured, standing, body);
    }

    private int same(Scene wanted, Scene given, int body) {
        // As long as bodies neither come nor go, each keeps its number; half a million need not be counted for each
        // picture.
        if (BodyNumber.sphere(body) < 0 || !renumbered) {
            return body;
        }
        return BodyNumber.mesh(body) < 0
                ? sameSphere(wanted, given, BodyNumber.sphere(body))
                : sameMesh(wanted.meshes(), given, body);
    }

    private static int sameSphere(Scene wanted, Scene given, int index) {
        // Poured ones are in the picture, but not in the scene: which is which is not known.
        int found = index < given.spheres().size()
                ? SameSpheres.byPlace(wanted.spheres(), given.spheres())[index]
                : SameSpheres.NONE;
        return found == SameSpheres.NONE ? BodyNumber.NONE : BodyNumber.ofSphere(found);
    }

    private static int sameMesh(List<Mesh> wanted, Scene given, int body) {
        int found = BodyEdits.isMesh(given, body) ? wanted.indexOf(BodyEdits.mesh(given, body)) : -1;
        return found < 0 ? BodyNumber.NONE : BodyNumber.ofMesh(found);
    }
}
