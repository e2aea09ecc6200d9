package dev.twister.gui.picking;

import dev.twister.gui.edit.BodyExtent;
import dev.twister.scene.Material;
import dev.twister.scene.Rgb;
import dev.twister.scene.Scene;
import dev.twister.scene.Sphere;
import dev.twister.scene.Vector3;
import dev.twister.world.FrameInput;
import dev.twister.world.SceneMeshes;

/** The sphere that the user inserts, see {@link FreePlace}. */
public final class NewSphere {
    static final double RADIUS = 1.5;
    private static final double REFLECTIVITY = 32;

    /** Turns of the hue from one body to the next, so that neighbors differ. */
    private static final double GOLDEN_RATIO = 0.6180339887;

    private NewSphere() {}

    /** See {@link FreePlace#of}. */
    public static Sphere inFrontOf(FrameInput input, Scene scene, SceneMeshes meshes) {
        Vector3 place = FreePlace.of(input, scene, meshes, BodyExtent.ball(Vector3.ZERO, RADIUS));
        return Sphere.of(place, RADIUS, material(scene));
    }

    /** That of the next body. */
    static Material material(Scene scene) {
        double hue = (scene.spheres().size() + scene.meshes().size()) * GOLDEN_RATIO;
        Rgb color = new Rgb(channel(hue), channel(hue + 1.0 / 3), channel(hue + 2.0 / 3));
        return Material.DEFAULT.withColor(color).withReflectivity(REFLECTIVITY);
    }

    private static double channel(double turns) {
        return 0.5 + 0.4 * Math.cos(2 * Math.PI * turns);
    }
}
