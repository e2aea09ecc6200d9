package dev.twister.gui.model;

import dev.twister.kernel.Layout;
import dev.twister.scene.property.SceneLimits;
import dev.twister.world.FrameInput;

/** What a lens is to be focused on. */
public final class FocusPoint {
    private FocusPoint() {}

    /**
     * The focus distance at which a place on the picture is sharp: along the camera's forward axis, in meters, within
     * what a scene may have; for the sky the largest.
     *
     * @param x in pixels of the picture from its left border
     * @param y in pixels from its upper border
     */
    public static double distance(FrameInput input, double x, double y) {
        PointerRay ray = PointerRay.through(input, x, y);
        if (ray.body() == Layout.NOTHING) {
            return SceneLimits.FOCUS_DISTANCE.max();
        }
        float[] camera = input.view().frame();
        double cosine = 0;
        for (int axis = 0; axis < 3; axis++) {
            cosine += ray.direction(axis) * camera[Layout.CAMERA_FORWARD + axis];
        }
        return SceneLimits.FOCUS_DISTANCE.clamp(ray.distance() * cosine);
    }
}
