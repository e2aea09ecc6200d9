package dev.twister.gui.drawing;

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
final class LivingWorld implements AutoCloseable {
    private static final float GRAY = 0.5f;

    private final SkyShelf skies;
    private final Supplier<Optional<Scene>> newest;
    private final LivingTextures textures;
    private final MeshShelf meshes;
    private final MovingBodies moving = new MovingBodies();
    private Motion motion = Motion.NONE;
    private Optional<Scene> scene = Optional.empty();
    private Optional<World> world = Optional.empty();
    private Optional<FrameInput> last = Optional.empty();
    private Skybox sky = new Skybox(1, 1, new float[] {GRAY, GRAY, GRAY});
    private Optional<Path> skyFile = Optional.empty();
    private long skyEdition;
    private SceneMeshes shownMeshes = SceneMeshes.NONE;
    private Optional<String> complaint = Optional.empty();

    /**
     * A world of nothing.
     *
     * @param newest the scene that is asked for by now; empty where none is
     */
    LivingWorld(SkyShelf skies, MeshShelf meshes, Supplier<Optional<Scene>> newest) {
        this.skies = skies;
        this.meshes = meshes;
        this.newest = newest;
        textures = new LivingTextures(skies, newest);
    }

    /**
     * A snapshot of the scene that is asked for, at the size that is.
     *
     * @param nanos now, by {@link System#nanoTime}
     */
    FrameInput snapshot(DrawingRequest request, long nanos) {
        Scene wanted = request.scene();
        Motion wantedMotion = request.motion();
        SceneMeshes atHand = meshes.of(wanted, request.document());
        boolean sameImages = !chooseSky(wanted.sky().file()) && !textures.areOld() && atHand.equals(shownMeshes);
        shownMeshes = atHand;
        // A world whose bodies have moved is not one in which they stand.
        boolean sameKind = motion.isOn() == wantedMotion.isOn();
        motion = wantedMotion;
        World now = world.filter(before -> sameImages
                        && sameKind
                        && before.isNear(wanted.camera())
                        && scene.filter(old -> hasSameBodies(old, wanted)).isPresent())
                .orElseGet(() -> world(wanted));
        now.setCamera(wanted.camera());
        now.setSettings(wanted.rendering().withSize(request.width(), request.height()));
        moving.place(wanted, wantedMotion, now, nanos);
        scene = Optional.of(wanted);
        world = Optional.of(now);
        FrameInput fresh = now.snapshot();
        FrameInput snapshot = last.map(fresh::withLooksOf).orElse(fresh);
        last = Optional.of(snapshot);
        return snapshot;
    }

    /** The scene's world, without the meshes that are not at hand. */
    private World world(Scene wanted) {
        Scene shown = shownMeshes.shown(wanted);
        return World.of(shown, new SceneImages(sky, textures.of(shown, shownMeshes)), shownMeshes);
    }

    /** The meshes that the last snapshot shows, where its scene has them. */
    SceneMeshes meshes() {
        return shownMeshes;
    }

    /** Why the scene's own sky, a mesh or a texture is not seen, where it is not. */
    Optional<String> complaint() {
        return complaint.or(() -> scene.flatMap(meshes::complaint)).or(textures::complaint);
    }

    /** Lets go of what moves the bodies. */
    @Override
    public void close() {
        moving.close();
    }

    private static boolean hasSameBodies(Scene one, Scene other) {
        return one.spheres().equals(other.spheres())
                && one.meshes().equals(other.meshes())
                && one.lights().first().equals(other.lights().first())
                && one.ground().equals(other.ground())
                && one.sky().file().equals(other.sky().file())
                && one.sky().rotationDegrees() == other.sky().rotationDegrees()
                && one.sky().strength() == other.sky().strength()
                && one.pour().equals(other.pour())
                && one.shading().ambient() == other.shading().ambient();
    }

    /** Takes the sky of that file; where it cannot be read, the one before it stays. Whether it is another one now. */
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
