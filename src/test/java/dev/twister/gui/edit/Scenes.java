package dev.twister.gui.edit;

import dev.twister.scene.Camera;
import dev.twister.scene.Ground;
import dev.twister.scene.Light;
import dev.twister.scene.Rendering;
import dev.twister.scene.Rgb;
import dev.twister.scene.Scene;
import dev.twister.scene.Shading;
import dev.twister.scene.Sphere;
import dev.twister.scene.Vector3;
import dev.twister.scene.light.Lights;
import dev.twister.sky.Skybox;
import dev.twister.world.FrameInput;
import dev.twister.world.World;
import java.nio.file.Path;
import java.util.List;

/** A small scene whose bodies are where a test expects them: the camera looks along z from (0, 2, -10). */
public final class Scenes {
    public static final int WIDTH = 96;
    public static final int HEIGHT = 64;
    public static final Skybox SKY = new Skybox(2, 1, new float[] {0.1f, 0.3f, 0.9f, 1.4f, 0.3f, 0.1f});

    private Scenes() {}

    /** A large sphere in the middle, a small one to the right, the light above to the left, the plane below. */
    public static Scene scene() {
        return Scene.under(Path.of("none.hdr"))
                .withCamera(Camera.of(new Vector3(0, 2, -10), 0, 0, 60))
                .withLights(Lights.of(Light.of(new Vector3(-4, 6, 0), 0.5, new Rgb(2, 1, 1))))
                .withGround(Ground.of(40, 0, new Rgb(0.4, 0.4, 0.4), new Rgb(0.2, 0.2, 0.2), 32))
                .withSpheres(List.of(
                        Sphere.of(new Vector3(0, 2, 0), 1.5, new Rgb(0.9, 0.2, 0.1), 60),
                        Sphere.of(new Vector3(4, 2, 2), 0.5, new Rgb(0.1, 0.9, 0.2), 0)))
                .withShading(new Shading(0.2))
                .withRendering(Rendering.DEFAULT
                        .withSize(WIDTH, HEIGHT)
                        .withShadowSamples(8)
                        .withBounces(2));
    }

    public static FrameInput input(Scene scene) {
        return World.of(scene, SKY).snapshot();
    }
}
