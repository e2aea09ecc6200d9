package dev.twister.gui.picking;

import dev.twister.gui.edit.BodyExtent;
import dev.twister.scene.Light;
import dev.twister.scene.Rgb;
import dev.twister.scene.Scene;
import dev.twister.scene.Vector3;
import dev.twister.world.FrameInput;
import dev.twister.world.SceneMeshes;

/** The light that a person inserts: white and small, over what is seen in the middle of the picture. */
public final class NewLight {
    private static final double RADIUS = 0.25;

    /** Over the ground, in meters: above a new body that stands there. */
    private static final double HEIGHT = 3.25;

    private NewLight() {}

    /** The light; below the ground where the camera is. See {@link FreePlace#of}. */
    public static Light over(FrameInput input, Scene scene, SceneMeshes meshes) {
        Vector3 raised = new Vector3(0, HEIGHT, 0);
        return Light.of(FreePlace.of(input, scene, meshes, BodyExtent.ball(raised, RADIUS)), RADIUS, new Rgb(1, 1, 1));
    }
}
