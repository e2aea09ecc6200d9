package dev.twister.film;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Optional;

/**
 * The file of a film: .mp4, encoded by ffmpeg, or .apng, encoded in Java.
 *
 * @param file the output file
 * @param ffmpeg empty for an animated PNG
 */
public record FilmFile(Path file, Optional<Ffmpeg> ffmpeg) {
    private static final String MP4 = ".mp4";
    private static final String APNG = ".apng";

    /** Whether the name has a film's ending. */
    public static boolean isFilm(Path output) {
        return endsIn(output, MP4) || endsIn(output, APNG);
    }

    /** As {@link #of(Path, String)}, with this process's search path. */
    public static FilmFile of(Path output) {
        return of(output, System.getenv().getOrDefault("PATH", ""));
    }

    /**
     * The film with this name. Without ffmpeg, an .mp4 becomes an .apng in the same folder.
     *
     * @param path search path of programs
     */
    public static FilmFile of(Path output, String path) {
        Optional<Ffmpeg> ffmpeg = endsIn(output, MP4) ? Ffmpeg.find(path) : Optional.empty();
        if (ffmpeg.isPresent() || !endsIn(output, MP4)) {
            return new FilmFile(output, ffmpeg);
        }
        String name = output.getFileName().toString();
        return new FilmFile(
                output.resolveSibling(name.substring(0, name.length() - MP4.length()) + APNG), Optional.empty());
    }

    private static boolean endsIn(Path file, String ending) {
        return file.toString().toLowerCase(Locale.ROOT).endsWith(ending);
    }

    /**
     * Begins the film, which is written to a temporary file until it is finished.
     *
     * @throws IOException if the file cannot be written
     */
    public FilmEncoder begin(FilmFormat format) throws IOException {
        if (Files.exists(file) && !Files.isRegularFile(file)) {
            throw new IOException("cannot write " + file + ": it is not a regular file");
        }
        return ffmpeg.isPresent() ? ffmpeg.get().begin(file, format) : AnimatedPng.begin(file, format);
    }

    /** The format's name, for display. */
    public String kind() {
        return ffmpeg.isPresent() ? "H.264" : "animated PNG";
    }
}
