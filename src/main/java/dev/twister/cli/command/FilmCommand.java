package dev.twister.cli.command;

import dev.twister.cli.file.BadInputException;
import dev.twister.cli.file.ExitCode;
import dev.twister.cli.file.FilmOutput;
import dev.twister.cli.file.OutputFile;
import dev.twister.cli.file.PictureOutput.FrameNames;
import dev.twister.cli.option.FrameRangeConverter;
import dev.twister.cli.option.MotionOptions;
import dev.twister.cli.progress.ProgressLine;
import dev.twister.cli.progress.ProgressOptions;
import dev.twister.files.PrintableText;
import dev.twister.film.EncodedPixels;
import dev.twister.film.FilmFile;
import dev.twister.film.FilmFormat;
import dev.twister.film.FilmWriting;
import dev.twister.image.PictureSize;
import dev.twister.image.PngNotes;
import dev.twister.render.FrameRange;
import dev.twister.render.NumberedFiles;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.SortedMap;
import java.util.concurrent.Callable;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import javax.imageio.ImageIO;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code twister film}: from numbered pictures to a film. */
@Command(
        name = "film",
        description =
                "Makes a film from numbered PNG files: H.264 if ffmpeg is on the PATH, otherwise an animated PNG.",
        footer = {
            "",
            "Examples:",
            "  twister film 'shot/f-####.png' -o shot.mp4 --fps 60",
            "  twister film 'shot/f-####.png' -o part.apng --frames 240-299"
        })
final class FilmCommand implements Callable<Integer> {
    private static final int MOST_NAMED = 5;

    @Spec
    private CommandSpec spec;

    @Parameters(
            paramLabel = "FILES",
            description = "Name of the pictures; %%04d or #### stands for their number, as in 'twister render'.")
    private Path pattern;

    @Option(
            names = {"-o", "--output"},
            required = true,
            paramLabel = "FILE",
            description = "The film: .mp4 or .apng.")
    private Path output;

    @Option(
            names = "--frames",
            paramLabel = "RANGE",
            converter = FrameRangeConverter.class,
            description = "N: frames 0 to N-1; A-B: frames A to B. Default: all frames found.")
    private Optional<FrameRange> frames = Optional.empty();

    @Option(names = "--fps", paramLabel = "FPS", description = "Frames per second (default: 60).")
    private Optional<Double> rate = Optional.empty();

    @Mixin
    private ProgressOptions progress;

    @Override
    public Integer call() throws IOException {
        double framesPerSecond = MotionOptions.checkRate(rate);
        if (!FilmFile.isFilm(output)) {
            throw new BadInputException("--output is " + output + ", but must end in .mp4 or .apng");
        }
        if (!OutputFile.endsIn(pattern, ".png")) {
            throw new BadInputException("FILES is " + pattern + ", but must end in .png");
        }
        List<Path> pictures = pictures();
        PictureSize size = PngNotes.of(pictures.getFirst()).size();
        FilmFile film = FilmOutput.of(output, spec.commandLine().getErr());
        FilmFormat format = new FilmFormat(
                size.width(), size.height(), framesPerSecond, pictures.size(), isTransparent(pictures.getFirst()));
        if (format.alpha() && film.ffmpeg().isPresent()) {
            throw new BadInputException(
                    "--output is " + output + ", but the frames are transparent, which only an .apng file can be");
        }
        try (FilmWriting writing = new FilmWriting(film, format);
                ProgressLine line = progress.start(spec.commandLine(), "encoding", pictures.size())) {
            for (Path picture : pictures) {
                writing.add(pixels(picture, format));
                line.step();
            }
            writing.finish();
        }
        OutputFile.notes(spec.commandLine(), film.file())
                .printf(
                        "%s: %d frames of %d x %d, %s%n",
                        PrintableText.line(film.file().toString()),
                        format.frames(),
                        format.width(),
                        format.height(),
                        film.kind());
        return ExitCode.OK;
    }

    private List<Path> pictures() throws IOException {
        NumberedFiles names = FrameNames.of(pattern, frames.orElse(FrameRange.of(0, 0)));
        SortedMap<Integer, Path> there = names.existing();
        if (there.isEmpty()) {
            throw new BadInputException("there is no file " + names.file(0) + " or the like");
        }
        FrameRange wanted = frames.orElse(FrameRange.of(there.firstKey(), there.lastKey()));
        List<Integer> missing = wanted.numbers()
                .filter(number -> !there.containsKey(number))
                .boxed()
                .toList();
        if (!missing.isEmpty()) {
            throw new BadInputException("the film lacks frames "
                    + missing.stream().limit(MOST_NAMED).map(String::valueOf).collect(Collectors.joining(", "))
                    + (missing.size() > MOST_NAMED ? " and %d more".formatted(missing.size() - MOST_NAMED) : "")
                    + "; 'twister render --skip-existing' renders what is missing");
        }
        List<Path> files = new ArrayList<>();
        IntStream numbers = wanted.numbers();
        numbers.forEach(number -> files.add(there.get(number)));
        return files;
    }

    private static int[] pixels(Path file, FilmFormat format) throws IOException {
        PngNotes notes = PngNotes.of(file);
        PictureSize size = notes.size();
        if (size.width() != format.width() || size.height() != format.height()) {
            throw new BadInputException(file + " is " + size.width() + " x " + size.height()
                    + ", but the film's first frame is " + format.width() + " x " + format.height());
        }
        BufferedImage image = read(file);
        int[] pixels = image.getRGB(
                0, 0, format.width(), format.height(), new int[format.width() * format.height()], 0, format.width());
        return EncodedPixels.of(pixels, !notes.linear());
    }

    private static boolean isTransparent(Path file) throws IOException {
        return read(file).getColorModel().hasAlpha();
    }

    private static BufferedImage read(Path file) throws IOException {
        try {
            return ImageIO.read(file.toFile());
        } catch (IOException | RuntimeException problem) {
            // ImageIO reports some damage by runtime exceptions.
            throw new IOException(file + " is damaged or incomplete", problem);
        }
    }
}
