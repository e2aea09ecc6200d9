package dev.twister.render;

import dev.twister.film.EncodedPixels;
import dev.twister.film.FilmFile;
import dev.twister.film.FilmFormat;
import dev.twister.film.FilmWriting;
import dev.twister.scene.Rendering;
import dev.twister.world.FrameInput;
import java.io.IOException;

/** Renders a film into one file; its frames are encoded while the next ones are drawn. */
public final class FilmRendering {
    private FilmRendering() {}

    /** Bytes per pixel that it takes. */
    public static long bytesPerPixel() {
        return (FilmWriting.WAITING + 1L) * BandedDrawing.bytesPerPixel(false);
    }

    /**
     * Renders the film, whole or not at all.
     *
     * @param drawing draws one picture of each frame
     * @throws IOException as {@link FilmFile#write}, or where the bodies' places cannot be read
     */
    public static void render(
            PictureDrawing drawing, FilmScene shown, FrameRange frames, FilmFile file, RenderProgress progress)
            throws IOException {
        Rendering settings = shown.world().settings();
        FilmFormat format = new FilmFormat(settings.width(), settings.height(), shown.rate(), frames.count());
        try (FilmWriting writing = new FilmWriting(file, format)) {
            for (int number : frames.numbers().toArray()) {
                FrameInput input = shown.frame(number);
                DrawnPicture drawn = drawing.draw(input, progress).getFirst();
                writing.add(EncodedPixels.of(drawn.pixels(), PictureFormat.isEncoded(drawn, input)));
                progress.frame();
            }
            writing.finish();
        }
    }
}
