package dev.twister.world;

import dev.twister.scene.Camera;
import dev.twister.scene.Ground;
import dev.twister.scene.Light;
import dev.twister.scene.Rendering;
import dev.twister.scene.Rgb;
import dev.twister.scene.Scene;
import dev.twister.scene.Shading;
import dev.twister.scene.Sky;
import dev.twister.scene.Sphere;
import dev.twister.scene.Vector3;
import dev.twister.scene.light.Lights;
import dev.twister.sky.Skybox;
import java.nio.file.Path;
import java.util.List;

/** A world in which all numbers differ, so that tests detect swapped ones. */
final class Worlds {
    static final Skybox SKY = new Skybox(2, 1, new float[] {70, 71, 72, 73, 74, 75});

    private Worlds() {}

    static Scene scene() {
        return Scene.under(Path.of("none.hdr"))
                .withCamera(Camera.of(new Vector3(1, 2, 3), 0, 0, 90))
                .withLights(Lights.of(Light.of(new Vector3(4, 5, 6), 7, new Rgb(8, 9, 10))))
                .withGround(Ground.of(11, 12, new Rgb(0.13, 0.14, 0.15), new Rgb(0.16, 0.17, 0.18), 19))
                .withSpheres(List.of(
                        Sphere.of(new Vector3(20, 21, 22), 23, new Rgb(0.24, 0.25, 0.26), 27),
                        Sphere.of(new Vector3(28, 29, 30), 31, new Rgb(0.32, 0.33, 0.34), 35)))
                .withSky(new Sky(Path.of("none.hdr"), -90, 37))
                .withShading(new Shading(0.36))
                .withRendering(Rendering.DEFAULT
                        .withSize(40, 30)
                        .withShadowSamples(5)
                        .withBounces(6)
                        .withSamplesPerPixel(3));
    }

    static World world() {
        return World.of(scene(), SKY);
    }
}
