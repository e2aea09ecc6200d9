package dev.twister.render;

import dev.twister.files.WholeFile;
import dev.twister.film.FilmFile;
import java.nio.file.Path;
import java.util.Optional;

/**
 * Where pictures go: a film, numbered files, a single file, or standard output.
 *
 * @param file the film or picture, a pattern of {@link NumberedFiles}, or {@link WholeFile#STANDARD_OUTPUT}
 * @param frames empty for a single picture
 * @param existing applies to numbered files; any other file is replaced
 * @param background {@link Background#NONE} for files with alpha: .png, .exr and .apng
 */
public record RenderOutput(Path file, Optional<FrameRange> frames, ExistingFrames existing, Background background) {
    private static final FrameRange SINGLE = FrameRange.ofCount(1);

    /** Whether all frames go into one file. */
    public boolean isFilm() {
        return FilmFile.isFilm(file);
    }

    public boolean isStandardOutput() {
        return file.equals(WholeFile.STANDARD_OUTPUT);
    }

    /** Whether each frame is a file of its own. */
    public boolean isNumbered() {
        return frames.isPresent() && !isFilm() && !isStandardOutput();
    }

    /** Format of the pictures; PNG if the name has no known ending. */
    public PictureFormat format() {
        return PictureFormat.of(file).orElse(PictureFormat.PNG);
    }

    /** Whether pictures have no background. */
    public boolean isCut() {
        return background == Background.NONE;
    }

    /** Whether radiance is written instead of pixels. */
    public boolean isLinear() {
        return !isFilm() && format().isLinear();
    }

    /** The frames, or number 0 for a single picture. */
    public FrameRange range() {
        return frames.orElse(SINGLE);
    }

    /**
     * The file of a frame.
     *
     * @throws IllegalArgumentException as {@link NumberedFiles#of}
     */
    public Path file(int number) {
        return isNumbered() ? NumberedFiles.of(file, range()).file(number) : file;
    }

    /** The file, or the first of numbered ones. */
    public Path firstFile() {
        return file(range().first());
    }

    /** The file, or the last of numbered ones. */
    public Path lastFile() {
        return file(range().last());
    }
}
