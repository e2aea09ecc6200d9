package dev.twister.gui.model;

import dev.twister.film.FilmFile;
import dev.twister.physics.Simulation;
import dev.twister.render.DrawnPicture;
import dev.twister.render.FilmBodies;
import dev.twister.render.FilmRendering;
import dev.twister.render.FilmScene;
import dev.twister.render.FrameRange;
import dev.twister.render.FrameRendering;
import dev.twister.render.NumberedFiles;
import dev.twister.render.NumberedPictures;
import dev.twister.render.PictureDrawing;
import dev.twister.render.PicturePart;
import dev.twister.render.Sampling;
import dev.twister.scene.Camera;
import dev.twister.scene.Scene;
import dev.twister.world.FrameInput;
import dev.twister.world.Picture;
import dev.twister.world.World;
import java.io.IOException;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CancellationException;
import java.util.concurrent.CompletableFuture;
import java.util.function.DoubleFunction;
import java.util.function.LongSupplier;
import java.util.function.Supplier;

/**
 * Renders to files on a thread of its own, with an engine of its own; the file is what {@code twister render} gives.
 */
public final class RenderJob {
    private final RenderOrder order;
    private final Supplier<World> reader;
    private final JobProgress progress;
    private final CompletableFuture<Path> result = new CompletableFuture<>();
    private final Thread thread;
    private volatile boolean canceled;

    private RenderJob(RenderOrder order, Supplier<World> reader, LongSupplier clock) {
        this.order = order;
        this.reader = reader;
        int frames = order.film().map(film -> film.frames().count()).orElse(1);
        progress = new JobProgress(frames, clock, this::check);
        thread = Thread.ofPlatform().daemon().name("rendering to file").unstarted(this::run);
    }

    /**
     * Begins to render. Returns at once.
     *
     * @param reader gives the order's world, on the job's thread; what it throws is the job's failure
     * @param clock in nanoseconds
     */
    public static RenderJob start(RenderOrder order, Supplier<World> reader, LongSupplier clock) {
        RenderJob job = new RenderJob(order, reader, clock);
        job.thread.start();
        return job;
    }

    /** What is rendered. */
    public RenderOrder order() {
        return order;
    }

    /** How far it is; any thread may ask. */
    public JobProgress progress() {
        return progress;
    }

    /**
     * The file, or the first of numbered ones; or what went wrong, which is a {@link CancellationException} where the
     * job was canceled. Completed on the job's thread.
     */
    public CompletableFuture<Path> result() {
        return result;
    }

    /**
     * Lets the job end soon. Files that are not whole are not left; numbered frames that are whole are. Returns at
     * once.
     */
    public void cancel() {
        canceled = true;
    }

    public boolean isCanceled() {
        return canceled;
    }

    /** Waits for the job's end, which is soon once it is canceled: after what is being drawn; whether it ended. */
    public boolean awaitEnd(Duration limit) throws InterruptedException {
        return thread.join(limit);
    }

    private void run() {
        try {
            result.complete(render());
        } catch (IOException | RuntimeException | Error problem) {
            result.completeExceptionally(problem);
        }
    }

    private void check() {
        if (canceled) {
            throw new CancellationException();
        }
    }

    private Path render() throws IOException {
        Scene scene = order.scene();
        World world = reader.get();
        check();
        world.setSettings(scene.rendering());
        boolean linear = !FilmFile.isFilm(order.file()) && order.format().isLinear();
        try (PictureDrawing drawing = new PictureDrawing(
                order.engine().opener(),
                List.of(picture()),
                new Sampling(scene.rendering().samplesPerPixel(), Optional.empty()),
                PicturePart.WHOLE,
                linear)) {
            return order.film().isPresent() ? film(drawing, world, order.film().get()) : picture(drawing, world);
        }
    }

    /** The last stage is the same picture, which files and commands call by this name. */
    private Picture picture() {
        return order.picture() == Picture.REFLECTIONS ? Picture.BEAUTY : order.picture();
    }

    private Path picture(PictureDrawing drawing, World world) throws IOException {
        Scene scene = order.scene();
        FilmBodies bodies = order.seen().map(SeenBodies::of).orElse(FilmBodies.still());
        FrameInput input = new FilmScene(scene, world, bodies, _ -> scene.camera(), 1).frame(0);
        progress.begin();
        List<DrawnPicture> drawn = drawing.draw(input, progress);
        check();
        order.format().write(order.file(), drawn, input, drawing.provenance(input));
        return order.file();
    }

    private Path film(PictureDrawing drawing, World world, RenderOrder.Film film) throws IOException {
        Scene scene = order.scene();
        // As the command computes it, so that times are the same to the last bit.
        double secondsPerFrame = 1 / film.rate();
        DoubleFunction<Camera> camera = film.motion().camera(scene.camera());
        if (!film.motion().movesBodies()) {
            return film(drawing, new FilmScene(scene, world, FilmBodies.still(), camera, 1 / secondsPerFrame), film);
        }
        try (Simulation simulation = Simulation.of(scene, world.meshes())) {
            FilmBodies bodies = FilmBodies.simulated(simulation, secondsPerFrame, this::check);
            return film(drawing, new FilmScene(scene, world, bodies, camera, 1 / secondsPerFrame), film);
        }
    }

    private Path film(PictureDrawing drawing, FilmScene shown, RenderOrder.Film film) throws IOException {
        FrameRange frames = film.frames();
        progress.begin();
        if (FilmFile.isFilm(order.file())) {
            FilmFile file = FilmFile.of(order.file(), System.getenv().getOrDefault("PATH", ""));
            FilmRendering.render(drawing, shown, frames, file, progress);
            return file.file();
        }
        NumberedFiles files = NumberedFiles.of(order.file(), frames);
        FrameRendering.render(drawing, shown, frames, new NumberedPictures(files, order.format()), progress);
        return files.file(frames.first());
    }
}
