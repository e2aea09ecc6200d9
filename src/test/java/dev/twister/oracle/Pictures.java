package dev.twister.oracle;

import dev.twister.engine.Engine;
import dev.twister.engine.Engines;
import dev.twister.image.Frame;
import dev.twister.scene.Scene;
import dev.twister.sky.Skybox;
import dev.twister.world.FrameInput;
import dev.twister.world.World;
import java.util.Arrays;

/** Renders whole pictures of scenes with an engine by name. */
public final class Pictures {
    /** Transparent, so no rendered pixel equals it and unwritten pixels show. */
    private static final int POISON = 0x00BADBAD;

    private Pictures() {}

    public static int[] argb(String engine, Scene scene, Skybox sky) {
        return argb(engine, World.of(scene, sky).snapshot());
    }

    /** Renders a scene with textures. */
    public static int[] argb(String engine, LitScene scene) {
        return argb(engine, scene.world().snapshot());
    }

    /** Renders the band as 0xAARRGGBB pixels. */
    public static int[] argb(String engine, FrameInput input) {
        Frame frame = Frame.ofPixels(input.width(), input.rows());
        Arrays.fill(frame.argb(), POISON);
        try (Engine opened = Engines.open(engine)) {
            opened.render(input, frame);
        }
        return frame.argb();
    }

    /** Renders linear radiance, three floats per pixel. */
    public static float[] radiance(String engine, Scene scene, Skybox sky) {
        return radiance(engine, new LitScene(scene, sky));
    }

    /** Renders linear radiance of a scene with textures. */
    public static float[] radiance(String engine, LitScene scene) {
        return radiance(engine, scene.world().snapshot());
    }

    /** Renders the band's linear radiance. */
    public static float[] radiance(String engine, FrameInput input) {
        return linear(engine, input).radiance();
    }

    /** Renders the band's linear radiance and layers. */
    public static Frame linear(String engine, FrameInput input) {
        Frame frame = Frame.ofRadiance(input.width(), input.rows(), input.layers());
        Arrays.fill(frame.radiance(), Float.NaN);
        Arrays.fill(frame.layers(), Float.NaN);
        try (Engine opened = Engines.open(engine)) {
            opened.render(input, frame);
        }
        return frame;
    }
}
