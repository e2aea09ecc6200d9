package dev.twister.gui.bodies;

import dev.twister.gui.drawing.DrawnPicture;
import dev.twister.gui.edit.BodyEdits;
import dev.twister.gui.edit.SelectedBodies;
import dev.twister.gui.picking.SurfacePoint;
import dev.twister.gui.picking.SurfacePoint.RestingBody;
import dev.twister.gui.studio.Studio;
import dev.twister.scene.Vector3;
import java.util.Optional;

/** Puts the active body on the surface under the pointer, seen through the selected bodies. */
final class SurfaceRest {
    private final Studio studio;
    private final SelectedBodies held;
    private final RestingBody resting;
    private final Vector3 start;

    private SurfaceRest(Studio studio, DrawnPicture picture) {
        this.studio = studio;
        held = studio.selection().bodies();
        resting = RestingBody.of(studio.bodies().scene(), picture.meshes(), held.active());
        start = studio.bodies().position(held.active());
    }

    /** Takes the selected bodies; empty where the active one cannot be moved. */
    static Optional<SurfaceRest> of(Studio studio, DrawnPicture picture) {
        return Optional.of(studio.selection().active())
                .filter(active -> BodyEdits.isMovable(studio.scene(), active))
                .map(_ -> new SurfaceRest(studio, picture));
    }

    /** The way from its position at the start; see {@link #place}. */
    Optional<Vector3> way(double x, double y) {
        return place(x, y).map(place -> place.minus(start));
    }

    /**
     * The active body's position; empty where the sky is.
     *
     * @param x in pixels of the present picture
     * @param y in pixels of the present picture
     */
    Optional<Vector3> place(double x, double y) {
        return studio.pictureProperty()
                .get()
                .flatMap(picture -> SurfacePoint.under(picture.input(), x, y, body -> isHeld(picture.sceneBody(body)))
                        .map(resting::on));
    }

    private boolean isHeld(int body) {
        return studio.picturedBodies()
                .map(bodies -> bodies.inScene(body))
                .filter(held::contains)
                .isPresent();
    }
}
