package dev.twister.cli.option;

import dev.twister.cli.file.BadInputException;
import dev.twister.cli.file.OutputFile;
import dev.twister.render.PicturePart;
import dev.twister.render.PicturePart.Samples;
import dev.twister.render.PicturePart.Tile;
import dev.twister.render.Sampling;
import dev.twister.scene.Rendering;
import java.nio.file.Path;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import picocli.CommandLine.ITypeConverter;
import picocli.CommandLine.Option;
import picocli.CommandLine.TypeConversionException;

/** Options that limit rendering to a part of a picture, for {@code twister join}. */
public final class PartOptions {
    @Option(
            names = "--tile",
            paramLabel = "K/N",
            converter = TileConverter.class,
            description = "Render the rows of tile K of N, from the top, to an .exr file for 'twister join'.")
    private Optional<Tile> tile = Optional.empty();

    @Option(
            names = "--sample-range",
            paramLabel = "A-B",
            converter = SamplesConverter.class,
            description = "Render samples A to B of each pixel, counted from 0, to an .exr file for 'twister join'."
                    + " Ranges from 0 to N-1 joined are --samples N, where N is even.")
    private Optional<Samples> samples = Optional.empty();

    /** Reads {@code K/N}. */
    static final class TileConverter implements ITypeConverter<Tile> {
        private static final Pattern TEXT = Pattern.compile("(\\d{1,9})/(\\d{1,9})");

        @Override
        public Tile convert(String text) {
            Matcher parts = TEXT.matcher(text);
            if (!parts.matches()) {
                throw new TypeConversionException("'" + text + "' is not a tile; write K/N, such as 2/7");
            }
            int count = Ranges.check(
                    "the number of tiles of --tile", Integer.parseInt(parts.group(2)), 1, Rendering.MAX_SIDE);
            return new Tile(Ranges.check("--tile", Integer.parseInt(parts.group(1)), 1, count), count);
        }
    }

    /** Reads {@code A-B}. */
    static final class SamplesConverter implements ITypeConverter<Samples> {
        private static final int MOST = 1_000_000;
        private static final Pattern TEXT = Pattern.compile("(\\d{1,9})-(\\d{1,9})");

        @Override
        public Samples convert(String text) {
            Matcher parts = TEXT.matcher(text);
            if (!parts.matches()) {
                throw new TypeConversionException(
                        "'" + text + "' is not a range of samples; write the first and the last one, such as 0-63");
            }
            int first = Ranges.check("--sample-range", Integer.parseInt(parts.group(1)), 0, MOST);
            int most = first + Rendering.MAX_SAMPLES_PER_PIXEL - 1;
            int last = Ranges.check("the last sample of --sample-range", Integer.parseInt(parts.group(2)), first, most);
            return new Samples(first, last);
        }
    }

    public boolean areGiven() {
        return tile.isPresent() || samples.isPresent();
    }

    /** Rejects options that exclude parts. */
    public void check(Path output, SampleOptions sampling, int pictures) {
        if (!areGiven()) {
            return;
        }
        if (!OutputFile.endsIn(output, ".exr")) {
            throw new BadInputException("--output is " + output
                    + ", but --tile and --sample-range need an .exr file, which keeps all digits for 'twister join'");
        }
        if (samples.isPresent() && sampling.isGiven()) {
            throw new BadInputException("--samples and --sample-range exclude each other; give one of them");
        }
        samples.filter(range -> sampling.isNoiseGiven() && range.count() < Sampling.LEAST_CONVERGING)
                .ifPresent(range -> {
                    throw new BadInputException("--sample-range has " + range.count() + " samples, but --noise needs "
                            + Sampling.LEAST_CONVERGING + " or more");
                });
        if (sampling.isNoiseGiven() && pictures > 1) {
            throw new BadInputException(
                    "--noise with --tile or --sample-range needs one picture; --view has " + pictures);
        }
    }

    /** Rejects more tiles than rows. */
    public void check(int height) {
        tile.ifPresent(part -> Ranges.check("the number of tiles of --tile", part.count(), 1, height));
    }

    /** The part to render. */
    public PicturePart part() {
        return new PicturePart(tile, samples);
    }

    /** Number of samples per pixel. */
    public int samplesOr(int usual) {
        return samples.map(Samples::count).orElse(usual);
    }
}
