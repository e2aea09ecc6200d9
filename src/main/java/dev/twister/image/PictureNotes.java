package dev.twister.image;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Optional;

/** Reads how pictures in files were made. */
public final class PictureNotes {
    private PictureNotes() {}

    /**
     * What a file says of how it was made; empty where it is not there, is no picture of Twister's, has other rows, or
     * is not whole.
     *
     * @param file .png, .hdr or .exr; the first two have all rows
     * @param firstRow that it must have
     * @param rows how many it must have
     */
    public static Optional<Provenance> of(Path file, int firstRow, int rows) {
        if (!Files.isRegularFile(file)) {
            return Optional.empty();
        }
        String name = file.toString().toLowerCase(Locale.ROOT);
        try {
            if (name.endsWith(".exr")) {
                ExrPicture picture = ExrReader.read(file);
                return picture.provenance().filter(_ -> picture.firstRow() == firstRow && picture.rows() == rows);
            }
            return name.endsWith(".hdr") ? HdrNotes.of(file) : PngNotes.of(file).provenance();
        } catch (IOException _) {
            return Optional.empty();
        }
    }
}
