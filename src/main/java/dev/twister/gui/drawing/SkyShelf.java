package dev.twister.gui.drawing;

import dev.twister.scene.Scene;
import dev.twister.sky.SkyException;
import dev.twister.sky.Skybox;
import dev.twister.sky.SkyboxReader;
import dev.twister.sky.TextureReader;
import dev.twister.world.SceneImages;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import java.util.Queue;
import java.util.SequencedMap;
import java.util.StringJoiner;
import java.util.concurrent.ConcurrentLinkedQueue;

/**
 * The panoramas used last, so that going back to one does not read its file again, and the textures of the scene that was
 * opened last. Used by any thread; none waits while
 * another one reads a file.
 */
public final class SkyShelf {
    private static final int KEPT = 3;

    private final SequencedMap<Path, Skybox> skies = new LinkedHashMap<>();
    private final Map<Path, Long> editions = new HashMap<>();
    private Map<Path, Skybox> textures = Map.of();
    private long texturesEdition;
    private final Queue<String> warnings = new ConcurrentLinkedQueue<>();

    /**
     * The panorama of that file, read where it is not at hand.
     *
     * @throws SkyException as {@link SkyboxReader#read} does
     */
    public Skybox find(Path file) {
        return kept(file).orElseGet(() -> keep(file, SkyboxReader.read(file, warnings::add)));
    }

    /**
     * Reads a file anew, because it may have changed.
     *
     * @throws SkyException as {@link SkyboxReader#read} does; the panorama that was at hand stays then
     */
    public void refresh(Path file) {
        Skybox sky = SkyboxReader.read(file, warnings::add);
        synchronized (this) {
            keep(file, sky);
            editions.merge(file, 1L, Long::sum);
        }
    }

    /**
     * Reads a scene's sky and textures anew.
     *
     * @throws SkyException as {@link SkyboxReader#read} and {@link SceneImages#textures} do; the textures that were at hand
     *     stay then
     */
    public void refresh(Scene scene) {
        refresh(scene.skybox());
        Map<Path, Skybox> read = SceneImages.textures(scene, file -> TextureReader.read(file, warnings::add));
        synchronized (this) {
            textures = read;
            texturesEdition++;
        }
    }

    /**
     * The texture of that file: as it was with the scene that was read last, else read now.
     *
     * @throws SkyException as {@link TextureReader#read} does
     */
    Skybox texture(Path file) {
        return keptTexture(file).orElseGet(() -> TextureReader.read(file, warnings::add));
    }

    private synchronized Optional<Skybox> keptTexture(Path file) {
        return Optional.ofNullable(textures.get(file));
    }

    /** How often textures were read anew. */
    synchronized long texturesEdition() {
        return texturesEdition;
    }

    /** What the files that were read since the last call say and is not used; empty where there is nothing. */
    public String takeWarnings() {
        StringJoiner taken = new StringJoiner("; ");
        for (String warning = warnings.poll(); warning != null; warning = warnings.poll()) {
            taken.add(warning);
        }
        return taken.toString();
    }

    /** How often a file was read anew: whoever has its panorama of another number has an old one. */
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
