package dev.twister.cli.file;

import dev.twister.render.FrameRange;
import dev.twister.render.NumberedFiles;
import java.nio.file.Path;

/** File names of frames from options. */
public final class FrameNames {
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
