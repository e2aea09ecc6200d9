package dev.twister.gui.drawing;

import dev.twister.sky.SkyException;
import dev.twister.sky.Skybox;
import dev.twister.sky.SkyboxReader;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.SequencedMap;

/** The panoramas used last, so that going back to one does not read its file again. Used by any thread. */
public final class SkyShelf {
    private static final int KEPT = 3;

    private final SequencedMap<Path, Skybox> skies = new LinkedHashMap<>();

    /**
     * The panorama of that file, read where it is not at hand.
     *
     * @throws SkyException as {@link SkyboxReader#read} does
     */
    public synchronized Skybox find(Path file) {
        Skybox sky = skies.remove(file);
        if (sky == null) {
            sky = SkyboxReader.read(file);
        }
        skies.putLast(file, sky);
        if (skies.size() > KEPT) {
            skies.pollFirstEntry();
        }
        return sky;
    }

    /** Reads a file anew, because it may have changed. */
    public synchronized Skybox refresh(Path file) {
        Skybox sky = SkyboxReader.read(file);
        skies.remove(file);
        skies.putLast(file, sky);
        return sky;
    }

    synchronized Map<Path, Skybox> kept() {
        return Map.copyOf(skies);
    }
}
