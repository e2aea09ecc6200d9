package dev.twister.gui.panel;

import dev.twister.gui.model.DaylightFile;
import dev.twister.gui.model.DroppedFile;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;

/** The panoramas that a person can choose from without looking for a file. */
public final class SkyList {
    private SkyList() {}

    /** The skies in a folder, by name; none if it cannot be read. */
    public static List<Path> in(Path folder) {
        try (Stream<Path> files = Files.list(folder)) {
            return files.filter(file -> DroppedFile.kind(file) == DroppedFile.Kind.SKYBOX)
                    .map(file -> file.toAbsolutePath().normalize())
                    .sorted()
                    .toList();
        } catch (IOException _) {
            return List.of();
        }
    }

    /** The known ones, with the scene's own and the one in use where they are elsewhere. */
    public static List<Path> with(List<Path> known, Path own, Path used) {
        return Stream.concat(known.stream(), Stream.of(own, used)).distinct().toList();
    }

    /** What a list shows: the file's name without its ending. */
    public static String label(Path panorama) {
        return DaylightFile.of(panorama).isPresent()
                ? "Daylight"
                : String.valueOf(panorama.getFileName()).replaceFirst("\\.[A-Za-z]+$", "");
    }
}
