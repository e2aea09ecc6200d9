package dev.twister.gui.studio;

import dev.twister.engine.EngineOffer;
import dev.twister.gui.drawing.DrawingLoop;
import dev.twister.gui.drawing.ImageCache;
import dev.twister.gui.drawing.MeshCache;
import dev.twister.mesh.MeshFile;
import dev.twister.scene.Mesh;
import dev.twister.scene.Scene;
import dev.twister.world.SceneMeshes;
import dev.twister.world.World;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** The panoramas, textures and meshes of scenes, shared by all drawing threads. Any thread may read. */
public final class SceneAssets {
    private final EngineOffer substitute;
    private final ImageCache skies = new ImageCache();
    private final MeshCache meshes = new MeshCache(SceneMeshes.reader(skies::warn));

    /** Used only by JavaFX's thread. */
    private long meshesEdition;

    /** @param substitute of drawing loops */
    SceneAssets(EngineOffer substitute) {
        this.substitute = substitute;
    }

    /** A drawing loop, not started yet, that uses these files. */
    public DrawingLoop drawingLoop() {
        return new DrawingLoop(skies, meshes, substitute);
    }

    /**
     * Reads a scene, its sky and its textures.
     *
     * @throws dev.twister.scene.SceneException if it is not a scene
     * @throws dev.twister.sky.SkyException if its sky or a texture cannot be read
     */
    public OpenedScene readScene(Path file) {
        OpenedScene read = OpenedScene.read(file);
        skies.refresh(read.scene());
        return read;
    }

    /**
     * Reads a scene and its textures, and its sky if that can be read.
     *
     * @throws dev.twister.scene.SceneException if it is not a scene
     * @throws dev.twister.sky.SkyException if a texture cannot be read
     */
    public ReadScene readWithOrWithoutSky(Path file) {
        List<RuntimeException> missing = new ArrayList<>();
        OpenedScene read = OpenedScene.read(file, missing::add);
        skies.refreshTextures(read.scene());
        return new ReadScene(
                read,
                missing.stream()
                        .findFirst()
                        .or(() -> skies.problemOf(read.scene().sky().file())));
    }

    /**
     * A scene that was read.
     *
     * @param skyProblem why its sky cannot be used
     */
    public record ReadScene(OpenedScene opened, Optional<RuntimeException> skyProblem) {}

    /**
     * Reads a panorama, unless it has been read.
     *
     * @throws dev.twister.sky.SkyException if it cannot be read
     */
    public void readSky(Path panorama) {
        skies.refresh(panorama);
    }

    /**
     * Reads a texture that the scene does not use yet.
     *
     * @throws dev.twister.sky.SkyException if it cannot be read
     */
    public void readTexture(Scene textured, Path file) {
        skies.refreshTexture(textured, file);
    }

    /**
     * Reads the file of a mesh.
     *
     * @throws dev.twister.mesh.MeshException if it cannot be read
     */
    public MeshFile readMesh(Mesh mesh) {
        return SceneMeshes.reader(skies::warn).apply(SceneMeshes.Source.of(mesh));
    }

    /** Caches a mesh file that was read for the next scene or edit. */
    public void keepMesh(Mesh mesh, MeshFile file) {
        meshes.keep(mesh, file);
    }

    /** The world of a scene; reads the meshes that are not in {@code atHand}. */
    public World world(Scene wanted, SceneMeshes atHand) {
        SceneMeshes all = atHand.changedTo(wanted.meshes(), SceneMeshes.reader(skies::warn));
        return World.of(wanted, skies.images(wanted, all), all);
    }

    /** The panorama or texture that a drawing thread waits for, or the meshes that are being read. */
    public Optional<String> beingRead() {
        return skies.beingRead().map(file -> String.valueOf(file.getFileName())).or(meshes::progress);
    }

    /** Cancels reading the file that {@link #beingRead} names; rendering continues without it. */
    public void cancelReading() {
        skies.cancel();
        meshes.cancel();
    }

    /** Warnings about files since the last call. */
    Optional<String> takeWarnings() {
        return Optional.of(skies.takeWarnings()).filter(warnings -> !warnings.isEmpty());
    }

    /** Whether meshes were read since the last call. */
    boolean takeMeshesRead() {
        long before = meshesEdition;
        meshesEdition = meshes.edition();
        return meshesEdition != before;
    }
}
