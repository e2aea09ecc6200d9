package dev.twister.gui.drawing;

import dev.twister.gui.property.DaylightFile;
import dev.twister.scene.Scene;
import dev.twister.scene.format.TexturePlaces;
import dev.twister.sky.SkyException;
import dev.twister.sky.Skybox;
import dev.twister.sky.SkyboxReader;
import dev.twister.sky.TextureImage;
import dev.twister.sky.TextureReader;
import dev.twister.world.HiddenTextures;
import dev.twister.world.SceneImages;
import dev.twister.world.SceneMeshes;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import java.util.Queue;
import java.util.SequencedMap;
import java.util.Set;
import java.util.StringJoiner;
import java.util.concurrent.CancellationException;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.function.BiFunction;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;

/**
 * A cache of the last panoramas and of the scene's textures. Used by any thread; none waits while another one reads a
 * file.
 */
public final class ImageCache {
    private static final int KEPT = 3;
    private static final long ASKED_EVERY_MILLIS = 20;

    private final BiFunction<Path, Consumer<String>, Skybox> reader;
    private final BiFunction<Path, Consumer<String>, TextureImage> textureReader;
    private final SequencedMap<Path, Skybox> skies = new LinkedHashMap<>();
    private final Map<Path, Long> editions = new HashMap<>();
    private volatile Optional<Path> beingRead = Optional.empty();
    private Map<Path, TextureImage> textures = Map.of();
    private long texturesEdition;
    private final Queue<String> warnings = new ConcurrentLinkedQueue<>();
    private final Set<String> hiddenTextures = ConcurrentHashMap.newKeySet();

    public ImageCache() {
        this(ImageCache::read, TextureReader::read);
    }

    /** A missing daylight sky is drawn as its name tells. */
    private static Skybox read(Path file, Consumer<String> warnings) {
        return DaylightFile.of(file)
                .filter(_ -> !Files.exists(file))
                .map(DaylightFile::draw)
                .orElseGet(() -> SkyboxReader.read(file, warnings));
    }

    /** A cache that reads files with these readers. */
    ImageCache(
            BiFunction<Path, Consumer<String>, Skybox> reader,
            BiFunction<Path, Consumer<String>, TextureImage> textureReader) {
        this.reader = reader;
        this.textureReader = textureReader;
    }

    /**
     * The panorama of a file, read if it is not cached.
     *
     * @param wanted called repeatedly meanwhile; reading stops when it returns false
     * @throws SkyException as {@link SkyboxReader#read} does, and if it is no longer wanted or was {@link #cancel
     *     canceled}
     */
    Skybox find(Path file, BooleanSupplier wanted) {
        // A daylight sky is there sooner than a slider moves on, and to cancel it would show none of them.
        return kept(file)
                .orElseGet(() -> keep(
                        file,
                        DaylightFile.of(file).isPresent()
                                ? reader.apply(file, warnings::add)
                                : await(file, reader, wanted)));
    }

    /** The file that a thread waits for in {@link #find} or {@link #texture}. */
    public Optional<Path> beingRead() {
        return beingRead;
    }

    /** Cancels reading in {@link #find} and {@link #texture}. */
    public void cancel() {
        beingRead = Optional.empty();
    }

    private <T> T await(Path file, BiFunction<Path, Consumer<String>, T> from, BooleanSupplier wanted) {
        CompletableFuture<T> picture = new CompletableFuture<>();
        beingRead = Optional.of(file);
        Thread thread = Thread.ofPlatform().daemon().name("picture").start(() -> {
            try {
                picture.complete(from.apply(file, warnings::add));
            } catch (RuntimeException | Error problem) {
                picture.completeExceptionally(problem);
            }
        });
        try {
            while (!picture.isDone()) {
                if (!wanted.getAsBoolean() || beingRead.isEmpty()) {
                    throw new SkyException(file + ": reading was canceled", new CancellationException());
                }
                waitFor(picture);
            }
            return picture.join();
        } catch (CompletionException problem) {
            throw thrown(problem.getCause());
        } finally {
            beingRead = Optional.empty();
            // This closes the file under the reading thread.
            thread.interrupt();
        }
    }

    private static void waitFor(CompletableFuture<?> picture) {
        try {
            picture.get(ASKED_EVERY_MILLIS, TimeUnit.MILLISECONDS);
        } catch (InterruptedException | ExecutionException | TimeoutException _) {
            // The waiting threads notice it themselves.
        }
    }

    private static RuntimeException thrown(Throwable problem) {
        if (problem instanceof Error error) {
            throw error;
        }
        return (RuntimeException) problem;
    }

    /**
     * Reads a file again, because it may have changed.
     *
     * @throws SkyException as {@link SkyboxReader#read} does; the cached panorama stays
     */
    public void refresh(Path file) {
        Skybox sky = reader.apply(file, warnings::add);
        synchronized (this) {
            keep(file, sky);
            editions.merge(file, 1L, Long::sum);
        }
    }

    /** Reads a file again as {@link #refresh(Path)} does; returns what is wrong with it. */
    public Optional<RuntimeException> problemOf(Path file) {
        try {
            refresh(file);
            return Optional.empty();
        } catch (SkyException problem) {
            return Optional.of(problem);
        }
    }

    /**
     * Reads a scene's sky and textures again.
     *
     * @throws SkyException as {@link SkyboxReader#read} and {@link SceneImages#textures} do; the cached textures stay
     */
    public void refresh(Scene scene) {
        refresh(scene.sky().file());
        refreshTextures(scene);
    }

    /**
     * Reads a scene's textures again.
     *
     * @throws SkyException as {@link SceneImages#textures} does; the cached textures stay
     */
    public void refreshTextures(Scene scene) {
        Map<Path, TextureImage> read = SceneImages.textures(scene, file -> textureReader.apply(file, warnings::add));
        synchronized (this) {
            textures = read;
            texturesEdition++;
        }
    }

    /**
     * Reads a texture for a scene that does not use it yet.
     *
     * @throws SkyException as {@link TextureReader#read} does; the cached textures stay
     */
    public void refreshTexture(Scene scene, Path file) {
        TextureImage read = textureReader.apply(file, warnings::add);
        synchronized (this) {
            Map<Path, TextureImage> kept = new HashMap<>(textures);
            kept.keySet().retainAll(TexturePlaces.of(scene).keySet());
            kept.put(file, read);
            textures = kept;
            texturesEdition++;
        }
    }

    /**
     * The texture of a file, read if it is not cached.
     *
     * @param wanted called repeatedly meanwhile; reading stops when it returns false
     * @throws SkyException as {@link TextureReader#read} does, and if it is no longer wanted or was {@link #cancel
     *     canceled}
     */
    TextureImage texture(Path file, BooleanSupplier wanted) {
        return keptTexture(file).orElseGet(() -> await(file, textureReader, wanted));
    }

    private synchronized Optional<TextureImage> keptTexture(Path file) {
        return Optional.ofNullable(textures.get(file));
    }

    /**
     * The sky and the textures of a scene and its meshes: the cached ones, and others that are read now and not cached.
     * Waits for no other thread.
     *
     * @throws SkyException if one cannot be read
     */
    public SceneImages images(Scene scene, SceneMeshes meshes) {
        // Each once: an edit of the scene asks for its images again.
        HiddenTextures.of(scene, meshes).stream().filter(hiddenTextures::add).forEach(warnings::add);
        Skybox sky = kept(scene.sky().file())
                .orElseGet(() -> reader.apply(scene.sky().file(), warnings::add));
        return new SceneImages(
                sky,
                SceneImages.textures(
                        scene,
                        meshes,
                        file -> meshes.embeddedImage(file)
                                .map(bytes -> TextureReader.read(file, bytes, warnings::add))
                                .or(() -> keptTexture(file))
                                .orElseGet(() -> textureReader.apply(file, warnings::add)),
                        warnings::add));
    }

    /** Counts how often textures were read again. */
    synchronized long texturesEdition() {
        return texturesEdition;
    }

    /** Adds a warning about a file that was read elsewhere to {@link #takeWarnings}. */
    public void warn(String warning) {
        warnings.add(warning);
    }

    /** Warnings about files read since the last call; empty if there are none. */
    public String takeWarnings() {
        StringJoiner taken = new StringJoiner("; ");
        for (String warning = warnings.poll(); warning != null; warning = warnings.poll()) {
            taken.add(warning);
        }
        return taken.toString();
    }

    /** Counts how often a file was read again: a panorama with another number is out of date. */
    synchronized long edition(Path file) {
        return editions.getOrDefault(file, 0L);
    }

    private synchronized Optional<Skybox> kept(Path file) {
        return Optional.ofNullable(skies.get(file)).map(sky -> keep(file, sky));
    }

    private synchronized Skybox keep(Path file, Skybox sky) {
        skies.remove(file);
        skies.putLast(file, sky);
        if (skies.size() > KEPT) {
            skies.pollFirstEntry();
        }
        return sky;
    }
}
