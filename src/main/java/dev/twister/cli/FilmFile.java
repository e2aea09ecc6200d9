package dev.twister.cli;

import dev.twister.files.PrintableText;
import dev.twister.film.AnimatedPng;
import dev.twister.film.Ffmpeg;
import dev.twister.film.FilmFormat;
import dev.twister.film.FrameSource;
import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.Optional;

/**
 * A film in one file: .mp4 by ffmpeg, .apng by Java.
 *
 * @param file where it is written
 * @param ffmpeg empty for an animated PNG
 */
record FilmFile(Path file, Optional<Ffmpeg> ffmpeg) {
    private static final String OPTION = "--output";
    private static final String MP4 = ".mp4";
    private static final String APNG = ".apng";

    static boolean isFilm(Path output) {
        return OutputFile.endsIn(output, MP4) || OutputFile.endsIn(output, APNG);
    }

    /**
     * Looks where a film is to go before it is made; where there is no ffmpeg, an animated PNG takes an .mp4's place.
     *
     * @param path where programs are looked for
     * @param err told of that
     */
    static FilmFile of(Path output, String path, PrintWriter err) {
        Optional<Ffmpeg> ffmpeg = OutputFile.endsIn(output, MP4) ? Ffmpeg.find(path) : Optional.empty();
        Path file = output;
        if (ffmpeg.isEmpty() && OutputFile.endsIn(output, MP4)) {
            String name = output.getFileName().toString();
            file = output.resolveSibling(name.substring(0, name.length() - MP4.length()) + APNG);
            err.println("twister: ffmpeg is not on the PATH: writing " + PrintableText.line(file.toString())
                    + ", an animated PNG, instead of " + PrintableText.line(output.toString()));
        }
        OutputFile.check(OPTION, file);
        return new FilmFile(file, ffmpeg);
    }

    void write(FilmFormat format, FrameSource source) throws IOException {
        if (ffmpeg.isPresent()) {
            ffmpeg.get().write(file, format, source);
        } else {
            AnimatedPng.write(file, format, source);
        }
    }

    /** What it is, for people. */
    String kind() {
        return ffmpeg.isPresent() ? "H.264" : "animated PNG";
    }
}
