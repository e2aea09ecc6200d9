package dev.twister.gui.picking;

import dev.twister.kernel.Layout;
import dev.twister.world.FrameInput;

/** Finds the body under the pointer, by the same code that draws it. */
public final class BodyPicker {
    private BodyPicker() {}

    /**
     * The body that is seen there: {@link Layout#LIGHT}, {@link Layout#PLANE}, a sphere's index from
     * {@link Layout#FIRST_SPHERE} on, or {@link Layout#NOTHING} for the sky.
     *
     * @param x in pixels of the picture from its left border
     * @param y in pixels from its upper border
     */
    public static int bodyAt(FrameInput input, double x, double y) {
        return PointerRay.through(input, x, y).body();
    }
}
