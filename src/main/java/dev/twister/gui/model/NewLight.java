package dev.twister.gui.model;

import dev.twister.scene.Light;
import dev.twister.scene.Rgb;
import dev.twister.scene.Scene;
import dev.twister.scene.SceneLimits;
import dev.twister.scene.Vector3;
import dev.twister.world.FrameInput;

/** The light that a person inserts: white and small, over what is seen in the middle of the picture. */
public final class NewLight {
    private static final double RADIUS = 0.25;

    /** Over a new sphere, in meters. */
    private static final double HEIGHT = 1.5;

    private NewLight() {}

    /** The light, over the place of a new sphere; below it where the camera is below the plane. */
    public static Light over(FrameInput input, Scene scene) {
        Vector3 place = NewSphere.inFrontOf(input, scene).position();
        boolean above = scene.camera().position().y() >= scene.ground().height();
        Vector3 raised = SceneLimits.POSITION.clamp(place.plus(new Vector3(0, above ? HEIGHT : -HEIGHT, 0)));
        return Light.of(raised, RADIUS, new Rgb(1, 1, 1));
    }
}
