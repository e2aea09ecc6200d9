package dev.twister.cli.command;

import dev.twister.cli.file.BadInputException;
import dev.twister.cli.file.ExitCode;
import dev.twister.cli.file.FilmOutput;
import dev.twister.cli.file.ModelFile;
import dev.twister.cli.file.OutputFile;
import dev.twister.cli.file.PictureOutput;
import dev.twister.cli.file.SceneFiles;
import dev.twister.cli.file.SizeCheck;
import dev.twister.cli.file.SkyFiles;
import dev.twister.cli.option.CameraOptions;
import dev.twister.cli.option.Completions;
import dev.twister.cli.option.DenoisingOptions;
import dev.twister.cli.option.FilmOptions;
import dev.twister.cli.option.ModelOptions;
import dev.twister.cli.option.MotionOptions;
import dev.twister.cli.option.PartOptions;
import dev.twister.cli.option.PictureOptions;
import dev.twister.cli.option.PictureSizeConverter;
import dev.twister.cli.option.SampleOptions;
import dev.twister.cli.option.ShadingOptions;
import dev.twister.cli.option.SkyOptions;
import dev.twister.cli.option.ToneOptions;
import dev.twister.cli.progress.ProgressOptions;
import dev.twister.cli.progress.RenderLine;
import dev.twister.engine.Engines;
import dev.twister.engine.auto.FastestEngine;
import dev.twister.files.PrintableText;
import dev.twister.film.FilmFile;
import dev.twister.image.PictureSize;
import dev.twister.motion.MotionFile;
import dev.twister.render.Background;
import dev.twister.render.ExistingFrames;
import dev.twister.render.Finishing;
import dev.twister.render.FrameRange;
import dev.twister.render.PictureFormat;
import dev.twister.render.RenderOrder;
import dev.twister.render.RenderOrder.Movement;
import dev.twister.render.RenderOutput;
import dev.twister.render.RenderResult;
import dev.twister.render.Renderer;
import dev.twister.render.Renderer.BlackPictureException;
import dev.twister.render.Sampling;
import dev.twister.render.SceneInputs;
import dev.twister.scene.CameraKeyframe;
import dev.twister.scene.Rendering;
import dev.twister.scene.Scene;
import dev.twister.scene.select.VisibleBodies;
import dev.twister.world.Animation;
import dev.twister.world.FrameInput;
import dev.twister.world.SceneMeshes;
import dev.twister.world.World;
import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.concurrent.Callable;
import java.util.function.Consumer;
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
        description = "Renders a scene or a mesh file to a picture. Options override the scene's own settings. A mesh"
                + " stands on the checkered plane under the day sky, as in 'twister view'.",
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
            "  twister render metals -o tile-2.exr --size 4k --samples 256 --tile 2/7",
            "  twister render fox.glb -o fox.mp4 --animation Walk --fps 30",
            "  twister render model.glb -o thumbnail.png --size 512x512 --background none",
            "  twister render 'scans/*.ply' -o pictures --up z"
        })
final class RenderCommand implements Callable<Integer> {
    private static final double NANOS_PER_MILLI = 1e6;

    @Spec
    private CommandSpec spec;

    @Parameters(
            paramLabel = "SCENE",
            completionCandidates = Completions.OfScene.class,
            description =
                    "A scene file, the name of a shipped scene, - for a scene from standard input, or a mesh file:"
                            + " OBJ, glTF, GLB, PLY or STL. Also a folder of mesh files, or a pattern such as"
                            + " 'models/*.glb'; then FILE is the folder of their pictures.")
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

    @Option(
            names = "--background",
            paramLabel = "BACKGROUND",
            description = "sky (the default), or none: a .png, .exr or .apng is transparent where there is no body, and"
                    + " a mesh file has no floor.")
    private Background background = Background.SKY;

    @Mixin
    private ModelOptions model;

    @Mixin
    private SampleOptions samples;

    @Mixin
    private ShadingOptions shading;

    @Mixin
    private ToneOptions tone;

    @Mixin
    private PictureOptions views;

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
        samples.check(views.pictures());
        if (background == Background.NONE && views.pictures().stream().noneMatch(Finishing::isFull)) {
            throw new BadInputException("--background none needs the full picture; add the view beauty, or leave"
                    + " --stage and --view out");
        }
        part.check(output, samples, views.pictures().size());
        denoising.check(output, views.pictures(), part);
        Optional<List<Path>> several = SeveralFiles.of(sceneName);
        if (several.isPresent()) {
            return renderAll(several.get());
        }
        PictureOutput.checkPlace(output);
        render(SceneFiles.find(sceneName), output);
        return ExitCode.OK;
    }

    /** Goes on after failures. */
    private int renderAll(List<Path> files) throws IOException {
        if (PictureFormat.of(output).isPresent() || FilmFile.isFilm(output) || OutputFile.isStandardOutput(output)) {
            throw new BadInputException("--output is " + output + ", but " + sceneName
                    + " are several files; give the folder of their pictures");
        }
        Files.createDirectories(output);
        CommandLine command = spec.commandLine();
        List<String> pictures = SeveralFiles.pictures(files);
        List<String> lines = new ArrayList<>();
        int failures = 0;
        for (int index = 0; index < files.size(); index++) {
            Path file = files.get(index);
            String result = pictures.get(index);
            try {
                render(file, output.resolve(result));
            } catch (IOException | RuntimeException failure) {
                failures++;
                Failures.explain(failure, command, command.getParseResult());
                result = "failed: " + failure.getMessage();
            }
            lines.add(PrintableText.line(file.getFileName() + " -> " + result));
        }
        PrintWriter out = command.getOut();
        out.printf("%nPictures in %s: %d, failed: %d%n", output, files.size() - failures, failures);
        lines.forEach(line -> out.println("  " + line));
        return failures == 0 ? ExitCode.OK : ExitCode.BAD_INPUT;
    }

    private void render(Path file, Path picture) throws IOException {
        Consumer<String> warnings = SkyFiles.warnings(spec.commandLine().getErr());
        Optional<ModelFile> mesh = ModelFile.isNamed(file) ? Optional.of(model(file, warnings)) : Optional.empty();
        if (mesh.isEmpty() && model.areGiven()) {
            throw new BadInputException(
                    "--up, --rotate, --scene and --animation are for mesh files, but " + file + " is a scene");
        }
        Scene scene = mesh.isPresent()
                ? mesh.get().under(sky.over(mesh.get().scene()).sky())
                : sky.over(VisibleBodies.of(SceneFiles.read(file)));
        // A camera of the model's file carries the view that is asked for.
        List<CameraKeyframe> path =
                mesh.flatMap(shown -> camera.viewAlone().map(shown::path)).orElse(List.of());
        Scene seen = scene.withCamera(
                path.isEmpty() ? camera.over(scene) : camera.over(scene).withKeyframes(path));
        PrintWriter err = spec.commandLine().getErr();
        Optional<MotionFile> recorded = film.open(scene);
        try {
            // The length of a film depends on animations; otherwise options are checked before long files are read.
            Optional<SceneMeshes> meshes = mesh.map(ModelFile::meshes)
                    .or(() -> Optional.of(scene).filter(Animation::isOfMeshes).map(read -> SkyFiles.meshes(read, err)));
            RenderOrder order = order(seen, meshes.orElse(SceneMeshes.NONE), picture, recorded);
            PictureOutput.checkKeeps(order.output(), SceneInputs.of(file, scene));
            SizeCheck.check(order.size(), Renderer.bytesPerPixel(order));
            Scene shown = order.scene();
            render(order, SkyFiles.world(shown, meshes.orElseGet(() -> SkyFiles.meshes(shown, err)), err));
        } finally {
            if (recorded.isPresent()) {
                recorded.get().close();
            }
        }
    }

    private ModelFile model(Path file, Consumer<String> warnings) {
        ModelFile read =
                ModelFile.read(file, model.scene(), model.pose(), warnings).forPictures();
        return background == Background.NONE ? read.withoutPlane() : read;
    }

    private RenderOrder order(Scene scene, SceneMeshes meshes, Path picture, Optional<MotionFile> recorded)
            throws IOException {
        Rendering settings = settings(scene.rendering());
        Scene shown = tone.fixed(camera.fixed(scene)).withRendering(settings);
        Optional<FrameRange> frames = film.frames(shown, meshes, motion, recorded, picture);
        if (frames.isEmpty()) {
            film.checkSingle(motion);
        }
        part.check(settings.height());
        Sampling usual = samples.over(settings.samplesPerPixel());
        int samples = part.samplesOr(usual.samples());
        Movement movement = film.movement(shown, motion, recorded, frames.isPresent());
        if (movement.isBlurred() && samples == 1) {
            spec.commandLine()
                    .getErr()
                    .println("twister: a shutter needs several samples per pixel, but there is 1, which shows one"
                            + " moment; give --samples 16 or more");
        }
        return new RenderOrder(
                shown,
                Engines.offer(engineId),
                views.pictures(),
                new Sampling(samples, usual.noise()),
                part.part(),
                movement,
                denoising.finishing(tone.isMetered()),
                output(picture, frames));
    }

    private RenderOutput output(Path picture, Optional<FrameRange> frames) {
        if (FilmFile.isFilm(picture)) {
            checkFilm();
            Path written = FilmOutput.of(picture, spec.commandLine().getErr()).file();
            return new RenderOutput(written, frames, ExistingFrames.REPLACED, background);
        }
        return PictureOutput.of(picture, frames, film.existing(), views.pictures(), background);
    }

    private void checkFilm() {
        if (film.skipsExisting() || views.pictures().size() > 1) {
            throw new BadInputException("--output is " + output + ", a film, which excludes --skip-existing"
                    + " and several views; render frames, and join them by 'twister film'");
        }
        if (background == Background.NONE && !OutputFile.endsIn(output, ".apng")) {
            throw new BadInputException("--output is " + output + ", but a film with --background none needs an .apng"
                    + " file, or numbered frames");
        }
    }

    private void render(RenderOrder order, World world) throws IOException {
        CommandLine command = spec.commandLine();
        RenderResult result;
        long nanos;
        try (RenderLine line = new RenderLine(command, progress, order.output().frames())) {
            result = Renderer.render(order, world, line);
            nanos = line.nanos();
        } catch (BlackPictureException black) {
            throw new BadInputException("--exposure is auto, but " + black.getMessage() + "; give a number of stops");
        }
        PrintWriter notes = OutputFile.notes(command, order.output().file());
        notes.println(PictureOutput.name(order.output()) + ": " + summary(order, result, nanos));
    }

    private String summary(RenderOrder order, RenderResult result, long nanos) {
        String samples = samplesOf(order, result.samples());
        if (result.picture().isPresent()) {
            return summary(order, result.picture().get(), samples);
        }
        int frames = order.output().range().count();
        String size = frames + " frames of " + sides(order);
        if (order.output().isFilm()) {
            return size + ", " + FilmFile.of(order.output().file()).kind() + samples;
        }
        return String.format(
                Locale.ROOT,
                "%s, %.1f ms each%s%s",
                size,
                nanos / NANOS_PER_MILLI / frames,
                result.kept() == 0 ? "" : ", %d kept".formatted(result.kept()),
                samples);
    }

    private String summary(RenderOrder order, RenderResult.Single picture, String samples) {
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
                samples);
    }

    private static String sides(RenderOrder order) {
        return order.size().width() + " x " + order.size().height();
    }

    /** Empty without a noise bound, or if all frames were kept. */
    private static String samplesOf(RenderOrder order, RenderResult.Samples samples) {
        if (samples.pixels() == 0 || order.sampling().noise().isEmpty()) {
            return "";
        }
        double bound = order.sampling().noise().get();
        return String.format(
                Locale.ROOT,
                ", %s samples per pixel, noise %.2g%s",
                samples.fewest() == samples.most()
                        ? "%.0f".formatted(samples.most())
                        : String.format(
                                Locale.ROOT,
                                "%.0f to %.0f, on average %.0f,",
                                samples.fewest(),
                                samples.most(),
                                samples.average()),
                samples.noise(),
                samples.noise() > bound ? "; raise --samples to reach " + bound : "");
    }

    private Rendering settings(Rendering usual) {
        PictureSize wanted = size.orElseGet(() -> camera.sizeOr(new PictureSize(usual.width(), usual.height())));
        Rendering shaded = shading.over(usual)
                .withSize(wanted.width(), wanted.height())
                .withSamplesPerPixel(samples.over(usual.samplesPerPixel()).samples());
        return tone.over(film.over(shaded));
    }
}
