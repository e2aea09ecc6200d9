package dev.twister.gui.drawing;

import dev.twister.sky.SkyException;
import dev.twister.sky.Skybox;
import dev.twister.sky.SkyboxReader;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import java.util.SequencedMap;

/**
 * The panoramas used last, so that going back to one does not read its file again. Used by any thread; none waits while
 * another one reads a file.
 */
public final class SkyShelf {
    private static final int KEPT = 3;

    private final SequencedMap<Path, Skybox> skies = new LinkedHashMap<>();
    private final Map<Path, Long> editions = new HashMap<>();

    /**
     * The panorama of that file, read where it is not at hand.
     *
     * @throws SkyException as {@link SkyboxReader#read} does
     */
    public Skybox find(Path file) {
        return kept(file).orElseGet(() -> keep(file, SkyboxReader.read(file)));
    }

    /**
     * Reads a file anew, because it may have changed.
     *
     * @throws SkyException as {@link SkyboxReader#read} does; the panorama that was at hand stays then
     */
    public void refresh(Path file) {
        Skybox sky = SkyboxReader.read(file);
        synchronized (this) {
            keep(file, sky);
            editions.merge(file, 1L, Long::sum);
        }
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
