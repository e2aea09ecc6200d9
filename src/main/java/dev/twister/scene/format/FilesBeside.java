package dev.twister.scene.format;

import dev.twister.files.InputFile;
import dev.twister.scene.format.json.Excerpt;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Comparator;
import java.util.HashMap;
import java.util.Map;
import java.util.stream.Stream;

/** The files that a scene file names relative to its folder. Used by one thread. */
final class FilesBeside implements NamedFiles {
    private final Path scene;
    private final Path target;
    private final boolean needed;

    // Thousands of bodies may name one file, and the disk is slow.
    private final Map<Path, Path> found = new HashMap<>();
    private final Map<Path, Path> named = new HashMap<>();

    /**
     * @param scene the scene file, which may be a link
     * @param target what it leads to
     * @param needed whether files that are found must be there
     */
    FilesBeside(Path scene, Path target, boolean needed) {
        this.scene = scene;
        this.target = target;
        this.needed = needed;
    }

    @Override
    public Path find(Place place, Path name) {
        return found.computeIfAbsent(name, _ -> {
            Path file = existing(name);
            if (needed) {
                check(place, file);
            }
            return file;
        });
    }

    @Override
    public Path name(Path file) {
        return named.computeIfAbsent(file, this::relative);
    }

    private Path existing(Path name) {
        Path file = beside(scene.toAbsolutePath(), name);
        return Stream.of(
                        file,
                        // A link to a scene may be anywhere; its files are where the scene is.
                        beside(target, name),
                        // As Windows goes by names, and as scenes were written in linked folders before.
                        scene.toAbsolutePath().resolveSibling(name).normalize())
                .filter(Files::exists)
                .findFirst()
                .orElse(file);
    }

    private static Path beside(Path scene, Path name) {
        return FilePaths.walked(scene.resolveSibling(name));
    }

    private static void check(Place place, Path file) {
        InputFile.problem(file).ifPresent(problem -> {
            throw place.failure("names " + Excerpt.ofPath(file.toString()) + ": " + problem);
        });
    }

    private Path relative(Path file) {
        Path picture = FilePaths.walked(file);
        Path folder = FilePaths.real(target.resolveSibling(""));
        Path namedFolder = FilePaths.walked(scene.toAbsolutePath().resolveSibling(""));
        // Links beside the scene, to a folder of skies say, are kept; those on the way to the scene lead elsewhere from
        // it. What lies beside it stays so: both may be put elsewhere together.
        return Stream.of(relativized(namedFolder, picture), relativized(folder, picture))
                .filter(path ->
                        FilePaths.real(FilePaths.walked(folder.resolve(path))).equals(FilePaths.real(picture)))
                .min(Comparator.comparingInt(Path::getNameCount))
                .orElseGet(() -> relativized(folder, FilePaths.real(picture)));
    }

    private static Path relativized(Path folder, Path file) {
        try {
            return folder.relativize(file);
        } catch (IllegalArgumentException e) {
            // On another drive, which no relative path reaches.
            return file;
        }
    }
}
