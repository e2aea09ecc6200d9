package dev.twister.image;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Optional;

/**
 * How a picture was made, as stored in its file.
 *
 * @param software program and version
 * @param picture digest of everything that the picture depends on, except its samples; one word
 * @param samples samples of each pixel, such as {@code 16} or {@code 0-15}
 * @param display how linear radiance was to be shown; in .exr and .hdr files of colors
 */
public record Provenance(String software, String picture, String samples, Optional<DisplaySettings> display) {
    /** Metadata name of the digest and the samples; the software is stored as {@link #SOFTWARE}. */
    static final String NAME = "Twister";

    static final String SOFTWARE = "Software";

    /** Without display settings. */
    public Provenance(String software, String picture, String samples) {
        this(software, picture, samples, Optional.empty());
    }

    /**
     * Whether another file holds the same picture; not all formats have the display settings, which its digest covers.
     */
    public boolean isOfSamePicture(Provenance other) {
        return withDisplay(other.display).equals(other);
    }

    /** The same with other display settings. */
    Provenance withDisplay(Optional<DisplaySettings> newDisplay) {
        return new Provenance(software, picture, samples, newDisplay);
    }

    public String text() {
        return picture + " " + samples;
    }

    public static Optional<Provenance> of(String software, String text) {
        int end = text.indexOf(' ');
        return end < 0
                ? Optional.empty()
                : Optional.of(new Provenance(software, text.substring(0, end), text.substring(end + 1)));
    }

    /**
     * How a picture was made; empty if another program made it, or it has other rows.
     *
     * @param file .png, .hdr or .exr; the first two have all rows
     * @param firstRow required number of its first row
     * @param rows required number of rows
     * @throws IOException if the file cannot be read or is damaged
     * @throws IllegalArgumentException if the name has another ending
     */
    public static Optional<Provenance> ofFile(Path file, int firstRow, int rows) throws IOException {
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
