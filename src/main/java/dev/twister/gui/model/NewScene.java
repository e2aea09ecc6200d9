package dev.twister.gui.model;

import dev.twister.scene.Camera;
import dev.twister.scene.Ground;
import dev.twister.scene.Integrator;
import dev.twister.scene.Light;
import dev.twister.scene.Rendering;
import dev.twister.scene.Rgb;
import dev.twister.scene.Scene;
import dev.twister.scene.ToneMap;
import dev.twister.scene.Vector3;
import dev.twister.scene.light.Lights;
import java.nio.file.Path;

/** The scene that a person starts from: a floor, a sky and a light, path traced. */
public final class NewScene {
    /** Its file until it is saved for the first time. */
    public static final String FILE_NAME = "untitled.json";

    private static final double FLOOR_METERS = 20;
    private static final Camera CAMERA = Camera.of(new Vector3(0, 2, -7), 0, 10, 50);
    private static final Light LIGHT = Light.of(new Vector3(-3, 6, -4), 0.5, new Rgb(1, 0.95, 0.85));
    private static final Rgb BRIGHT = new Rgb(0.7, 0.7, 0.7);
    private static final Rgb DARK = new Rgb(0.4, 0.4, 0.4);
    private static final int SHADOW_SAMPLES = 16;

    private NewScene() {}

    /**
     * The scene under a sky.
     *
     * @param sky a panorama's file
     */
    public static Scene of(Path sky) {
        Rendering rendering = Rendering.DEFAULT;
        return Scene.under(sky)
                .withCamera(CAMERA)
                .withGround(Ground.of(FLOOR_METERS, 0, BRIGHT, DARK, 0))
                .withLights(Lights.of(LIGHT))
                .withRendering(rendering
                        .withIntegrator(Integrator.PATH)
                        .withShadowSamples(SHADOW_SAMPLES)
                        .withTone(rendering.exposure(), ToneMap.ACES, rendering.srgb()));
    }
}
