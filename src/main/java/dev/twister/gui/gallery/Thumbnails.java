package dev.twister.gui.gallery;

import dev.twister.engine.Engine;
import dev.twister.engine.JvmEngines;
import dev.twister.files.UserFolder;
import dev.twister.image.Frame;
import dev.twister.image.PngWriter;
import dev.twister.scene.Scene;
import dev.twister.scene.format.SceneReader;
import dev.twister.scene.select.VisibleBodies;
import dev.twister.world.FrameInput;
import dev.twister.world.SceneImages;
import dev.twister.world.SceneMeshes;
import dev.twister.world.World;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import java.util.UUID;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.function.Consumer;
import javafx.application.Platform;
import javafx.scene.image.Image;

/**
 * Small pictures of scene files, rendered one after the other on a thread of their own and kept in the user's cache
 * until the scene's file changes.
 */
final class Thumbnails implements AutoCloseable {
    static final int WIDTH = 224;
    static final int HEIGHT = 126;

    private static final int TRACED_SAMPLES = 32;
    private static final int SAMPLES = 16;
    private static final int SHADOW_SAMPLES = 4;

    private final Optional<Path> folder;
    private final ExecutorService thread = Executors.newSingleThreadExecutor(
            Thread.ofPlatform().daemon().name("thumbnails").factory());
    private volatile boolean closed;

    /** @param folder need not exist; without one nothing is kept */
    Thumbnails(Optional<Path> folder) {
        this.folder = folder;
    }

    static Thumbnails ofThisUser() {
        return new Thumbnails(UserFolder.CACHE.ofThisUser().map(own -> own.resolve("thumbnails")));
    }

    /** @param done gets the picture on JavaFX's thread; not called if the scene cannot be read */
    void want(Path scene, Consumer<Image> done) {
        if (!closed) {
            thread.execute(() -> find(scene).ifPresent(image -> Platform.runLater(() -> done.accept(image))));
        }
    }

    private Optional<Image> find(Path scene) {
        if (closed) {
            return Optional.empty();
        }
        try {
            Path kept = folder.orElseGet(() -> Path.of(System.getProperty("java.io.tmpdir")))
                    .resolve(name(scene));
            if (!Files.exists(kept)) {
                Files.createDirectories(kept.resolveSibling(""));
                render(scene, kept);
            }
            return Optional.of(new Image(kept.toUri().toString()));
        } catch (IOException | RuntimeException | OutOfMemoryError _) {
            // The tile stays without a picture; opening the scene tells why.
            return Optional.empty();
        }
    }

    /** Another name where the file has changed. */
    private static String name(Path scene) throws IOException {
        String version = scene.toAbsolutePath() + "\n" + Files.getLastModifiedTime(scene) + "\n" + Files.size(scene);
        return UUID.nameUUIDFromBytes(version.getBytes(StandardCharsets.UTF_8)) + ".png";
    }

    private static void render(Path file, Path picture) throws IOException {
        Scene scene = VisibleBodies.of(SceneReader.read(file));
        boolean noisy = scene.rendering().integrator().isNoisy();
        Scene small = scene.withRendering(scene.rendering()
                .withSize(WIDTH, HEIGHT)
                .withSamplesPerPixel(noisy ? TRACED_SAMPLES : SAMPLES)
                .withShadowSamples(Math.min(scene.rendering().shadowSamples(), SHADOW_SAMPLES)));
        SceneMeshes meshes = SceneMeshes.read(small, _ -> {});
        FrameInput input = World.of(small, SceneImages.read(small, meshes, _ -> {}), meshes)
                .snapshot();
        Frame frame = Frame.ofPixels(WIDTH, HEIGHT);
        try (Engine engine = JvmEngines.parallel().opener().get()) {
            engine.render(input, frame);
        }
        PngWriter.write(picture, WIDTH, HEIGHT, frame.argb(), input.srgb());
    }

    /** Renders no more; returns at once. */
    @Override
    public void close() {
        closed = true;
        thread.shutdownNow();
    }
}
