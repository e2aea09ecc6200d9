package dev.twister.cli;

import dev.twister.engine.Engines;
import dev.twister.engine.auto.FastestEngine;
import dev.twister.film.FilmFile;
import dev.twister.image.PictureSize;
import dev.twister.motion.MotionFile;
import dev.twister.render.BandedDrawing;
import dev.twister.render.BlackPictureException;
import dev.twister.render.ExistingFrames;
import dev.twister.render.FrameRange;
import dev.twister.render.RenderOrder;
import dev.twister.render.RenderOutput;
import dev.twister.render.RenderResult;
import dev.twister.render.Renderer;
import dev.twister.render.Sampling;
import dev.twister.render.SceneInputs;
import dev.twister.scene.Camera;
import dev.twister.scene.Rendering;
import dev.twister.scene.Scene;
import dev.twister.scene.format.SceneReader;
import dev.twister.world.FrameInput;
import dev.twister.world.World;
import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Optional;
import java.util.concurrent.Callable;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code twister render}: from a scene to a picture. */
@Command(
        name = "render",
        description = "Renders a scene to a file. Options override the scene's own settings.",
        footer = {
            "",
            "Examples:",
            "  twister render benchmark -o benchmark.png",
            "  twister render my-scene.json -o large.png --size 4k --samples 16 --tone-map aces",
            "  twister render mirrors -o mirrors.hdr --engine tornado",
            "  twister render metals -o metals.png --noise 0.01 --exposure auto",
            "  twister render cornell -o cornell.png --samples 16 --denoise",
            "  twister render benchmark -o left.png --camera -12,-6,-10 --yaw 40 --fov 60",
            "  twister render benchmark -o diffuse.png --stage diffuse",
            "  twister render benchmark -o shot.exr --view beauty,normal,depth,albedo",
            "  twister render pour-1000 -o pour-####.png --physics --frames 600 --fps 30",
            "  twister render pour-1000 -o heap.png --physics --start 12",
            "  twister render pour-1000 -o 'shot/f-####.png' --motion pour.motion --frames 240-299 --skip-existing",
            "  twister render benchmark -o turn.mp4 --turntable 10",
            "  twister render metals -o tile-2.exr --size 4k --samples 256 --tile 2/7"
        })
final class RenderCommand implements Callable<Integer> {
    private static final double NANOS_PER_MILLI = 1e6;

    @Spec
    private CommandSpec spec;

    @Parameters(
            paramLabel = "SCENE",
            completionCandidates = Completions.OfScene.class,
            description = "A scene file, or the name of a shipped scene.")
    private String sceneName;

    @Option(
            names = {"-o", "--output"},
            required = true,
            paramLabel = "FILE",
            description = "The picture: .png, or .hdr or .exr for linear radiance; - writes a PNG to standard output. A"
                    + " film of"
                    + " frames: .mp4 (needs ffmpeg) or .apng.")
    private Path output;

    @Option(
            names = "--size",
            paramLabel = "SIZE",
            converter = PictureSizeConverter.class,
            description = "Size of the picture, 1x1 to 16384x16384, such as 1280x720; or 720p, 1080p, 4k.")
    private Optional<PictureSize> size = Optional.empty();

    @Option(
            names = "--engine",
            paramLabel = "ENGINE",
            completionCandidates = Completions.OfEngine.class,
            defaultValue = FastestEngine.AUTO,
            description = "The engine that renders, see 'twister devices' (default: ${DEFAULT-VALUE}).")
    private String engineId;

    @Mixin
    private SampleOptions samples;

    @Mixin
    private ShadingOptions shading;

    @Mixin
    private ToneOptions tone;

    @Mixin
    private PictureOptions picture;

    @Mixin
    private CameraOptions camera;

    @Mixin
    private SkyOptions sky;

    @Mixin
    private MotionOptions motion;

    @Mixin
    private FilmOptions film;

    @Mixin
    private PartOptions part;

    @Mixin
    private DenoisingOptions denoising;

    @Mixin
    private ProgressOptions progress;

    @Override
    public Integer call() throws IOException {
        film.check(motion);
        samples.check(picture.pictures());
        part.check(output, samples, picture.pictures().size());
        denoising.check(output, picture.pictures(), part);
        PictureOutput.checkPlace(output);
        Path file = SceneFiles.find(sceneName);
        Scene scene = sky.over(SceneReader.read(file));
        Optional<MotionFile> recorded = film.open(scene);
        try {
            RenderOrder order = order(scene, recorded);
            PictureOutput.checkKeeps(order.output(), SceneInputs.of(file, scene));
            SizeCheck.check(order.size(), Renderer.bytesPerPixel(order));
            render(order);
        } finally {
            if (recorded.isPresent()) {
                recorded.get().close();
            }
        }
        return ExitCode.OK;
    }

    private RenderOrder order(Scene scene, Optional<MotionFile> recorded) throws IOException {
        Camera from = camera.over(scene);
        Optional<FrameRange> frames = film.frames(from, motion, recorded, FilmFile.isFilm(output));
        if (frames.isEmpty()) {
            film.checkSingle();
        }
        Rendering settings = settings(scene.rendering());
        part.check(settings.height());
        Sampling usual = samples.over(settings.samplesPerPixel());
        return new RenderOrder(
                scene.withCamera(from).withRendering(settings),
                Engines.offer(engineId),
                picture.pictures(),
                new Sampling(part.samplesOr(usual.samples()), usual.noise()),
                part.part(),
                film.movement(scene, from, motion, recorded, frames.isPresent()),
                denoising.finishing(tone.isMetered()),
                output(frames));
    }

    private RenderOutput output(Optional<FrameRange> frames) {
        if (FilmFile.isFilm(output)) {
            checkFilm();
            Path written = FilmOutput.of(output, spec.commandLine().getErr()).file();
            return new RenderOutput(written, frames, ExistingFrames.REPLACED);
        }
        return PictureOutput.of(
                output, frames, film.existing(), picture.pictures().size());
    }

    private void checkFilm() {
        if (film.skipsExisting() || picture.pictures().size() > 1) {
            throw new BadInputException("--output is " + output + ", a film, which excludes --skip-existing and several"
                    + " views; render frames, and join them by 'twister film'");
        }
    }

    private void render(RenderOrder order) throws IOException {
        CommandLine command = spec.commandLine();
        World world = SkyFiles.world(order.scene(), command.getErr());
        RenderResult result;
        long nanos;
        try (RenderLine line = new RenderLine(command, progress, order.output().frames())) {
            result = Renderer.render(order, world, line);
            nanos = line.nanos();
        } catch (BlackPictureException black) {
            throw new BadInputException("--exposure is auto, but " + black.getMessage() + "; give a number of stops");
        }
        // The summary must not end up in a picture.
        PrintWriter summary = order.output().isStandardOutput() ? command.getErr() : command.getOut();
        summary.println(PictureOutput.name(order.output()) + ": " + summary(order, result, nanos));
    }

    private String summary(RenderOrder order, RenderResult result, long nanos) {
        if (result.picture().isPresent()) {
            return summary(order, result.picture().get());
        }
        int frames = order.output().range().count();
        String size = frames + " frames of " + sides(order);
        if (order.output().isFilm()) {
            return size + ", " + FilmFile.of(order.output().file()).kind();
        }
        return String.format(
                Locale.ROOT,
                "%s, %.1f ms each%s",
                size,
                nanos / NANOS_PER_MILLI / frames,
                result.kept() == 0 ? "" : ", %d kept".formatted(result.kept()));
    }

    private String summary(RenderOrder order, RenderResult.Single picture) {
        FrameInput drawn = picture.part();
        String rows = drawn.rows() == drawn.height()
                ? ""
                : ", rows %d to %d".formatted(drawn.firstRow(), drawn.firstRow() + drawn.rows() - 1);
        double millis = picture.drawn().stream()
                        .mapToLong(view -> view.frame().times().totalNanos())
                        .sum()
                / NANOS_PER_MILLI;
        return String.format(
                Locale.ROOT,
                "%s%s, %s%s (%s), %.1f ms%s",
                sides(order),
                rows,
                engineId.equals(FastestEngine.AUTO) ? "auto took " : "",
                picture.engine(),
                picture.device(),
                millis,
                order.sampling()
                        .noise()
                        .map(bound -> samplesOf(picture.drawn().getFirst().drawn(), bound))
                        .orElse(""));
    }

    private static String sides(RenderOrder order) {
        return order.size().width() + " x " + order.size().height();
    }

    private static String samplesOf(BandedDrawing.Drawn drawn, double bound) {
        double fewest = Double.MAX_VALUE;
        double most = 0;
        double sum = 0;
        for (float samples : drawn.samples()) {
            fewest = Math.min(fewest, samples);
            most = Math.max(most, samples);
            sum += samples;
        }
        return String.format(
                Locale.ROOT,
                ", %s samples per pixel, noise %.2g%s",
                fewest == most
                        ? "%.0f".formatted(most)
                        : String.format(
                                Locale.ROOT,
                                "%.0f to %.0f, on average %.0f,",
                                fewest,
                                most,
                                sum / drawn.samples().length),
                drawn.noise(),
                drawn.noise() > bound ? "; raise --samples to reach " + bound : "");
    }

    private Rendering settings(Rendering usual) {
        PictureSize wanted = size.orElseGet(() -> new PictureSize(usual.width(), usual.height()));
        Rendering shaded = shading.over(usual)
                .withSize(wanted.width(), wanted.height())
                .withSamplesPerPixel(samples.over(usual.samplesPerPixel()).atOnce());
        return tone.over(shaded);
    }
}
