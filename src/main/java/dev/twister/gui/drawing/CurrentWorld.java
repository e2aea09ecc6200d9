package dev.twister.gui.drawing;

import dev.twister.gui.drawing.DrawingRequest.Motion;
import dev.twister.scene.Scene;
import dev.twister.sky.SkyException;
import dev.twister.sky.Skybox;
import dev.twister.world.FrameInput;
import dev.twister.world.SceneImages;
import dev.twister.world.SceneMeshes;
import dev.twister.world.World;
import java.nio.file.Path;
import java.util.Optional;
import java.util.function.Supplier;

/**
 * The world of the scene that is being drawn. What does not change from one snapshot to the next stays the same array,
 * so that an engine need not send it to its device again. Used by the drawing thread alone.
 */
final class CurrentWorld implements AutoCloseable {
    private static final float GRAY = 0.5f;

    private final ImageCache skies;
    private final Supplier<Optional<Scene>> newest;
    private final CurrentTextures textures;
    private final MeshCache meshes;
    private final MovingBodies moving = new MovingBodies();
    private Motion motion = Motion.NONE;
    private Optional<Scene> scene = Optional.empty();
    private Optional<World> world = Optional.empty();
    private Skybox sky = new Skybox(1, 1, new float[] {GRAY, GRAY, GRAY});
    private Optional<Path> skyFile = Optional.empty();
    private long skyEdition;
    private SceneMeshes shownMeshes = SceneMeshes.NONE;
    private Optional<String> complaint = Optional.empty();

    /**
     * A world of nothing.
     *
     * @param newest the scene requested meanwhile; empty if none was
     */
    CurrentWorld(ImageCache skies, MeshCache meshes, Supplier<Optional<Scene>> newest) {
        this.skies = skies;
        this.meshes = meshes;
        this.newest = newest;
        textures = new CurrentTextures(skies, newest);
    }

    /**
     * A snapshot of the scene that is asked for, at the size that is.
     *
     * @param nanos now, by {@link System#nanoTime}
     */
    FrameInput snapshot(DrawingRequest request, long nanos) {
        Scene wanted = request.scene();
        SceneMeshes atHand = meshes.of(wanted, request.document());
        Scene shown =
                atHand.shown(wanted).withRendering(wanted.rendering().withSize(request.width(), request.height()));
        SceneImages images = images(shown, atHand);
        World now =
                world.filter(before -> before.isNear(wanted.camera())).orElseGet(() -> World.of(shown, images, atHand));
        now.show(shown, images, atHand);
        if (motion.isOn() && !request.motion().isOn()) {
            now.resetBodies();
        }
        motion = request.motion();
        shownMeshes = atHand;
        moving.place(wanted, motion, now, nanos);
        scene = Optional.of(wanted);
        world = Optional.of(now);
        return now.snapshot();
    }

    /** Images for a scene that has only the meshes that are at hand. */
    private SceneImages images(Scene shown, SceneMeshes atHand) {
        boolean sameFiles = !chooseSky(shown.sky().file()) && !textures.areOld() && atHand.equals(shownMeshes);
        return world.filter(before -> sameFiles && before.hasSurfacesOf(shown))
                .map(World::images)
                .orElseGet(() -> new SceneImages(sky, textures.of(shown, atHand)));
    }

    /** The meshes of the last snapshot, if its scene has any. */
    SceneMeshes meshes() {
        return shownMeshes;
    }

    /** Why the scene's sky, a mesh or a texture is not shown, if one is not. */
    Optional<String> complaint() {
        return complaint.or(() -> scene.flatMap(meshes::complaint)).or(textures::complaint);
    }

    /** Lets go of what moves the bodies. */
    @Override
    public void close() {
        moving.close();
    }

    /** Reads the sky's file; if that fails, the previous sky stays. Returns whether the sky has changed. */
    private boolean chooseSky(Path file) {
        long edition = skies.edition(file);
        if (edition == skyEdition && skyFile.filter(file::equals).isPresent()) {
            return false;
        }
        skyFile = Optional.of(file);
        skyEdition = edition;
        try {
            sky = skies.find(
                    file,
                    () -> newest.get()
                            .filter(now -> now.sky().file().equals(file))
                            .isPresent());
            complaint = Optional.empty();
            return true;
        } catch (SkyException problem) {
            complaint = Optional.of(problem.getMessage());
        } catch (OutOfMemoryError _) {
            complaint = Optional.of(file + ": there is not enough memory for this sky");
        }
        return false;
    }
}
