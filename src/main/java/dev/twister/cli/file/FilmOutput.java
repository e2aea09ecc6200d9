package dev.twister.cli.file;

import dev.twister.files.PrintableText;
import dev.twister.film.FilmFile;
import java.io.PrintWriter;
import java.nio.file.Path;

/** Checks the output of a film. */
public final class FilmOutput {
    private FilmOutput() {}

    /**
     * The film's file, checked before rendering.
     *
     * @param err receives a note if an animated PNG replaces an .mp4
     */
    public static FilmFile of(Path output, PrintWriter err) {
        FilmFile film = FilmFile.of(output);
        if (!film.file().equals(output)) {
            err.println("twister: ffmpeg is not on the PATH: writing "
                    + PrintableText.line(film.file().toString()) + ", an animated PNG, instead of "
                    + PrintableText.line(output.toString()));
        }
        OutputFile.check("--output", film.file());
        return film;
    }
}
