package dev.twister.gui.studio;

import dev.twister.gui.edit.BodyEdits;
import dev.twister.gui.edit.BodyNumber;
import dev.twister.physics.SameSpheres;
import dev.twister.scene.Light;
import dev.twister.scene.Mesh;
import dev.twister.scene.Scene;
import dev.twister.scene.light.Lights;
import dev.twister.scene.select.Tag;
import java.util.List;

/**
 * Maps bodies of a picture's scene to bodies of the present scene, see {@link BodyNumber}.
 *
 * @param pictured the scene that the picture shows
 * @param standing the present scene
 * @param renumbered whether bodies were added or deleted in between, even if their count is the same
 */
public record PictureBodies(Scene pictured, Scene standing, boolean renumbered) {
    /** The present number of a body of the picture. */
    public int inScene(int body) {
        return same(standing, pictured, body);
    }

    /** The number in the picture of a body of the present scene. */
    public int inPicture(int body) {
        return same(pictured, standing, body);
    }

    private int same(Scene wanted, Scene given, int body) {
        // Without additions and deletions numbers stay the same; this avoids comparing half a million bodies per
        // picture.
        boolean kept = body == BodyNumber.NONE || body == BodyNumber.PLANE;
        if (kept
                || !renumbered
                || (body == BodyNumber.LIGHT
                        && wanted.lights().count() == 1
                        && given.lights().count() == 1)) {
            return body;
        }
        if (BodyEdits.isLight(given, body)) {
            return sameLight(wanted.lights(), BodyEdits.light(given, body));
        }
        return BodyNumber.mesh(body) < 0
                ? sameSphere(wanted, given, BodyNumber.sphere(body))
                : sameMesh(wanted.meshes(), given, body);
    }

    private static int sameLight(Lights wanted, Light light) {
        int found = wanted.list().stream()
                .map(one -> one.withTag(Tag.NONE))
                .toList()
                .indexOf(light.withTag(Tag.NONE));
        return found < 0 ? BodyNumber.NONE : BodyNumber.ofLight(found);
    }

    private static int sameSphere(Scene wanted, Scene given, int index) {
        // Poured spheres are in the picture only, and not identified in the scene.
        int found = index < given.spheres().size()
                ? SameSpheres.byPlace(wanted.spheres(), given.spheres())[index]
                : SameSpheres.NONE;
        return found == SameSpheres.NONE ? BodyNumber.NONE : BodyNumber.ofSphere(found);
    }

    private static int sameMesh(List<Mesh> wanted, Scene given, int body) {
        List<Mesh> untagged =
                wanted.stream().map(mesh -> mesh.withTag(Tag.NONE)).toList();
        int found = BodyEdits.isMesh(given, body)
                ? untagged.indexOf(BodyEdits.mesh(given, body).withTag(Tag.NONE))
                : -1;
        return found < 0 ? BodyNumber.NONE : BodyNumber.ofMesh(found);
    }
}
