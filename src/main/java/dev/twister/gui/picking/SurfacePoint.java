package dev.twister.gui.picking;

import dev.twister.kernel.Layout;
import dev.twister.scene.Vector3;
import dev.twister.world.FrameInput;
import java.util.Optional;
import java.util.function.IntPredicate;

/**
 * A place on the surface of a body.
 *
 * @param normal of length 1, to the side from which it is seen
 */
public record SurfacePoint(Vector3 place, Vector3 normal) {
    /**
     * What is seen at a place on the picture; empty for the sky.
     *
     * @param x in pixels of the picture from its left border
     * @param y in pixels from its upper border
     * @param passed whether a body of the picture is looked through
     */
    public static Optional<SurfacePoint> under(FrameInput input, double x, double y, IntPredicate passed) {
        PointerRay ray = PointerRay.through(input, x, y).beyond(input, passed);
        return ray.body() == Layout.NOTHING
                ? Optional.empty()
                : Optional.of(new SurfacePoint(ray.along(ray.distance()), ray.normal(input)));
    }
}
