package dev.twister.cli;

import dev.twister.engine.Engines;
import dev.twister.engine.ExposureMeter;
import dev.twister.engine.auto.FastestEngine;
import dev.twister.files.PrintableText;
import dev.twister.film.FilmFile;
import dev.twister.image.PictureSize;
import dev.twister.motion.MotionFile;
import dev.twister.physics.Simulation;
import dev.twister.render.BandedDrawing;
import dev.twister.render.DrawnPicture;
import dev.twister.render.FilmBodies;
import dev.twister.render.FilmRendering;
import dev.twister.render.FilmScene;
import dev.twister.render.FrameRange;
import dev.twister.render.FrameRendering;
import dev.twister.render.PictureDrawing;
import dev.twister.render.Sampling;
import dev.twister.render.SceneInputs;
import dev.twister.scene.Camera;
import dev.twister.scene.Rendering;
import dev.twister.scene.Scene;
import dev.twister.scene.format.SceneReader;
import dev.twister.world.FrameInput;
import dev.twister.world.Picture;
import dev.twister.world.World;
import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.concurrent.Callable;
import java.util.function.DoubleFunction;
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
            description =
                    "The picture: .png, or .hdr or .exr for linear radiance; - writes a PNG to standard output. A film of"
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
    private ProgressOptions progress;

    @Override
    public Integer call() throws IOException {
        film.check(motion);
        samples.check(picture.pictures());
        part.check(output, samples);
        PictureOutput.checkPlace(output);
        Path file = SceneFiles.find(sceneName);
        Scene scene = sky.over(SceneReader.read(file));
        Optional<MotionFile> recorded = film.open(scene);
        try {
            render(file, scene, recorded);
        } finally {
            if (recorded.isPresent()) {
                recorded.get().close();
            }
        }
        return Main.OK;
    }

    private void render(Path file, Scene scene, Optional<MotionFile> recorded) throws IOException {
        Camera from = camera.over(scene);
        Optional<FrameRange> frames = film.frames(from, motion, recorded, FilmFile.isFilm(output));
        if (frames.isEmpty()) {
            film.checkSingle();
        }
        Rendering settings = settings(scene.rendering());
        part.check(settings.height());
        if (FilmFile.isFilm(output)) {
            checkFilm();
            FilmFile written = FilmOutput.of(output, spec.commandLine().getErr());
            OutputFile.checkKeeps("--output", written.file(), SceneInputs.of(file, scene));
            SizeCheck.check(new PictureSize(settings.width(), settings.height()), FilmRendering.bytesPerPixel());
            draw(scene, settings, from, recorded, true, false, (drawing, shown) -> {
                drawFilm(drawing, shown, frames.orElseThrow(), written);
            });
            return;
        }
        PictureOutput pictures = PictureOutput.of(
                output, frames, film.existing(), picture.pictures().size());
        pictures.checkKeeps(SceneInputs.of(file, scene));
        long kept = frames.isPresent() ? FrameRendering.picturesKept(pictures.isOrdered()) : 1;
        SizeCheck.check(
                new PictureSize(settings.width(), settings.height()),
                kept * pictures.bytesPerPixel(picture.pictures()));
        draw(scene, settings, from, recorded, frames.isPresent(), pictures.isLinear(), (drawing, shown) -> {
            if (frames.isPresent()) {
                drawFrames(drawing, shown, frames.get(), pictures);
            } else {
                drawPicture(drawing, shown.frame(0), pictures);
            }
        });
    }

    /** What is done with a scene in motion. */
    @FunctionalInterface
    private interface Work {
        void draw(PictureDrawing drawing, FilmScene shown) throws IOException;
    }

    private void draw(
            Scene scene,
            Rendering settings,
            Camera from,
            Optional<MotionFile> recorded,
            boolean isFilm,
            boolean linear,
            Work work)
            throws IOException {
        World world = SkyFiles.world(scene, spec.commandLine().getErr());
        world.setSettings(settings);
        Sampling usual = samples.over(settings.samplesPerPixel());
        Sampling sampling = new Sampling(part.samplesOr(usual.samples()), usual.noise());
        DoubleFunction<Camera> cameras = isFilm ? film.camera(scene, from) : _ -> from;
        Work metered = (drawing, shown) -> {
            meter(shown, recorded, linear);
            work.draw(drawing, shown);
        };
        double rate = recorded.map(MotionFile::rate).orElse(1 / motion.secondsPerFrame());
        try (PictureDrawing drawing =
                new PictureDrawing(() -> Engines.open(engineId), picture.pictures(), sampling, part.part(), linear)) {
            if (motion.isOn()) {
                // A typing error in the name should not come out after minutes of motion.
                Engines.offer(engineId).check();
                try (Simulation simulation = Simulation.of(scene, world.meshes())) {
                    motion.begin(simulation, spec.commandLine().getErr());
                    FilmBodies bodies = FilmBodies.simulated(simulation, motion.secondsPerFrame(), () -> {});
                    metered.draw(drawing, new FilmScene(scene, world, bodies, cameras, rate));
                }
            } else {
                FilmBodies bodies = recorded.map(FilmBodies::recorded).orElse(FilmBodies.still());
                metered.draw(drawing, new FilmScene(scene, world, bodies, cameras, rate));
            }
        }
    }

    /** By a film's first frame, whichever frames are drawn: all parts of it are as bright. */
    private void meter(FilmScene shown, Optional<MotionFile> recorded, boolean linear) throws IOException {
        Picture metered = picture.pictures().getFirst();
        if (tone.isMetered() && metered.isColor() && !linear) {
            int first = recorded.isPresent() ? recorded.get().firstFrame() : 0;
            FrameInput input = shown.frame(first).showing(metered);
            World world = shown.world();
            world.setSettings(tone.metered(world.settings(), () -> ExposureMeter.stops(input)));
        }
    }

    private void checkFilm() {
        if (film.skipsExisting() || picture.pictures().size() > 1) {
            throw new BadInputException("--output is " + output + ", a film, which excludes --skip-existing and several"
                    + " views; render frames, and join them by 'twister film'");
        }
    }

    private void drawFilm(PictureDrawing drawing, FilmScene shown, FrameRange frames, FilmFile file)
            throws IOException {
        Rendering settings = shown.world().settings();
        try (ProgressLine line = progress.start(spec.commandLine(), "rendering", frames.count())) {
            FilmRendering.render(drawing, shown, frames, file, new FrameLine(line));
        }
        spec.commandLine()
                .getOut()
                .printf(
                        "%s: %d frames of %d x %d, %s%n",
                        PrintableText.line(file.file().toString()),
                        frames.count(),
                        settings.width(),
                        settings.height(),
                        file.kind());
    }

    private void drawFrames(PictureDrawing drawing, FilmScene shown, FrameRange frames, PictureOutput pictures)
            throws IOException {
        long start = System.nanoTime();
        int skipped;
        try (ProgressLine line = progress.start(spec.commandLine(), "rendering", frames.count())) {
            skipped = FrameRendering.render(drawing, shown, frames, pictures, new FrameLine(line));
        }
        Rendering settings = shown.world().settings();
        summaryWriter(pictures)
                .printf(
                        Locale.ROOT,
                        "%s: %d frames of %d x %d, %.1f ms each%s%n",
                        pictures.name(),
                        frames.count(),
                        settings.width(),
                        settings.height(),
                        (System.nanoTime() - start) / NANOS_PER_MILLI / frames.count(),
                        skipped == 0 ? "" : ", %d of them were there".formatted(skipped));
    }

    private void drawPicture(PictureDrawing drawing, FrameInput input, PictureOutput pictures) throws IOException {
        List<DrawnPicture> drawn;
        try (BandLine line = new BandLine(spec.commandLine().getErr())) {
            drawn = drawing.draw(input, line);
        }
        FrameInput drawnPart = part.part().of(input);
        pictures.write(0, drawn, drawnPart, drawing.provenance(input));
        summaryWriter(pictures)
                .printf(
                        Locale.ROOT,
                        "%s: %d x %d%s, %s (%s), %.1f ms%s%n",
                        pictures.name(),
                        input.width(),
                        input.height(),
                        drawnPart.rows() == input.height()
                                ? ""
                                : ", rows %d to %d"
                                        .formatted(drawnPart.firstRow(), drawnPart.firstRow() + drawnPart.rows() - 1),
                        (engineId.equals(FastestEngine.AUTO) ? "auto took " : "")
                                + drawing.engine().id(),
                        drawing.engine().device(),
                        drawn.stream()
                                        .mapToLong(view -> view.frame().times().totalNanos())
                                        .sum()
                                / NANOS_PER_MILLI,
                        samples.isNoiseGiven() ? samplesOf(drawn.getFirst().drawn()) : "");
    }

    private static String samplesOf(BandedDrawing.Drawn drawn) {
        return drawn.fewestSamples() == drawn.mostSamples()
                ? ", %d samples per pixel".formatted(drawn.mostSamples())
                : ", %d to %d samples per pixel".formatted(drawn.fewestSamples(), drawn.mostSamples());
    }

    // What is said must not end up in a picture.
    private PrintWriter summaryWriter(PictureOutput pictures) {
        CommandLine command = spec.commandLine();
        return pictures.isStandardOutput() ? command.getErr() : command.getOut();
    }

    private Rendering settings(Rendering usual) {
        PictureSize wanted = size.orElseGet(() -> new PictureSize(usual.width(), usual.height()));
        Rendering shaded = usual.withSize(wanted.width(), wanted.height())
                .withShadows(shading.shadowSamplesOr(usual.shadowSamples()))
                .withBounces(shading.bouncesOr(usual.bounces()))
                .withSamplesPerPixel(samples.over(usual.samplesPerPixel()).samples());
        return tone.over(shaded);
    }
}
