package dev.twister.gui.model;

import dev.twister.engine.EngineOffer;
import dev.twister.film.FilmFile;
import dev.twister.image.PictureSize;
import dev.twister.render.FilmRendering;
import dev.twister.render.FrameRange;
import dev.twister.render.FrameRendering;
import dev.twister.render.PictureFormat;
import dev.twister.scene.Scene;
import dev.twister.world.FrameInput;
import dev.twister.world.Picture;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;

/**
 * What is to be rendered to a file: everything that a rendering depends on.
 *
 * @param scene with the size and the samples to render
 * @param picture all of the picture, or a stage or a view of it
 * @param engine renders it
 * @param film what moves; empty for a single picture
 * @param seen where bodies are in a single picture; empty where the scene has them
 * @param file its name tells the format, as in {@code twister render}
 */
public record RenderOrder(
        Scene scene, Picture picture, EngineOffer engine, Optional<Film> film, Optional<FrameInput> seen, Path file) {
    /**
     * A film.
     *
     * @param rate frames per second
     */
    public record Film(FilmMotion motion, double rate, FrameRange frames) {}

    /** The size of each picture. */
    public PictureSize size() {
        return new PictureSize(scene.rendering().width(), scene.rendering().height());
    }

    /** Bytes per pixel that it takes. */
    public long bytesPerPixel() {
        if (FilmFile.isFilm(file)) {
            return FilmRendering.bytesPerPixel();
        }
        long kept = film.isPresent() ? FrameRendering.picturesKept(false) : 1;
        return kept * format().bytesPerPixel(List.of(picture));
    }

    /** The format of pictures; a PNG where the name tells none. */
    PictureFormat format() {
        return PictureFormat.of(file).orElse(PictureFormat.PNG);
    }
}
