package dev.twister;

import static java.util.Objects.requireNonNull;

import dev.twister.engine.Engine;
import dev.twister.engine.EngineException;
import dev.twister.engine.Engines;
import dev.twister.image.RenderStoppedException;
import dev.twister.engine.UnknownEngineException;
import dev.twister.image.Frame;
import dev.twister.mesh.MeshException;
import dev.twister.scene.Scene;
import dev.twister.scene.SceneException;
import dev.twister.scene.VisibleBodies;
import dev.twister.sky.SkyException;
import dev.twister.world.FrameInput;
import dev.twister.world.SceneImages;
import dev.twister.world.SceneMeshes;
import dev.twister.world.World;

/** Renders single pictures, in the size and quality that the scene's settings give. */
public final class Twister {
    private static final String ENGINE = "parallel";

    private Twister() {}

    /**
     * Renders a scene that was read from a file, on all threads of the JVM.
     *
     * @throws SceneException where a value is out of range
     * @throws SkyException where the sky or a texture cannot be read
     * @throws MeshException where a mesh cannot be read
     */
    public static RenderedPicture render(Scene scene) {
        return render(scene, ENGINE);
    }

    /**
     * Renders a scene that was read from a file.
     *
     * @param engine {@code sequential}, {@code parallel}, {@code vector}, {@code tornado} or one of its devices
     * @throws SceneException where a value is out of range
     * @throws SkyException where the sky or a texture cannot be read
     * @throws MeshException where a mesh cannot be read
     * @throws UnknownEngineException where no engine has that name
     * @throws EngineException where the engine does not work here, or fails
     * @throws RenderStoppedException where the thread is interrupted
     */
    public static RenderedPicture render(Scene scene, String engine) {
        return render(world(scene), engine);
    }

    /**
     * Renders a scene that was read from a file, and tells how far it is. When the listener cancels or the thread is interrupted, the
     * rendering stops within 0.2 s, on a device after its current pass; {@link RenderedPicture#part} tells how much of
     * it was done. An interrupt is not cleared.
     *
     * @param engine as of {@link #render(Scene, String)}
     * @param listener called on this thread
     * @throws SceneException where a value is out of range
     * @throws SkyException where the sky or a texture cannot be read
     * @throws MeshException where a mesh cannot be read
     * @throws UnknownEngineException where no engine has that name
     * @throws EngineException where the engine does not work here, or fails
     */
    public static RenderedPicture render(Scene scene, String engine, RenderListener listener) {
        return render(world(scene), engine, listener);
    }

    private static World world(Scene scene) {
        SceneCheck.check(requireNonNull(scene, "scene"));
        Scene visible = VisibleBodies.of(scene);
        SceneMeshes meshes = SceneMeshes.read(visible, _ -> {});
        return World.of(visible, SceneImages.read(visible, meshes, _ -> {}), meshes);
    }

    /**
     * Renders a scene made in code, on all threads of the JVM.
     *
     * @throws SceneException where a value is out of range
     * @throws SkyException where a texture cannot be read
     * @throws MeshException where a mesh cannot be read
     */
    public static RenderedPicture render(SceneBuilder scene) {
        return render(scene, ENGINE);
    }

    /**
     * Renders a scene made in code.
     *
     * @param engine as of {@link #render(Scene, String)}
     * @throws SceneException where a value is out of range
     * @throws SkyException where a texture cannot be read
     * @throws MeshException where a mesh cannot be read
     * @throws UnknownEngineException where no engine has that name
     * @throws EngineException where the engine does not work here, or fails
     */
    public static RenderedPicture render(SceneBuilder scene, String engine) {
        return render(requireNonNull(scene, "scene").world(), engine);
    }

    /**
     * Renders a scene made in code, and tells how far it is, as {@link #render(World, String, RenderListener)}.
     *
     * @param engine as of {@link #render(Scene, String)}
     * @param listener called on this thread
     * @throws SceneException where a value is out of range
     * @throws SkyException where a texture cannot be read
     * @throws MeshException where a mesh cannot be read
     * @throws UnknownEngineException where no engine has that name
     * @throws EngineException where the engine does not work here, or fails
     */
    public static RenderedPicture render(SceneBuilder scene, String engine, RenderListener listener) {
        return render(requireNonNull(scene, "scene").world(), engine, listener);
    }

    /**
     * Renders a world as it is now.
     *
     * @param engine as of {@link #render(Scene, String)}
     * @throws RenderStoppedException where the thread is interrupted
     * @throws UnknownEngineException where no engine has that name
     * @throws EngineException where the engine does not work here, or fails
     */
    public static RenderedPicture render(World world, String engine) {
        FrameInput input = requireNonNull(world, "world").snapshot();
        Frame frame = Frame.ofPixels(input.width(), input.height());
        try (Engine opened = Engines.open(engine)) {
            opened.render(input, frame);
        }
        return new RenderedPicture(frame, world.settings().srgb());
    }

    /**
     * Renders a world as it is now, and tells how far it is. When the listener cancels or the thread is interrupted, the
     * rendering stops within 0.2 s, on a device after its current pass; {@link RenderedPicture#part} tells how much of
     * it was done. An interrupt is not cleared.
     *
     * @param engine as of {@link #render(Scene, String)}
     * @param listener called on this thread
     * @throws UnknownEngineException where no engine has that name
     * @throws EngineException where the engine does not work here, or fails
     */
    public static RenderedPicture render(World world, String engine, RenderListener listener) {
        FrameInput input = requireNonNull(world, "world").snapshot();
        requireNonNull(listener, "listener");
        try (Engine opened = Engines.open(engine)) {
            return ListenedRendering.render(opened, input, listener, world.settings().srgb());
        }
    }
}
