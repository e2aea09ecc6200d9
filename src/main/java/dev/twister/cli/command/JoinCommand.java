package dev.twister.cli.command;

import dev.twister.cli.file.BadInputException;
import dev.twister.cli.file.ExitCode;
import dev.twister.cli.file.OutputFile;
import dev.twister.cli.file.SizeCheck;
import dev.twister.cli.option.Ranges;
import dev.twister.cli.option.ToneOptions;
import dev.twister.cli.progress.DenoisingNotes;
import dev.twister.denoise.Denoiser;
import dev.twister.denoise.DenoiserOffer;
import dev.twister.denoise.Denoisers;
import dev.twister.files.InputFile;
import dev.twister.image.ExrPicture;
import dev.twister.image.ExrPicture.ExrChannel;
import dev.twister.image.ExrReader;
import dev.twister.image.ExrReader.ExrExtent;
import dev.twister.image.JoinedPicture;
import dev.twister.image.PictureSize;
import dev.twister.render.DenoisedPicture;
import dev.twister.render.PictureLayers;
import dev.twister.render.RelitPicture;
import dev.twister.scene.Rendering;
import dev.twister.scene.Rgb;
import dev.twister.scene.SrgbCurve;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.Callable;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import picocli.CommandLine.Command;
import picocli.CommandLine.ITypeConverter;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;
import picocli.CommandLine.TypeConversionException;

/** {@code twister join}: from parts of a picture to the picture. */
@Command(
        name = "join",
        description = "Joins parts of a picture from 'twister render --tile' or '--sample-range': puts tiles together"
                + " and averages sample ranges.",
        footer = {
            "",
            "Examples:",
            "  twister join tile-1.exr tile-2.exr tile-3.exr -o picture.exr",
            "  twister join samples-*.exr -o picture.png --exposure 1",
            "  twister join samples-*.exr -o picture.exr --denoise",
            "  twister join layers.exr -o evening.png --light sky=0.2 --light lamp=2.5,#ffcc88"
        })
final class JoinCommand implements Callable<Integer> {
    @Spec
    private CommandSpec spec;

    @Parameters(paramLabel = "PART", arity = "1..*", description = "Parts of one picture, .exr files, in any order.")
    private List<Path> parts = List.of();

    @Option(
            names = {"-o", "--output"},
            required = true,
            paramLabel = "FILE",
            description = "The picture: .exr keeps all channels; .hdr and .png keep the colors; - writes a PNG"
                    + " to standard output.")
    private Path output;

    @Option(
            names = "--denoise",
            description = "Remove the noise by the library Open Image Denoise, best of parts rendered with --guides.")
    private boolean denoise;

    @Option(
            names = "--light",
            paramLabel = "NAME=STRENGTH[,COLOR]",
            converter = LightChange.Converter.class,
            description = "Multiply the light of a group of lights by a strength and a color, such as lamp=2.5,#ffcc88."
                    + " The parts were rendered with --light-layers. Repeatable.")
    private List<LightChange> lights = List.of();

    @Mixin
    private ToneOptions tone;

    @Override
    public Integer call() throws IOException {
        LinearPictureFile.check(output);
        tone.over(Rendering.DEFAULT);
        for (Path part : parts) {
            InputFile.problem(part).ifPresent(problem -> {
                throw new BadInputException(part + ": " + problem);
            });
        }
        OutputFile.checkKeeps("--output", output, parts);
        Optional<DenoiserOffer> offer = denoise ? Optional.of(Denoisers.offer()) : Optional.empty();
        offer.ifPresent(DenoiserOffer::check);
        ExrPicture joined = relit(joined());
        ExrPicture picture = offer.map(found -> denoised(joined, found)).orElse(joined);
        tellOfNotFinite(picture);
        LinearPictureFile.write(output, picture, tone);
        OutputFile.notes(spec.commandLine(), output)
                .printf(
                        Locale.ROOT,
                        "%s: %d x %d from %d %s, samples: %s%n",
                        OutputFile.name(output),
                        picture.width(),
                        picture.height(),
                        parts.size(),
                        parts.size() == 1 ? "part" : "parts",
                        picture.provenance().orElseThrow().samples());
        return ExitCode.OK;
    }

    private void tellOfNotFinite(ExrPicture picture) {
        long count = 0;
        for (ExrChannel channel : picture.channels()) {
            // Depth may be infinite.
            boolean color = PictureLayers.COLORS.contains(channel.name());
            for (int i = 0; color && i < picture.width() * picture.rows(); i++) {
                count += Float.isFinite(channel.values()[channel.first() + i * channel.stride()]) ? 0 : 1;
            }
        }
        if (count > 0) {
            spec.commandLine().getErr().println("twister: " + count + " colors of the joined picture are not finite");
        }
    }

    private ExrPicture relit(ExrPicture picture) {
        if (lights.isEmpty()) {
            return picture;
        }
        if (RelitPicture.wasDenoised(picture) && !denoise) {
            spec.commandLine()
                    .getErr()
                    .println("twister: light layers are not denoised; add --denoise to denoise the new picture");
        }
        Map<String, Rgb> factors = new HashMap<>();
        for (LightChange change : lights) {
            if (factors.put(change.group(), change.factor()) != null) {
                throw new BadInputException("--light " + change.group() + " is given twice");
            }
        }
        try {
            return RelitPicture.of(picture, factors);
        } catch (IllegalArgumentException problem) {
            throw new BadInputException(parts.getFirst() + " " + problem.getMessage());
        }
    }

    private ExrPicture denoised(ExrPicture picture, DenoiserOffer offer) {
        try (Denoiser denoiser = offer.opener().get()) {
            DenoisedPicture denoised = DenoisedPicture.of(picture, denoiser);
            DenoisingNotes.print(
                    denoised, parts.getFirst().toString(), spec.commandLine().getErr());
            return denoised.picture();
        } catch (IllegalArgumentException problem) {
            throw new BadInputException(parts.getFirst() + " " + problem.getMessage());
        }
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

    /**
     * A change of the light of a group of lights.
     *
     * @param factor of each channel
     */
    private record LightChange(String group, Rgb factor) {
        /** Reads {@code NAME=STRENGTH}, {@code NAME=STRENGTH,#RRGGBB} or {@code NAME=#RRGGBB}. */
        static final class Converter implements ITypeConverter<LightChange> {
            private static final double MOST = 1e6;
            private static final int HEXADECIMAL = 16;
            private static final int BYTE = 8;
            private static final int LARGEST = 255;
            private static final int WHITE = 0xFFFFFF;
            private static final Pattern TEXT = Pattern.compile("([^=]+)=(\\d+(?:\\.\\d+)?)?,?(?:#([0-9A-Fa-f]{6}))?");

            @Override
            public LightChange convert(String text) {
                Matcher parts = TEXT.matcher(text);
                if (!parts.matches() || text.endsWith("=") || text.endsWith(",")) {
                    throw new TypeConversionException("'" + text
                            + "' is not a light's change; write NAME=STRENGTH, such as lamp=2.5 or lamp=2.5,#ffcc88");
                }
                String group = parts.group(1);
                double strength = parts.group(2) == null
                        ? 1
                        : Ranges.check("the strength of --light " + group, Double.parseDouble(parts.group(2)), 0, MOST);
                int color = parts.group(3) == null ? WHITE : Integer.parseInt(parts.group(3), HEXADECIMAL);
                return new LightChange(
                        group,
                        new Rgb(
                                strength * linear(color >> (2 * BYTE)),
                                strength * linear(color >> BYTE),
                                strength * linear(color)));
            }

            /** The linear value of the lowest byte, which is encoded as sRGB. */
            private static double linear(int value) {
                return SrgbCurve.linear((value & LARGEST) / (double) LARGEST);
            }
        }
    }
}
