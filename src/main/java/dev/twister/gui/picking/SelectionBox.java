package dev.twister.gui.picking;

import dev.twister.gui.edit.BodyEdits;
import dev.twister.scene.Scene;
import dev.twister.scene.Vector3;
import dev.twister.world.FrameInput;
import java.util.List;
import java.util.function.Function;

/**
 * A box in a picture, which selects the bodies whose middle is in it.
 *
 * @param left in pixels
 * @param top in pixels
 * @param right in pixels, at least the left
 * @param bottom in pixels, at least the top
 */
public record SelectionBox(double left, double top, double right, double bottom) {
    /** The box between two corners. */
    public static SelectionBox between(double x, double y, double otherX, double otherY) {
        return new SelectionBox(Math.min(x, otherX), Math.min(y, otherY), Math.max(x, otherX), Math.max(y, otherY));
    }

    /**
     * The movable bodies in the box.
     *
     * @param middle of a body
     */
    public List<Integer> bodies(Scene scene, FrameInput input, Function<Integer, Vector3> middle) {
        Projection projection = Projection.of(input);
        return BodyEdits.movable(scene).stream()
                .filter(body -> contains(projection.point(middle.apply(body))))
                .toList();
    }

    private boolean contains(double[] pixel) {
        return pixel.length == 2 && pixel[0] >= left && pixel[0] <= right && pixel[1] >= top && pixel[1] <= bottom;
    }
}
