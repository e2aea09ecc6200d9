package dev.twister.cli;

import dev.twister.engine.Engine;
import dev.twister.engine.Engines;
import dev.twister.engine.auto.FastestEngine;
import dev.twister.image.PictureSize;
import dev.twister.physics.Simulation;
import dev.twister.scene.RenderSettings;
import dev.twister.scene.Scene;
import dev.twister.scene.SceneReader;
import dev.twister.world.FrameInput;
import dev.twister.world.Picture;
import dev.twister.world.World;
import java.io.IOException;
import java.io.PrintWriter;
import java.io.Writer;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
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
        description = "Draws a scene into a file. What no option says is as the scene has it.",
        footer = {
            "",
            "Examples:",
            "  twister render benchmark -o benchmark.png",
            "  twister render my-scene.json -o large.png --size 4k --samples 16 --tone-map aces",
            "  twister render mirrors -o mirrors.hdr --engine tornado",
            "  twister render metals -o metals.png --noise 0.01",
            "  twister render benchmark -o left.png --camera -12,-6,-10 --yaw 40 --fov 60",
            "  twister render benchmark -o diffuse.png --stage diffuse",
            "  twister render benchmark -o shot.exr --view beauty,normal,depth,albedo",
            "  twister render pour-1000 -o pour-####.png --physics --frames 600 --fps 30",
            "  twister render pour-1000 -o heap.png --physics --start 12"
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
            description = "The picture: .png, or .hdr or .exr for linear radiance; - writes a PNG to standard output.")
    private Path output;

    @Option(
            names = "--size",
            paramLabel = "SIZE",
            converter = PictureSizeConverter.class,
            description = "Such as 1280x720, 1x1 to 16384x16384; or 720p, 1080p, 4k.")
    private Optional<PictureSize> size = Optional.empty();

    @Option(
            names = "--engine",
            paramLabel = "ENGINE",
            completionCandidates = Completions.OfEngine.class,
            defaultValue = FastestEngine.AUTO,
            description = "What draws (see 'twister devices'); ${DEFAULT-VALUE} where not said.")
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

    @Option(
            names = "--frames",
            paramLabel = "N",
            description = "With --physics: render N frames to FILE-0000.png, FILE-0001.png, ...;"
                    + " %%04d or #### in FILE is the place of the number.")
    private Optional<Integer> frames = Optional.empty();

    @Option(names = "--overwrite", description = "With --frames: replace the frames of an earlier run.")
    private boolean overwrite;

    @Override
    public Integer call() throws IOException {
        motion.check(frames);
        samples.check(picture.pictures());
        PictureOutput pictures =
                PictureOutput.of(output, frames, overwrite, picture.pictures().size());
        Path file = SceneFiles.find(sceneName);
        Scene scene = sky.over(SceneReader.read(file));
        pictures.checkKeeps(SkyFiles.inputs(file, scene));
        RenderSettings settings = settings(scene.settings());
        PictureMemory.check(
                new PictureSize(settings.width(), settings.height()), pictures.bytesPerPixel(picture.pictures()));
        World world = SkyFiles.world(scene, spec.commandLine().getErr());
        world.setCamera(camera.over(scene.camera()));
        world.setSettings(settings);
        if (motion.isOn()) {
            drawMoving(scene, world, pictures);
        } else {
            draw(world, pictures);
        }
        return Main.OK;
    }

    private void drawMoving(Scene scene, World world, PictureOutput pictures) throws IOException {
        // A typing error in the name should not come out after minutes of motion.
        Engines.offer(engineId).check();
        try (Simulation simulation = Simulation.of(scene)) {
            motion.begin(simulation, spec.commandLine().getErr());
            simulation.place(world);
            if (frames.isEmpty()) {
                draw(world, pictures);
            } else {
                drawFrames(simulation, world, pictures, frames.get());
            }
        }
    }

    private void drawFrames(Simulation simulation, World world, PictureOutput pictures, int count) throws IOException {
        long start = System.nanoTime();
        try (Engine engine = Engines.open(engineId);
                ProgressLine progress = ProgressLine.start(spec.commandLine().getErr(), engine.id(), count)) {
            for (int number = 0; number < count; number++) {
                simulation.place(world);
                // Its own line of progress would write over that of the frames.
                List<DrawnPicture> drawn = draw(engine, world, pictures, new PrintWriter(Writer.nullWriter()));
                pictures.write(number, drawn, world.settings().srgb());
                simulation.advance(motion.secondsPerFrame());
                progress.step();
            }
        }
        summaryWriter(pictures)
                .printf(
                        Locale.ROOT,
                        "%s: %d frames of %d x %d, %.1f ms each%n",
                        pictures.name(),
                        count,
                        world.settings().width(),
                        world.settings().height(),
                        (System.nanoTime() - start) / NANOS_PER_MILLI / count);
    }

    private void draw(World world, PictureOutput pictures) throws IOException {
        try (Engine engine = Engines.open(engineId)) {
            List<DrawnPicture> drawn =
                    draw(engine, world, pictures, spec.commandLine().getErr());
            pictures.write(0, drawn, world.settings().srgb());
            summaryWriter(pictures)
                    .printf(
                            Locale.ROOT,
                            "%s: %d x %d, %s (%s), %.1f ms%s%n",
                            pictures.name(),
                            world.settings().width(),
                            world.settings().height(),
                            (engineId.equals(FastestEngine.AUTO) ? "auto took " : "") + engine.id(),
                            engine.device(),
                            drawn.stream()
                                            .mapToLong(
                                                    view -> view.frame().times().totalNanos())
                                            .sum()
                                    / NANOS_PER_MILLI,
                            samples.isNoiseGiven() ? samplesOf(drawn.getFirst().drawn()) : "");
        }
    }

    private static String samplesOf(BandedDrawing.Drawn drawn) {
        return drawn.fewestSamples() == drawn.mostSamples()
                ? ", %d samples per pixel".formatted(drawn.mostSamples())
                : ", %d to %d samples per pixel".formatted(drawn.fewestSamples(), drawn.mostSamples());
    }

    /** Draws all that was asked for, one after the other. */
    private List<DrawnPicture> draw(Engine engine, World world, PictureOutput pictures, PrintWriter err) {
        FrameInput input = world.snapshot();
        Sampling sampling = samples.over(world.settings().samplesPerPixel());
        List<DrawnPicture> drawn = new ArrayList<>();
        for (Picture wanted : picture.pictures()) {
            boolean linear = pictures.isLinear() || !wanted.isColor();
            drawn.add(
                    new DrawnPicture(wanted, BandedDrawing.draw(engine, input.showing(wanted), sampling, linear, err)));
        }
        return drawn;
    }

    // What is said must not end up in a picture.
    private PrintWriter summaryWriter(PictureOutput pictures) {
        CommandLine command = spec.commandLine();
        return pictures.isStandardOutput() ? command.getErr() : command.getOut();
    }

    private RenderSettings settings(RenderSettings usual) {
        PictureSize wanted = size.orElseGet(() -> new PictureSize(usual.width(), usual.height()));
        RenderSettings shaded = usual.withSize(wanted.width(), wanted.height())
                .withShadows(shading.shadowSamplesOr(usual.shadowSamples()))
                .withBounces(shading.bouncesOr(usual.bounces()))
                .withSamplesPerPixel(samples.over(usual.samplesPerPixel()).samples());
        return tone.over(shaded);
    }
}
