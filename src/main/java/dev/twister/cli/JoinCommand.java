package dev.twister.cli;

import dev.twister.files.InputFile;
import dev.twister.files.PrintableText;
import dev.twister.image.ExrChannel;
import dev.twister.image.ExrExtent;
import dev.twister.image.ExrPicture;
import dev.twister.image.ExrReader;
import dev.twister.image.ExrWriter;
import dev.twister.image.HdrWriter;
import dev.twister.image.JoinedPicture;
import dev.twister.image.PictureSize;
import dev.twister.image.PngWriter;
import dev.twister.image.Provenance;
import dev.twister.scene.Rendering;
import dev.twister.world.AutoExposure;
import dev.twister.world.TonedPixels;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code twister join}: from parts of a picture to the picture. */
@Command(
        name = "join",
        description = "Joins parts of a picture from 'twister render --tile' or '--sample-range': puts tiles together"
                + " and averages sample ranges.",
        footer = {
            "",
            "Examples:",
            "  twister join tile-1.exr tile-2.exr tile-3.exr -o picture.exr",
            "  twister join samples-*.exr -o picture.png --exposure 1"
        })
final class JoinCommand implements Callable<Integer> {
    private static final int CHANNELS = 3;
    private static final String COLORS = "RGB";

    @Spec
    private CommandSpec spec;

    @Parameters(paramLabel = "PART", arity = "1..*", description = "Parts of one picture, .exr files, in any order.")
    private List<Path> parts = List.of();

    @Option(
            names = {"-o", "--output"},
            required = true,
            paramLabel = "FILE",
            description = "The picture: .exr keeps all channels; .hdr and .png keep the colors.")
    private Path output;

    @Mixin
    private ToneOptions tone;

    @Override
    public Integer call() throws IOException {
        if (List.of(".exr", ".hdr", ".png").stream().noneMatch(ending -> OutputFile.endsIn(output, ending))) {
            throw new BadInputException("--output is " + output + ", but must end in .exr, .hdr or .png");
        }
        Rendering settings = tone.over(Rendering.DEFAULT);
        OutputFile.check("--output", output);
        for (Path part : parts) {
            InputFile.problem(part).ifPresent(problem -> {
                throw new BadInputException(part + ": " + problem);
            });
        }
        OutputFile.checkKeeps("--output", output, parts);
        ExrPicture picture = joined();
        write(picture, settings);
        spec.commandLine()
                .getOut()
                .printf(
                        Locale.ROOT,
                        "%s: %d x %d from %d %s, samples: %s%n",
                        PrintableText.line(output.toString()),
                        picture.width(),
                        picture.height(),
                        parts.size(),
                        parts.size() == 1 ? "part" : "parts",
                        picture.provenance().orElseThrow().samples());
        return ExitCode.OK;
    }

    private ExrPicture joined() throws IOException {
        try {
            List<ExrExtent> extents = new ArrayList<>();
            for (Path part : parts) {
                extents.add(ExrReader.extent(part));
            }
            ExrPicture first = ExrReader.read(parts.getFirst());
            SizeCheck.check(
                    "the picture",
                    new PictureSize(first.width(), first.height()),
                    (Double.BYTES + 2L * Float.BYTES) * first.channels().size());
            JoinedPicture joined = new JoinedPicture(parts.getFirst(), first, extents);
            joined.add(parts.getFirst(), first);
            for (Path part : parts.subList(1, parts.size())) {
                joined.add(part, ExrReader.read(part));
            }
            return joined.whole();
        } catch (IllegalArgumentException problem) {
            throw new BadInputException(problem.getMessage());
        }
    }

    private void write(ExrPicture picture, Rendering settings) throws IOException {
        Provenance made = picture.provenance().orElseThrow();
        if (OutputFile.endsIn(output, ".exr")) {
            ExrWriter.write(output, picture);
        } else if (OutputFile.endsIn(output, ".hdr")) {
            HdrWriter.write(output, picture.width(), picture.height(), radiance(picture), made);
        } else {
            float[] radiance = radiance(picture);
            int[] pixels = TonedPixels.of(
                    radiance, tone.metered(settings, () -> AutoExposure.stops(radiance, settings.srgb())));
            PngWriter.write(output, picture.width(), picture.height(), pixels, settings.srgb(), made);
        }
    }

    private float[] radiance(ExrPicture picture) {
        float[] radiance = new float[CHANNELS * picture.width() * picture.height()];
        for (int color = 0; color < CHANNELS; color++) {
            String name = COLORS.substring(color, color + 1);
            ExrChannel channel = picture.channels().stream()
                    .filter(each -> each.name().equals(name))
                    .findFirst()
                    .orElseThrow(() -> new BadInputException(
                            "the parts have no channel " + name + ", only numbers; give an .exr file as --output"));
            for (int i = 0; i < channel.values().length; i++) {
                radiance[CHANNELS * i + color] = channel.values()[i];
            }
        }
        return radiance;
    }
}
