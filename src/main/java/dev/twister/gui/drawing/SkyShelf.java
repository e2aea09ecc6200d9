package dev.twister.gui.drawing;

import dev.twister.scene.Scene;
import dev.twister.scene.format.TexturePlaces;
import dev.twister.sky.SkyException;
import dev.twister.sky.Skybox;
import dev.twister.sky.SkyboxReader;
import dev.twister.sky.TextureReader;
import dev.twister.world.HiddenTextures;
import dev.twister.world.SceneImages;
import dev.twister.world.SceneMeshes;
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
 * The panoramas used last, so that going back to one does not read its file again, and the textures of the scene. Used
 * by any thread; none waits while another one reads a file.
 */
public final class SkyShelf {
    private static final int KEPT = 3;
    private static final long ASKED_EVERY_MILLIS = 20;

    private final BiFunction<Path, Consumer<String>, Skybox> reader;
    private final BiFunction<Path, Consumer<String>, Skybox> textureReader;
    private final SequencedMap<Path, Skybox> skies = new LinkedHashMap<>();
    private final Map<Path, Long> editions = new HashMap<>();
    private volatile Optional<Path> beingRead = Optional.empty();
    private Map<Path, Skybox> textures = Map.of();
    private long texturesEdition;
    private final Queue<String> warnings = new ConcurrentLinkedQueue<>();
    private final Set<String> hiddenTextures = ConcurrentHashMap.newKeySet();

    public SkyShelf() {
        this(SkyboxReader::read, TextureReader::read);
    }

    /** A shelf whose files are read by those. */
    SkyShelf(
            BiFunction<Path, Consumer<String>, Skybox> reader,
            BiFunction<Path, Consumer<String>, Skybox> textureReader) {
        this.reader = reader;
        this.textureReader = textureReader;
    }

    /**
     * The panorama of that file, read where it is not at hand.
     *
     * @param wanted asked again and again meanwhile, whether it still is
     * @throws SkyException as {@link SkyboxReader#read} does, and where it is not wanted any more or was {@link #cancel
     *     canceled}
     */
    Skybox find(Path file, BooleanSupplier wanted) {
        return kept(file).orElseGet(() -> keep(file, await(file, reader, wanted)));
    }

    /** What a thread waits for in {@link #find} or {@link #texture}. */
    public Optional<Path> beingRead() {
        return beingRead;
    }

    /** Wakes the threads that wait in {@link #find} or {@link #texture}. */
    public void cancel() {
        beingRead = Optional.empty();
    }

    private Skybox await(Path file, BiFunction<Path, Consumer<String>, Skybox> from, BooleanSupplier wanted) {
        CompletableFuture<Skybox> picture = new CompletableFuture<>();
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
            // Which closes the file under it.
            thread.interrupt();
        }
    }

    private static void waitFor(CompletableFuture<Skybox> picture) {
        try {
            picture.get(ASKED_EVERY_MILLIS, TimeUnit.MILLISECONDS);
        } catch (InterruptedException | ExecutionException | TimeoutException _) {
            // The waiting threads look for themselves.
        }
    }

    private static RuntimeException thrown(Throwable problem) {
        if (problem instanceof Error error) {
            throw error;
        }
        return (RuntimeException) problem;
    }

    /**
     * Reads a file anew, because it may have changed.
     *
     * @throws SkyException as {@link SkyboxReader#read} does; the panorama that was at hand stays then
     */
    public void refresh(Path file) {
        Skybox sky = reader.apply(file, warnings::add);
        synchronized (this) {
            keep(file, sky);
            editions.merge(file, 1L, Long::sum);
        }
    }

    /**
     * Reads a scene's sky and textures anew.
     *
     * @throws SkyException as {@link SkyboxReader#read} and {@link SceneImages#textures} do; the textures that were at
     *     hand stay then
     */
    public void refresh(Scene scene) {
        refresh(scene.sky().file());
        refreshTextures(scene);
    }

    /**
     * Reads a scene's textures anew.
     *
     * @throws SkyException as {@link SceneImages#textures} does; the textures that were at hand stay then
     */
    public void refreshTextures(Scene scene) {
        Map<Path, Skybox> read = SceneImages.textures(scene, file -> textureReader.apply(file, warnings::add));
        synchronized (this) {
            textures = read;
            texturesEdition++;
        }
    }

    /**
     * Reads a texture anew, which a scene is to have besides its own.
     *
     * @throws SkyException as {@link TextureReader#read} does; the textures that were at hand stay then
     */
    public void refreshTexture(Scene scene, Path file) {
        Skybox read = textureReader.apply(file, warnings::add);
        synchronized (this) {
            Map<Path, Skybox> kept = new HashMap<>(textures);
            kept.keySet().retainAll(TexturePlaces.of(scene).keySet());
            kept.put(file, read);
            textures = kept;
            texturesEdition++;
        }
    }

    /**
     * The texture of that file: as it was read last with the scene or for it, else read now.
     *
     * @param wanted asked again and again meanwhile, whether it still is
     * @throws SkyException as {@link TextureReader#read} does, and where it is not wanted any more or was
     *     {@link #cancel canceled}
     */
    Skybox texture(Path file, BooleanSupplier wanted) {
        return keptTexture(file).orElseGet(() -> await(file, textureReader, wanted));
    }

    private synchronized Optional<Skybox> keptTexture(Path file) {
        return Optional.ofNullable(textures.get(file));
    }

    /**
     * The sky and the textures of a scene and its meshes: those at hand, and others read now, which are not kept. Waits
     * for no other thread.
     *
     * @throws SkyException where one cannot be read
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
                                .orElseGet(() -> textureReader.apply(file, warnings::add))));
    }

    /** How often textures were read anew. */
    synchronized long texturesEdition() {
        return texturesEdition;
    }

    /** Adds to what {@link #takeWarnings} tells: what a file says that was read elsewhere. */
    public void warn(String warning) {
        warnings.add(warning);
    }

    /** What the files that were read since the last call say and is not used; empty where there is nothing. */
    public String takeWarnings() {
        StringJoiner taken = new StringJoiner("; ");
        for (String warning = warnings.poll(); warning != null; warning = warnings.poll()) {
            taken.add(warning);
        }
        return taken.toString();
    }

    /** How often a file was read again: a panorama with another number is out of date. */
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
