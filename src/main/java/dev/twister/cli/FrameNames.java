package dev.twister.cli;

import dev.twister.render.FrameRange;
import dev.twister.render.NumberedFiles;
import java.nio.file.Path;

/** The names of a film's frames, as options give them. */
final class FrameNames {
    private FrameNames() {}

    /**
     * Names for frames, see {@link NumberedFiles#of}.
     *
     * @throws BadInputException where the name makes none
     */
    static NumberedFiles of(Path file, FrameRange frames) {
        try {
            return NumberedFiles.of(file, frames);
        } catch (IllegalArgumentException problem) {
            throw new BadInputException("--output is " + file + ", but " + problem.getMessage());
        }
    }
}
