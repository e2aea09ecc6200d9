package dev.twister.cli.command;

import dev.twister.cli.file.BadInputException;
import dev.twister.cli.file.ExitCode;
import dev.twister.cli.file.OutputFile;
import dev.twister.cli.file.SizeCheck;
import dev.twister.cli.option.PictureSizeConverter;
import dev.twister.cli.option.Ranges;
import dev.twister.image.HdrWriter;
import dev.twister.image.PictureSize;
import dev.twister.sky.Daylight;
import dev.twister.sky.DaylightSky;
import dev.twister.sky.ShippedSky;
import dev.twister.sky.Skybox;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Optional;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

/** {@code twister sky}: draws a daylight panorama. */
@Command(
        name = "sky",
        description = "Makes a physically based daylight sky, for scenes to use as their skybox.",
        footer = {
            "",
            "Examples:",
            "  twister sky -o evening.hdr --elevation 8 --azimuth 60 --turbidity 4 --sun",
            "  twister sky -o overcast.hdr --preset overcast --size 2048x1024"
        })
final class SkyCommand implements Callable<Integer> {
    private static final double MAX_AZIMUTH_DEGREES = 1e6;
    private static final double MIN_BRIGHTNESS = 0.001;
    private static final long BYTES_PER_TEXEL = 3L * Float.BYTES;

    @Spec
    private CommandSpec spec;

    @Option(
            names = {"-o", "--output"},
            required = true,
            paramLabel = "FILE",
            description = "The panorama, .hdr; - for standard output.")
    private Path output;

    @Option(
            names = "--preset",
            paramLabel = "PRESET",
            defaultValue = "day",
            description = "Defaults of the other options: day, sunset or overcast (default: ${DEFAULT-VALUE}).")
    private ShippedSky preset;

    @Option(names = "--elevation", paramLabel = "DEGREES", description = "Elevation of the sun, 0 to 90.")
    private Optional<Double> elevation = Optional.empty();

    @Option(
            names = "--azimuth",
            paramLabel = "DEGREES",
            description = "Azimuth of the sun: 0 ahead (+z), 90 to the right (+x).")
    private Optional<Double> azimuth = Optional.empty();

    @Option(
            names = "--turbidity",
            paramLabel = "T",
            description = "Haze: 2 very clear, 3 clear, 6 hazy, 10 nearly fog.")
    private Optional<Double> turbidity = Optional.empty();

    @Option(
            names = "--clouds",
            paramLabel = "PART",
            description = "Cloud cover: 0 a clear sky, 1 an even layer that hides the sun.")
    private Optional<Double> clouds = Optional.empty();

    @Option(
            names = "--brightness",
            paramLabel = "RADIANCE",
            description = "The sky's mean luminance, 0.001 to 100; 0.4 gives mid tones at exposure 0.")
    private Optional<Double> brightness = Optional.empty();

    @Option(
            names = "--sun",
            negatable = true,
            description = "Include the sun, a few texels thousands of times brighter than the sky.")
    private Optional<Boolean> sun = Optional.empty();

    @Option(
            names = "--size",
            paramLabel = "SIZE",
            converter = PictureSizeConverter.class,
            defaultValue = ShippedSky.WIDTH + "x" + ShippedSky.HEIGHT,
            description = "Width and height in texels, 1x1 to 16384x8192 (default: ${DEFAULT-VALUE}).")
    private PictureSize size;

    @Override
    public Integer call() throws IOException {
        if (!OutputFile.isStandardOutput(output) && !OutputFile.endsIn(output, ".hdr")) {
            throw new BadInputException("--output is " + output + ", but must end in .hdr, or be -");
        }
        OutputFile.checkBinary("--output", output);
        Ranges.check("--size's height", size.height(), 1, DaylightSky.MAX_HEIGHT);
        Daylight daylight = daylight();
        SizeCheck.check(size, BYTES_PER_TEXEL);
        Skybox sky = DaylightSky.panorama(size.width(), size.height(), daylight);
        HdrWriter.write(output, sky.width(), sky.height(), sky.radiance());
        OutputFile.notes(spec.commandLine(), output)
                .println(OutputFile.name(output) + ": " + sky.width() + " x " + sky.height());
        return ExitCode.OK;
    }

    private Daylight daylight() {
        Daylight usual = preset.daylight();
        return new Daylight(
                Ranges.check(
                        "--elevation",
                        elevation.orElse(usual.sunElevationDegrees()),
                        0,
                        Daylight.MAX_ELEVATION_DEGREES),
                Ranges.check(
                        "--azimuth",
                        azimuth.orElse(usual.sunAzimuthDegrees()),
                        -MAX_AZIMUTH_DEGREES,
                        MAX_AZIMUTH_DEGREES),
                Ranges.check(
                        "--turbidity",
                        turbidity.orElse(usual.turbidity()),
                        Daylight.MIN_TURBIDITY,
                        Daylight.MAX_TURBIDITY),
                Ranges.check("--clouds", clouds.orElse(usual.cloudCover()), 0, 1),
                usual.groundAlbedo(),
                Ranges.check(
                        "--brightness",
                        brightness.orElse(usual.meanSkyRadiance()),
                        MIN_BRIGHTNESS,
                        Daylight.MAX_MEAN_SKY_RADIANCE),
                sun.orElse(usual.sunDisc()));
    }
}
