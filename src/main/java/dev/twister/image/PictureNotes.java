package dev.twister.image;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Optional;

/** Reads from picture files how they were made. */
public final class PictureNotes {
    private PictureNotes() {}

    /**
     * How a picture was made; empty if another program made it, or it has other rows.
     *
     * @param file .png, .hdr or .exr; the first two have all rows
     * @param firstRow required number of its first row
     * @param rows required number of rows
     * @throws IOException if the file cannot be read or is damaged
     * @throws IllegalArgumentException if the name has another ending
     */
    public static Optional<Provenance> of(Path file, int firstRow, int rows) throws IOException {
        String name = file.toString().toLowerCase(Locale.ROOT);
        return switch (name.substring(Math.max(0, name.lastIndexOf('.')))) {
            case ".png" -> PngNotes.of(file).provenance();
            case ".hdr" -> HdrNotes.of(file);
            case ".exr" -> {
                ExrPicture picture = ExrReader.read(file);
                yield picture.provenance().filter(_ -> picture.firstRow() == firstRow && picture.rows() == rows);
            }
            default -> throw new IllegalArgumentException(file + " does not end in .png, .hdr or .exr");
        };
    }
}
