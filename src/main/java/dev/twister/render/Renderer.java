package dev.twister.render;

import dev.twister.denoise.DenoiserOffer;
import dev.twister.engine.ExposureMeter;
import dev.twister.film.EncodedPixels;
import dev.twister.film.FilmFile;
import dev.twister.film.FilmFormat;
import dev.twister.film.FilmWriting;
import dev.twister.image.PictureNotes;
import dev.twister.image.Provenance;
import dev.twister.render.RenderOrder.BodyMotion;
import dev.twister.threads.BackgroundWriter;
import dev.twister.world.FrameInput;
import dev.twister.world.StageOrView;
import dev.twister.world.World;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;

/** Renders an order to its files. Files are written in the background while the next frames are rendered. */
public final class Renderer {
    private static final int MOST_WRITERS = 4;

    private final RenderOrder order;
    private final RenderOutput output;
    private final RenderProgress progress;
    private final PictureDrawing drawing;
    private final FilmFrames shown;

    private Renderer(RenderOrder order, RenderProgress progress, PictureDrawing drawing, FilmFrames shown) {
        this.order = order;
        output = order.output();
        this.progress = progress;
        this.drawing = drawing;
        this.shown = shown;
    }

    /**
     * Renders an order. Each file is written whole or not at all.
     *
     * @param world of the order's scene
     * @throws IOException if a file cannot be written, or the bodies' positions cannot be read
     * @throws dev.twister.engine.EngineException if the engine does not work
     * @throws dev.twister.denoise.DenoiseException if the denoiser does not work
     * @throws BlackPictureException if the exposure cannot be set by a picture
     */
    public static RenderResult render(RenderOrder order, World world, RenderProgress progress) throws IOException {
        world.setSettings(order.scene().rendering());
        // Told at once, not after minutes of simulation.
        order.engine().check();
        order.finishing().denoiser().ifPresent(DenoiserOffer::check);
        try (FilmBodies bodies = FilmBodies.of(order.movement(), order.scene(), world.meshes(), progress)) {
            FilmFrames frames = new FilmFrames(order, world, bodies);
            try (PictureDrawing drawing = new PictureDrawing(order, world::lightGroups, frames::at)) {
                Renderer rendering = new Renderer(order, progress, drawing, frames);
                rendering.setExposure();
                progress.begin();
                return rendering.render();
            }
        }
    }

    /** Memory that rendering and writing takes, in bytes per pixel. */
    public static long bytesPerPixel(RenderOrder order) {
        RenderOutput output = order.output();
        // Without background, linear colors and alpha.
        long cut = output.isCut() ? 2 * BandedDrawing.bytesPerPixel(true) : 0;
        long layers = order.finishing().bytesPerPixel() + cut;
        // Bands take less, but a blurred picture is rendered in one go, by sums of halves, their sum and a pass.
        long blurred = order.movement().isBlurred() ? 4 * (layers + BandedDrawing.bytesPerPixel(true)) : 0;
        long finishing = layers + blurred;
        if (output.isFilm()) {
            return (1L + FilmWriting.WAITING) * BandedDrawing.bytesPerPixel(false) + finishing;
        }
        long pictures = output.frames().isPresent() ? 1L + room(writers(output)) : 1;
        return pictures * (output.format().bytesPerPixel(order.pictures()) + finishing);
    }

    private static int writers(RenderOutput output) {
        // Standard output needs the order of the frames.
        return output.isStandardOutput()
                ? 1
                : Math.clamp(Runtime.getRuntime().availableProcessors() / 2, 1, MOST_WRITERS);
    }

    private static int room(int writers) {
        return writers + 1;
    }

    private RenderResult render() throws IOException {
        if (output.isFilm()) {
            return film();
        }
        return output.frames().isPresent() ? frames() : picture();
    }

    /** By the film's first frame, whichever frames are rendered, so that all parts of a film are as bright. */
    private void setExposure() throws IOException {
        StageOrView first = order.pictures().getFirst();
        if (order.finishing().autoExposure() && first.isColor() && !output.isLinear()) {
            int start = order.movement().bodies() instanceof BodyMotion.Recorded recorded
                    ? recorded.file().firstFrame()
                    : 0;
            FrameInput input = shown.frame(start).showing(first);
            shown.setExposure(ExposureMeter.stops(output.isCut() ? input.withoutBackground() : input)
                    .orElseThrow(BlackPictureException::new));
        }
    }

    private RenderResult film() throws IOException {
        FrameRange frames = output.range();
        FilmFormat format = new FilmFormat(
                order.size().width(), order.size().height(), order.movement().rate(), frames.count(), output.isCut());
        RenderResult.Samples samples = RenderResult.Samples.NONE;
        try (FilmWriting writing = new FilmWriting(FilmFile.of(output.file()), format)) {
            for (int number : frames.numbers().toArray()) {
                FrameInput input = shown.frame(number);
                RenderedView drawn = drawing.draw(input, progress).getFirst();
                samples = samples.plus(drawn.drawn());
                writing.add(EncodedPixels.of(drawn.pixels(), PictureFormat.isEncoded(drawn, input)));
                progress.frame();
            }
            writing.finish();
        }
        return new RenderResult(0, samples, Optional.empty());
    }

    private RenderResult frames() throws IOException {
        int kept = 0;
        RenderResult.Samples samples = RenderResult.Samples.NONE;
        int writers = writers(output);
        try (BackgroundWriter writer = new BackgroundWriter("writing", writers, room(writers))) {
            for (int number : output.range().numbers().toArray()) {
                FrameInput input = shown.frame(number);
                FrameInput part = order.part().of(input);
                Provenance made = drawing.provenance(input);
                if (isKept(number, made, part)) {
                    kept++;
                } else {
                    List<RenderedView> drawn = drawing.draw(input, progress);
                    samples = samples.plus(drawn.getFirst().drawn());
                    writer.submit(1, () -> write(number, drawn, part, made));
                }
                progress.frame();
            }
            writer.finish();
        }
        return new RenderResult(kept, samples, Optional.empty());
    }

    private RenderResult picture() throws IOException {
        FrameInput input = shown.frame(0);
        FrameInput part = order.part().of(input);
        List<RenderedView> drawn = drawing.draw(input, progress);
        progress.frame();
        write(0, drawn, part, drawing.provenance(input));
        return new RenderResult(
                0,
                RenderResult.Samples.NONE.plus(drawn.getFirst().drawn()),
                Optional.of(new RenderResult.Single(
                        drawn, part, drawing.engine().id(), drawing.engine().device())));
    }

    private boolean isKept(int number, Provenance made, FrameInput part) {
        Path file = output.file(number);
        if (!output.isNumbered() || output.existing() != ExistingFrames.KEPT || Files.notExists(file)) {
            return false;
        }
        try {
            Optional<Provenance> found = PictureNotes.of(file, part.firstRow(), part.rows());
            if (found.filter(made::isOfSamePicture).isPresent()) {
                return true;
            }
            progress.replacing(file, "differs in its scene, settings or version");
        } catch (IOException _) {
            progress.replacing(file, "is damaged or incomplete");
        }
        return false;
    }

    private void write(int number, List<RenderedView> drawn, FrameInput part, Provenance made) throws IOException {
        output.format().write(output.file(number), drawn, part, output.isCut(), made);
    }

    /** The exposure should be set by a picture without any light. */
    public static final class BlackPictureException extends RuntimeException {
        private static final long serialVersionUID = 1;

        BlackPictureException() {
            super("the picture is black");
        }
    }
}
