package dev.twister.cli;

import dev.twister.files.PrintableText;
import dev.twister.image.PictureNotes;
import dev.twister.image.Provenance;
import dev.twister.render.DrawnPicture;
import dev.twister.render.FrameRange;
import dev.twister.render.FrameRendering;
import dev.twister.render.NumberedFiles;
import dev.twister.render.PictureFormat;
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

/**
 * Where pictures go: one to a file, numbered ones to files, or all of them to the standard output, one after the other.
 */
final class PictureOutput implements FrameRendering.Target {
    private static final String OPTION = "--output";

    private final Path output;
    private final Optional<NumberedFiles> numbered;
    private final FrameRange frames;
    private final ExistingFrames existing;

    private PictureOutput(Path output, Optional<NumberedFiles> numbered, FrameRange frames, ExistingFrames existing) {
        this.output = output;
        this.numbered = numbered;
        this.frames = frames;
        this.existing = existing;
    }

    /**
     * Looks where pictures are to go before they are drawn.
     *
     * @param frames where they are numbered
     * @param existing what is done about frames of an earlier run
     * @param views how many pictures go into each file
     * @throws BadInputException where they cannot go there
     */
    static PictureOutput of(Path output, Optional<FrameRange> frames, ExistingFrames existing, int views) {
        if (views > 1 && format(output) != PictureFormat.EXR) {
            throw new BadInputException(OPTION + " is " + output + ", but --view has " + views
                    + " names, which only an .exr file can hold; give one name, or another file");
        }
        if (OutputFile.isStandardOutput(output)) {
            checkNoTerminal();
            return new PictureOutput(output, Optional.empty(), frames.orElse(FrameRange.ofCount(1)), existing);
        }
        if (PictureFormat.of(output).isEmpty()) {
            throw new BadInputException(OPTION + " is " + output
                    + ", but must end in .png, .hdr or .exr (.mp4 or .apng for a film), or be - for a PNG");
        }
        PictureOutput pictures = new PictureOutput(
                output,
                frames.map(range -> FrameNames.of(output, range)),
                frames.orElse(FrameRange.ofCount(1)),
                existing);
        OutputFile.check(OPTION, pictures.file(pictures.frames.first()));
        return pictures;
    }

    /** Looks at the folder of an output before anything else is read. */
    static void checkPlace(Path output) {
        if (PictureFormat.of(output).isPresent()) {
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
    void checkKeeps(List<Path> inputs) throws IOException {
        if (isStandardOutput()) {
            return;
        }
        for (int number : frames.numbers().toArray()) {
            Path file = file(number);
            OutputFile.checkKeeps(OPTION, file, inputs);
            if (numbered.isPresent() && existing == ExistingFrames.REFUSED && Files.exists(file)) {
                throw new BadInputException(file
                        + " already exists; use --overwrite to replace the frames of an earlier run, --skip-existing to keep"
                        + " them, or another name");
            }
        }
    }

    boolean isStandardOutput() {
        return OutputFile.isStandardOutput(output);
    }

    /** Whether linear radiance is wanted, not pixels. */
    boolean isLinear() {
        return format(output).isLinear();
    }

    private static PictureFormat format(Path output) {
        return PictureFormat.of(output).orElse(PictureFormat.PNG);
    }

    /** Bytes per pixel that rendering and writing this number of pictures takes. */
    long bytesPerPixel(List<Picture> pictures) {
        return format(output).bytesPerPixel(pictures);
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

    /** Whether frames that are there, whole, and made from the same, are kept. */
    @Override
    public boolean keeps(int number, Provenance made, FrameInput part) {
        return existing == ExistingFrames.KEPT
                && !isStandardOutput()
                && PictureNotes.of(file(number), part.firstRow(), part.rows()).equals(Optional.of(made));
    }

    @Override
    public boolean isOrdered() {
        return isStandardOutput();
    }

    @Override
    public void write(int number, List<DrawnPicture> drawn, FrameInput part, Provenance made) throws IOException {
        if (isStandardOutput()) {
            // Not System.out, which keeps errors to itself; it is not closed, as others may be written to it.
            OutputStream out = new BufferedOutputStream(new FileOutputStream(FileDescriptor.out));
            PictureFormat.writePng(out, drawn.getFirst(), part, made);
        } else {
            format(output).write(file(number), drawn, part, made);
        }
    }

    private Path file(int number) {
        return numbered.map(files -> files.file(number)).orElse(output);
    }
}
