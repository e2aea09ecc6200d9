package dev.twister.cli.file;

import dev.twister.files.PrintableText;
import dev.twister.render.Background;
import dev.twister.render.ExistingFrames;
import dev.twister.render.FrameRange;
import dev.twister.render.NumberedFiles;
import dev.twister.render.PictureFormat;
import dev.twister.render.RenderOutput;
import dev.twister.world.StageOrView;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;

/** Checks the output of {@code twister render} before anything is rendered. */
public final class PictureOutput {
    private static final String OPTION = "--output";

    private PictureOutput() {}

    /**
     * The output that the options give.
     *
     * @param frames empty for a single picture
     * @param pictures those in each file
     * @param background what they have where there is no body
     * @throws BadInputException if it cannot be written, or cannot hold the pictures
     */
    public static RenderOutput of(
            Path file,
            Optional<FrameRange> frames,
            ExistingFrames existing,
            List<StageOrView> pictures,
            Background background) {
        RenderOutput output = new RenderOutput(file, frames, existing, background);
        if (output.isCut() && output.format() == PictureFormat.HDR) {
            throw new BadInputException(
                    "--output is " + file + ", but --background none needs a .png, .exr or .apng file");
        }
        if (pictures.size() > 1 && output.format() != PictureFormat.EXR) {
            throw new BadInputException(OPTION + " is " + file + ", but --view has " + pictures.size()
                    + " names, which only an .exr file can hold; give one name, or another file");
        }
        if (output.isStandardOutput()) {
            OutputFile.checkBinary(OPTION, file);
            return output;
        }
        if (PictureFormat.of(file).isEmpty()) {
            throw new BadInputException(OPTION + " is " + file
                    + ", but must end in .png, .hdr or .exr (.mp4 or .apng for a film), or be - for a PNG");
        }
        frames.ifPresent(range -> FrameNames.of(file, range));
        OutputFile.check(OPTION, output.firstFile());
        // The last number may make the longest name.
        OutputFile.check(OPTION, output.lastFile());
        return output;
    }

    /** Looks at the folder of an output before anything else is read. */
    public static void checkPlace(Path output) {
        if (PictureFormat.of(output).isPresent()) {
            OutputFile.check(OPTION, output);
        }
    }

    /**
     * Checks that no input, and no frame of an earlier run, is replaced.
     *
     * @param inputs files that exist
     * @throws BadInputException if a picture would replace one of them
     */
    public static void checkKeeps(RenderOutput output, List<Path> inputs) throws IOException {
        for (int number :
                output.isFilm() ? new int[1] : output.range().numbers().toArray()) {
            Path file = output.file(number);
            OutputFile.checkKeeps(OPTION, file, inputs);
            if (output.isNumbered() && output.existing() == ExistingFrames.REFUSED && Files.exists(file)) {
                throw new BadInputException(
                        file + " already exists; use --overwrite to replace the frames of an earlier run,"
                                + " --skip-existing to keep them, or another name");
            }
        }
    }

    /** The files for display. */
    public static String name(RenderOutput output) {
        String first = OutputFile.name(output.firstFile());
        return output.isNumbered()
                ? first + " to " + PrintableText.line(output.lastFile().toString())
                : first;
    }

    /** File names of frames from options. */
    public static final class FrameNames {
        private FrameNames() {}

        /**
         * Names for frames, see {@link NumberedFiles#of}.
         *
         * @throws BadInputException if the name is invalid
         */
        public static NumberedFiles of(Path file, FrameRange frames) {
            try {
                return NumberedFiles.of(file, frames);
            } catch (IllegalArgumentException problem) {
                throw new BadInputException("--output is " + file + ", but " + problem.getMessage());
            }
        }
    }
}
