package dev.twister.oracle;

import dev.twister.engine.Engine;
import dev.twister.engine.Engines;
import dev.twister.image.Frame;
import dev.twister.scene.Scene;
import dev.twister.sky.Skybox;
import dev.twister.world.FrameInput;
import dev.twister.world.World;
import java.util.Arrays;

/** Whole pictures of scenes, by the name of an engine. */
public final class Pictures {
    /** No pixel is this transparent one: what an engine does not write shows. */
    private static final int POISON = 0x00BADBAD;

    private Pictures() {}

    public static int[] argb(String engine, Scene scene, Skybox sky) {
        return argb(engine, World.of(scene, sky).snapshot());
    }

    /** The same of a scene with textures. */
    public static int[] argb(String engine, LitScene scene) {
        return argb(engine, scene.world().snapshot());
    }

    /** The band's pixels as 0xAARRGGBB. */
    public static int[] argb(String engine, FrameInput input) {
        Frame frame = Frame.ofPixels(input.width(), input.rows());
        Arrays.fill(frame.argb(), POISON);
        try (Engine opened = Engines.open(engine)) {
            opened.render(input, frame);
        }
        return frame.argb();
    }

    /** Linear radiance, three floats a pixel. */
    public static float[] radiance(String engine, Scene scene, Skybox sky) {
        return radiance(engine, new LitScene(scene, sky));
    }

    /** The same of a scene with textures. */
    public static float[] radiance(String engine, LitScene scene) {
        return radiance(engine, scene.world().snapshot());
    }

    /** The band's linear radiance. */
    public static float[] radiance(String engine, FrameInput input) {
        Frame frame = Frame.ofRadiance(input.width(), input.rows());
        Arrays.fill(frame.radiance(), Float.NaN);
        try (Engine opened = Engines.open(engine)) {
            opened.render(input, frame);
        }
        return frame.radiance();
    }
}
