package dev.twister.gui.drawing;

import dev.twister.gui.drawing.DrawingRequest.Motion;
import dev.twister.physics.Simulation;
import dev.twister.scene.Geometry;
import dev.twister.scene.Mesh;
import dev.twister.scene.Scene;
import dev.twister.scene.format.TexturePlaces;
import dev.twister.sky.SkyException;
import dev.twister.sky.Skybox;
import dev.twister.sky.TextureImage;
import dev.twister.sky.TextureReader;
import dev.twister.world.FrameInput;
import dev.twister.world.SceneImages;
import dev.twister.world.SceneMeshes;
import dev.twister.world.World;
import java.nio.file.Path;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.function.Supplier;
import java.util.stream.Collectors;

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

    /** The meshes of the last snapshot, if its scene has any, as they are there in their animations. */
    SceneMeshes meshes() {
        return world.map(World::meshes).orElse(SceneMeshes.NONE);
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

    /**
     * Moves a scene's bodies by the time between pictures. After an edit they go on as {@link Simulation#goOnIn} says.
     * Used only by the drawing thread.
     */
    private static final class MovingBodies implements AutoCloseable {
        private static final double NANOS_PER_SECOND = 1e9;

        /**
         * If a picture takes longer, bodies move more slowly; otherwise the steps to compute would grow without end.
         */
        private static final double LONGEST_SECONDS = 0.1;

        private Optional<Simulation> simulation = Optional.empty();
        private Optional<Scene> seen = Optional.empty();
        private long start = Motion.NONE.start();
        private long steps;
        private long lastNanos;
        private boolean wasRunning;

        /** Simulates the time that has passed, and updates the places of the world's bodies. */
        void place(Scene wanted, Motion motion, World world, long nanos) {
            if (!motion.isOn()) {
                close();
                return;
            }
            Scene scene = world.meshes().shown(wanted);
            boolean moved = !world.isMoved();
            if (start != motion.start()) {
                simulation.ifPresent(Simulation::close);
                simulation = Optional.of(Simulation.of(scene, world.meshes()));
                moved = true;
                start = motion.start();
                steps = 0;
                wasRunning = false;
            } else if (!seen.equals(Optional.of(scene))) {
                simulation = simulation.map(old -> old.goOnIn(scene, world.meshes()));
                moved = true;
            }
            seen = Optional.of(scene);
            Simulation now = simulation.orElseThrow();
            if (motion.running() && wasRunning) {
                now.advance(Math.clamp((nanos - lastNanos) / NANOS_PER_SECOND, 0, LONGEST_SECONDS));
                moved = true;
            }
            for (; steps < motion.steps(); steps++) {
                now.stepOnce();
                moved = true;
            }
            lastNanos = nanos;
            wasRunning = motion.running();
            if (moved) {
                now.place(world);
            }
        }

        /** Ends the motion. */
        @Override
        public void close() {
            simulation.ifPresent(Simulation::close);
            simulation = Optional.empty();
            seen = Optional.empty();
            start = Motion.NONE.start();
        }
    }

    /** The textures of the scene that is drawn. Used only by the drawing thread. */
    static final class CurrentTextures {
        private final ImageCache images;
        private final Supplier<Optional<Scene>> newest;
        private final Map<Path, String> complaints = new TreeMap<>();
        private Map<Path, TextureImage> held = Map.of();
        private long edition;

        /** @param newest the scene of the newest request; empty if there is none */
        CurrentTextures(ImageCache images, Supplier<Optional<Scene>> newest) {
            this.images = images;
            this.newest = newest;
        }

        /** Whether files may have changed since {@link #of} was called. */
        boolean areOld() {
            return edition != images.texturesEdition();
        }

        /** The textures of a scene and its meshes by their files; white if a file cannot be read. */
        Map<Path, TextureImage> of(Scene scene, SceneMeshes meshes) {
            if (areOld()) {
                edition = images.texturesEdition();
                held = Map.of();
            }
            Map<Path, TextureImage> before = held;
            held = SceneImages.textures(
                    scene,
                    meshes,
                    file -> Optional.ofNullable(before.get(file)).orElseGet(() -> read(file, scene, meshes)),
                    images::warn);
            complaints.keySet().retainAll(held.keySet());
            return held;
        }

        /** Why textures are not shown. */
        Optional<String> complaint() {
            return Optional.of(String.join("; ", complaints.values())).filter(all -> !all.isEmpty());
        }

        private TextureImage read(Path file, Scene scene, SceneMeshes meshes) {
            complaints.remove(file);
            try {
                return meshes.embeddedImage(file)
                        .map(bytes -> TextureReader.read(file, bytes, images::warn))
                        .orElseGet(() -> images.texture(file, () -> isWanted(file, scene)));
            } catch (SkyException problem) {
                complaints.put(file, problem.getMessage());
            } catch (OutOfMemoryError _) {
                complaints.put(file, file + ": there is not enough memory for this texture");
            }
            return SceneImages.WHITE;
        }

        /** Whether the newest scene, or one of its meshes that have stayed the same, uses the texture. */
        private boolean isWanted(Path file, Scene scene) {
            return newest.get()
                    .filter(now -> TexturePlaces.of(scene).containsKey(file)
                            ? TexturePlaces.of(now).containsKey(file)
                            : meshFiles(now).containsAll(meshFiles(scene)))
                    .isPresent();
        }

        private static Set<Geometry> meshFiles(Scene scene) {
            return scene.meshes().stream().map(Mesh::geometry).collect(Collectors.toSet());
        }
    }
}
