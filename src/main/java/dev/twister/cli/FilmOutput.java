package dev.twister.cli;

import dev.twister.files.PrintableText;
import dev.twister.film.FilmFile;
import java.io.PrintWriter;
import java.nio.file.Path;

/** Where a film goes. */
final class FilmOutput {
    private FilmOutput() {}

    /**
     * Looks where a film is to go before it is made.
     *
     * @param err told where an animated PNG takes an .mp4's place
     */
    static FilmFile of(Path output, PrintWriter err) {
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
