package dev.twister.film;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Optional;

/**
 * A film in one file: .mp4 by ffmpeg, .apng by Java.
 *
 * @param file where it is written
 * @param ffmpeg empty for an animated PNG
 */
public record FilmFile(Path file, Optional<Ffmpeg> ffmpeg) {
    private static final String MP4 = ".mp4";
    private static final String APNG = ".apng";

    /** Whether a file of that name is a film. */
    public static boolean isFilm(Path output) {
        return endsIn(output, MP4) || endsIn(output, APNG);
    }

    /**
     * The film that a name means; where there is no ffmpeg, an animated PNG beside it takes an .mp4's place.
     *
     * @param path where programs are looked for
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
     * Writes the film, whole or not at all.
     *
     * @throws IOException as {@link Ffmpeg#write} or {@link AnimatedPng#write}
     */
    public void write(FilmFormat format, FrameSource source) throws IOException {
        if (ffmpeg.isPresent()) {
            ffmpeg.get().write(file, format, source);
        } else {
            AnimatedPng.write(file, format, source);
        }
    }

    /** What it is, for people. */
    public String kind() {
        return ffmpeg.isPresent() ? "H.264" : "animated PNG";
    }
}
