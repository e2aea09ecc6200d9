package dev.twister.cli;

import dev.twister.files.PrintableText;
import dev.twister.image.ExrChannel;
import dev.twister.image.ExrPicture;
import dev.twister.image.ExrWriter;
import dev.twister.image.HdrWriter;
import dev.twister.image.PictureNotes;
import dev.twister.image.PngWriter;
import dev.twister.image.Provenance;
import dev.twister.world.FrameInput;
import dev.twister.world.Picture;
import java.io.BufferedOutputStream;
import java.io.Console;
import java.io.FileDescriptor;
import java.io.FileOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;

/**
 * Where pictures go: one to a file, numbered ones to files, or all of them to the standard output, one after the other.
 */
final class PictureOutput {
    private static final String OPTION = "--output";
    private static final Path STANDARD_OUTPUT = Path.of("-");
    private static final String PNG = ".png";
    private static final String HDR = ".hdr";
    private static final String EXR = ".exr";

    private final Path output;
    private final Optional<NumberedFiles> numbered;
    private final FrameRange frames;
    private final boolean replaces;

    private PictureOutput(Path output, Optional<NumberedFiles> numbered, FrameRange frames, boolean replaces) {
        this.output = output;
        this.numbered = numbered;
        this.frames = frames;
        this.replaces = replaces;
    }

    /**
     * Looks where pictures are to go before they are drawn.
     *
     * @param frames where they are numbered
     * @param replaces whether those may replace frames of an earlier run
     * @param views how many pictures go into each file
     * @throws BadInputException where they cannot go there
     */
    static PictureOutput of(Path output, Optional<FrameRange> frames, boolean replaces, int views) {
        if (views > 1 && !OutputFile.endsIn(output, EXR)) {
            throw new BadInputException(OPTION + " is " + output + ", but --view has " + views
                    + " names, which only an " + EXR + " file can hold; give one name, or another file");
        }
        if (output.equals(STANDARD_OUTPUT)) {
            checkNoTerminal();
            return new PictureOutput(output, Optional.empty(), frames.orElse(FrameRange.ofCount(1)), replaces);
        }
        if (Stream.of(PNG, HDR, EXR).noneMatch(ending -> OutputFile.endsIn(output, ending))) {
            throw new BadInputException(OPTION + " is " + output + ", but must end in " + PNG + ", " + HDR + " or "
                    + EXR + " (.mp4 or .apng for a film), or be - for a PNG");
        }
        PictureOutput pictures = new PictureOutput(
                output,
                frames.map(range -> NumberedFiles.of(output, range)),
                frames.orElse(FrameRange.ofCount(1)),
                replaces);
        OutputFile.check(OPTION, pictures.file(pictures.frames.first()));
        return pictures;
    }

    /** Looks at the folder of an output before anything else is read. */
    static void checkPlace(Path output) {
        if (Stream.of(PNG, HDR, EXR).anyMatch(ending -> OutputFile.endsIn(output, ending))) {
            OutputFile.check(OPTION, output);
        }
    }

    private static void checkNoTerminal() {
        if (Optional.ofNullable(System.console()).map(Console::isTerminal).orElse(false)) {
            throw new BadInputException(
                    OPTION + " is -, but standard output is a terminal; redirect it to a file or a program");
        }
    }

    /**
     * Keeps what the pictures are made from, and frames of an earlier run.
     *
     * @param inputs files that are there
     * @throws BadInputException where a picture would replace one of them
     */
    void checkKeeps(Path... inputs) throws IOException {
        if (isStandardOutput()) {
            return;
        }
        for (int number : frames.numbers().toArray()) {
            Path file = file(number);
            OutputFile.checkKeeps(OPTION, file, inputs);
            if (numbered.isPresent() && !replaces && Files.exists(file)) {
                throw new BadInputException(file
                        + " already exists; use --overwrite to replace the frames of an earlier run, --skip-existing to keep"
                        + " them, or another name");
            }
        }
    }

    boolean isStandardOutput() {
        return output.equals(STANDARD_OUTPUT);
    }

    /** Whether linear radiance is wanted, not pixels. */
    boolean isLinear() {
        return OutputFile.endsIn(output, HDR) || isExr();
    }

    private boolean isExr() {
        return OutputFile.endsIn(output, EXR);
    }

    /** Bytes per pixel that rendering and writing this number of pictures takes. */
    long bytesPerPixel(List<Picture> pictures) {
        long drawn = pictures.stream()
                .mapToLong(picture -> BandedDrawing.bytesPerPixel(isLinear() || !picture.isColor()))
                .sum();
        return isExr() ? 2 * drawn : drawn;
    }

    /** Where the pictures are, for people. */
    String name() {
        if (isStandardOutput()) {
            return "standard output";
        }
        String first = PrintableText.line(file(frames.first()).toString());
        return numbered.isEmpty()
                ? first
                : first + " to " + PrintableText.line(file(frames.last()).toString());
    }

    /**
     * Whether the file of a number is there, whole, and made from the same.
     *
     * @param input the whole picture, or the part that the file must have
     */
    boolean has(int number, Provenance made, FrameInput input) {
        return !isStandardOutput()
                && PictureNotes.of(file(number), input.firstRow(), input.rows()).equals(Optional.of(made));
    }

    /**
     * Writes the pictures of a number.
     *
     * @param drawn one, or more into an .exr file
     * @param input what they were drawn from, the whole picture or a part
     * @param made told in the file
     */
    void write(int number, List<DrawnPicture> drawn, FrameInput input, Provenance made) throws IOException {
        DrawnPicture first = drawn.getFirst();
        int width = first.frame().width();
        int height = first.frame().height();
        // Numbers are shown as they are, without a mark that has viewers turn linear light into sRGB.
        boolean encoded = input.srgb() || !first.picture().isColor();
        if (isStandardOutput()) {
            // Not System.out, which keeps errors to itself; it is not closed, as others may be written to it.
            OutputStream out = new FileOutputStream(FileDescriptor.out);
            PngWriter.write(new BufferedOutputStream(out), width, height, first.pixels(), encoded, made);
        } else if (isExr()) {
            List<ExrChannel> channels = drawn.stream()
                    .flatMap(picture -> picture.channels(drawn.size() == 1).stream())
                    .toList();
            ExrWriter.write(
                    file(number),
                    new ExrPicture(width, input.height(), input.firstRow(), input.rows(), channels, Optional.of(made)));
        } else if (isLinear()) {
            HdrWriter.write(file(number), width, height, first.frame().radiance(), made);
        } else {
            PngWriter.write(file(number), width, height, first.pixels(), encoded, made);
        }
    }

    private Path file(int number) {
        return numbered.map(files -> files.file(number)).orElse(output);
    }
}
