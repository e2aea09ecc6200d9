package dev.twister.cli.command;

import dev.twister.cli.file.ExitCode;
import dev.twister.cli.file.SceneFiles;
import dev.twister.cli.file.SkyFiles;
import dev.twister.cli.option.CameraOptions;
import dev.twister.cli.option.Completions;
import dev.twister.cli.option.PictureSizeConverter;
import dev.twister.cli.option.Ranges;
import dev.twister.cli.option.ShadingOptions;
import dev.twister.cli.option.SkyOptions;
import dev.twister.cli.option.ToneOptions;
import dev.twister.engine.ExposureMeter;
import dev.twister.explain.BodyNames;
import dev.twister.explain.PathJson;
import dev.twister.explain.PathText;
import dev.twister.explain.PixelPath;
import dev.twister.image.PictureSize;
import dev.twister.scene.Rendering;
import dev.twister.scene.Scene;
import dev.twister.scene.select.VisibleBodies;
import dev.twister.world.FrameInput;
import dev.twister.world.World;
import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.Optional;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.ITypeConverter;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;
import picocli.CommandLine.TypeConversionException;

/** {@code twister explain}: how a pixel comes about. */
@Command(
        name = "explain",
        description =
                "Prints the path of a pixel's rays: what each of them meets, the numbers of the equation there, and"
                        + " what it adds to the pixel. Options override the scene's own settings.",
        footer = {
            "",
            "Examples:",
            "  twister explain teaching --pixel 640,360",
            "  twister explain glass --pixel 640,400 --samples 8 --sample 3 --json",
            "  twister explain weekend --pixel 600,400 --samples 16 --sample 5",
            "  twister explain teaching --pixel 160,90 --size 320x180 --shadow-samples 1 --bounces 0"
        })
final class ExplainCommand implements Callable<Integer> {
    @Spec
    private CommandSpec spec;

    @Parameters(
            paramLabel = "SCENE",
            completionCandidates = Completions.OfScene.class,
            description = "A scene file, the name of a shipped scene, or - for standard input.")
    private String sceneName;

    @Option(
            names = "--pixel",
            required = true,
            paramLabel = "X,Y",
            converter = PixelConverter.class,
            description = "Column and row; 0,0 is the pixel at the top left.")
    private PixelConverter.Pixel pixel;

    @Option(names = "--sample", paramLabel = "N", description = "Index of the pixel's sample, from 0 (default: 0).")
    private int sample;

    @Option(
            names = "--samples",
            paramLabel = "N",
            description = "View rays per pixel, 1 to " + Rendering.MAX_SAMPLES_PER_PIXEL + ".")
    private Optional<Integer> samples = Optional.empty();

    @Option(
            names = "--size",
            paramLabel = "SIZE",
            converter = PictureSizeConverter.class,
            description = "Size of the picture, such as 1280x720 or 720p, 1080p, 4k.")
    private Optional<PictureSize> size = Optional.empty();

    @Option(names = "--json", description = "Print JSON, with every shadow ray.")
    private boolean json;

    @Mixin
    private ShadingOptions shading;

    @Mixin
    private ToneOptions tone;

    @Mixin
    private CameraOptions camera;

    @Mixin
    private SkyOptions sky;

    @Override
    public Integer call() {
        Path file = SceneFiles.find(sceneName);
        Scene read = SceneFiles.read(file);
        Scene scene = sky.over(VisibleBodies.of(read));
        Rendering settings = settings(scene.rendering());
        Ranges.check("--pixel's column", pixel.column(), 0, settings.width() - 1);
        Ranges.check("--pixel's row", pixel.row(), 0, settings.height() - 1);
        Ranges.check("--sample", sample, 0, settings.samplesPerPixel() - 1);
        World world = SkyFiles.world(scene, spec.commandLine().getErr());
        world.setCamera(camera.over(scene));
        world.setSettings(settings);
        world.setSettings(tone.metered(settings, () -> ExposureMeter.stops(world.snapshot())));
        FrameInput input = world.snapshot();
        PixelPath path = PixelPath.of(input, pixel.column(), pixel.row(), sample);
        BodyNames names = new BodyNames(read, file.toAbsolutePath().resolveSibling(""), world.meshes(), input);
        PrintWriter out = spec.commandLine().getOut();
        if (json) {
            out.println(PathJson.of(path, names));
        } else {
            out.print(PathText.of(path, names));
            out.flush();
        }
        return ExitCode.OK;
    }

    private Rendering settings(Rendering usual) {
        PictureSize wanted = size.orElseGet(() -> new PictureSize(usual.width(), usual.height()));
        Rendering shaded = shading.over(usual)
                .withSize(wanted.width(), wanted.height())
                .withSamplesPerPixel(Ranges.check(
                        "--samples", samples.orElse(usual.samplesPerPixel()), 1, Rendering.MAX_SAMPLES_PER_PIXEL));
        return tone.over(shaded);
    }

    /** Reads pixels such as {@code 640,360}. */
    private static final class PixelConverter implements ITypeConverter<PixelConverter.Pixel> {
        /** Column and row, from 0 at the top left. */
        record Pixel(int column, int row) {}

        @Override
        public Pixel convert(String text) {
            String[] parts = text.split(",", -1);
            if (parts.length != 2) {
                throw malformed(text);
            }
            try {
                return new Pixel(Integer.parseInt(parts[0].strip()), Integer.parseInt(parts[1].strip()));
            } catch (NumberFormatException _) {
                throw malformed(text);
            }
        }

        private static TypeConversionException malformed(String text) {
            return new TypeConversionException(
                    "'" + text + "' is not a pixel; write column,row from 0,0 at the top left, such as 640,360");
        }
    }
}
