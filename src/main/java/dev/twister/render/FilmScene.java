package dev.twister.render;

import dev.twister.scene.Camera;
import dev.twister.scene.Scene;
import dev.twister.world.FrameInput;
import dev.twister.world.World;
import java.io.IOException;
import java.util.function.DoubleFunction;

/**
 * A scene in the course of a film.
 *
 * @param world the scene's
 * @param camera at a time, in seconds
 * @param rate frames a second
 */
public record FilmScene(Scene scene, World world, FilmBodies bodies, DoubleFunction<Camera> camera, double rate) {
    /**
     * A frame, whatever frames were before it.
     *
     * @throws IOException where the bodies' places cannot be read
     */
    public FrameInput frame(int number) throws IOException {
        Camera seen = camera.apply(number / rate);
        World near = world;
        if (!world.isNear(seen)) {
            near = World.of(scene.withCamera(seen), world.images(), world.meshes());
            near.setSettings(world.settings());
        }
        near.setCamera(seen);
        bodies.place(near, number);
        return near.snapshot();
    }
}
