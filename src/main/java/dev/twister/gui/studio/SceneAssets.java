package dev.twister.gui.studio;

import dev.twister.engine.JvmEngines;
import dev.twister.gui.drawing.DrawingLoop;
import dev.twister.gui.drawing.MeshShelf;
import dev.twister.gui.drawing.SkyShelf;
import dev.twister.mesh.MeshFile;
import dev.twister.scene.Mesh;
import dev.twister.scene.Scene;
import dev.twister.world.SceneMeshes;
import dev.twister.world.World;
import java.nio.file.Path;
import java.util.Optional;

/**
 * The panoramas, textures and meshes that scenes name, which drawing threads find here once they are read. Any thread
 * may read.
 */
public final class SceneAssets {
    private final SkyShelf skies = new SkyShelf();
    private final MeshShelf meshes = new MeshShelf(SceneMeshes.reader(skies::warn));

    /** Used by JavaFX's thread. */
    private long meshesEdition;

    /** A drawing thread, not started yet, that has these files at hand. */
    public DrawingLoop drawingLoop() {
        return new DrawingLoop(skies, meshes, JvmEngines.parallel());
    }

    /**
     * Reads a scene, its sky and its textures.
     *
     * @throws dev.twister.scene.SceneException where it is not a scene
     * @throws dev.twister.sky.SkyException where its sky or a texture cannot be read
     */
    public OpenedScene readScene(Path file) {
        OpenedScene read = OpenedScene.read(file);
        skies.refresh(read.scene());
        return read;
    }

    /**
     * Reads a panorama.
     *
     * @throws dev.twister.sky.SkyException where it cannot be read
     */
    public void readSky(Path panorama) {
        skies.refresh(panorama);
    }

    /**
     * Reads a scene's textures.
     *
     * @throws dev.twister.sky.SkyException where one cannot be read
     */
    public void readTextures(Scene textured) {
        skies.refreshTextures(textured);
    }

    /**
     * Reads a texture that a scene does not have yet.
     *
     * @throws dev.twister.sky.SkyException where it cannot be read
     */
    public void readTexture(Scene textured, Path file) {
        skies.refreshTexture(textured, file);
    }

    /**
     * Reads a mesh's file.
     *
     * @throws dev.twister.mesh.MeshException where it is not a mesh that can be read
     */
    public MeshFile readMesh(Mesh mesh) {
        return SceneMeshes.reader(skies::warn).apply(SceneMeshes.Source.of(mesh));
    }

    /** Keeps a mesh's file that was read for a scene that is shown next, or is edited to have it. */
    public void keepMesh(Mesh mesh, MeshFile file) {
        meshes.keep(mesh, file);
    }

    /** A scene's world, of what is at hand; the rest is read. */
    public World world(Scene wanted, SceneMeshes atHand) {
        SceneMeshes all = atHand.changedTo(wanted.meshes(), SceneMeshes.reader(skies::warn));
        return World.of(wanted, skies.images(wanted, all), all);
    }

    /**
     * The panorama or texture that a drawing thread waits for, or the meshes that it draws without until they are read.
     */
    public Optional<String> beingRead() {
        return skies.beingRead().map(file -> String.valueOf(file.getFileName())).or(meshes::progress);
    }

    /** Stops reading what {@link #beingRead} names: drawing threads draw without it. */
    public void cancelReading() {
        skies.cancel();
        meshes.cancel();
    }

    /** What was found wrong with files since this was asked last. */
    Optional<String> takeWarnings() {
        return Optional.of(skies.takeWarnings()).filter(warnings -> !warnings.isEmpty());
    }

    /** Whether meshes were read since this was asked last, so that a new picture shows them. */
    boolean takeMeshesRead() {
        long before = meshesEdition;
        meshesEdition = meshes.edition();
        return meshesEdition != before;
    }
}
