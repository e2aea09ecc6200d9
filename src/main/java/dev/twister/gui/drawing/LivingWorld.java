package dev.twister.gui.drawing;

import dev.twister.scene.RenderSettings;
import dev.twister.scene.Scene;
import dev.twister.sky.SkyException;
import dev.twister.sky.Skybox;
import dev.twister.world.FrameInput;
import dev.twister.world.World;
import java.nio.file.Path;
import java.util.Optional;

/**
 * The world of the scene that is being drawn. Where only the camera or the settings change it stays the same world, so that its
 * arrays stay the same and an engine need not send them to its device again. Used by the drawing thread alone.
 */
final class LivingWorld {
    private final SkyShelf skies;
    private Optional<Scene> scene = Optional.empty();
    private Optional<World> world = Optional.empty();
    private Optional<Skybox> sky = Optional.empty();
    private Optional<String> complaint = Optional.empty();

    LivingWorld(SkyShelf skies) {
        this.skies = skies;
    }

    /** A snapshot of what the request asks for. */
    FrameInput snapshot(DrawingRequest request) {
        Scene wanted = request.scene();
        World now = world.filter(
                        _ -> scene.filter(old -> sameBodies(old, wanted)).isPresent())
                .orElseGet(() -> World.of(wanted, skyOf(wanted.skybox())));
        RenderSettings settings = wanted.settings().withSize(request.width(), request.height());
        now.setCamera(wanted.camera());
        now.setSettings(settings);
        scene = Optional.of(wanted);
        world = Optional.of(now);
        return now.snapshot();
    }

    /** Why the scene's own sky is not seen, where it is not. */
    Optional<String> complaint() {
        return complaint;
    }

    private static boolean sameBodies(Scene one, Scene other) {
        return one.spheres().equals(other.spheres())
                && one.light().equals(other.light())
                && one.plane().equals(other.plane())
                && one.skybox().equals(other.skybox())
                && one.ambient() == other.ambient();
    }

    /** The sky of that file; where it cannot be read, the one before it, or else a grey one. */
    private Skybox skyOf(Path file) {
        try {
            Skybox read = skies.find(file);
            sky = Optional.of(read);
            complaint = Optional.empty();
            return read;
        } catch (SkyException problem) {
            complaint = Optional.of(problem.getMessage());
            return sky.orElseGet(() -> new Skybox(1, 1, new float[] {0.5f, 0.5f, 0.5f}));
        }
    }
}
