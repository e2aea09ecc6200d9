package dev.twister.image;

import dev.twister.exr.ExrBytes;
import dev.twister.exr.ExrColors;
import dev.twister.exr.OpenExrFile;
import dev.twister.files.InputFile;
import dev.twister.files.SystemReason;
import dev.twister.image.ExrPicture.ExrChannel;
import java.io.EOFException;
import java.io.IOException;
import java.nio.channels.FileChannel;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.zip.DataFormatException;

/** Reads OpenEXR files, of Twister and of other programs. */
public final class ExrReader {
    private static final List<String> COLORS = List.of("R", "G", "B");

    private ExrReader() {}

    /**
     * Reads a complete file. If another program made it, rows that are not stored are 0; and if it has no channels R, G
     * and B, but a layer of colors or one gray channel, these are its only channels, under those names.
     *
     * @throws IOException if it cannot be read, is incomplete or damaged; the message is one line and names the file
     */
    public static ExrPicture read(Path file) throws IOException {
        return read(file, ExrReader::picture);
    }

    /**
     * Reads which rows of a picture a file has.
     *
     * @throws IOException as {@link #read(Path)}
     */
    public static ExrExtent extent(Path file) throws IOException {
        return read(file, ExrReader::extent);
    }

    /** Such as {@code the first of 3 parts, 'beauty'}, if the file has several: no other part is read. */
    public static Optional<String> part(Path file) throws IOException {
        return read(file, OpenExrFile::firstPart);
    }

    private interface Content<T> {
        T of(OpenExrFile exr) throws IOException, DataFormatException;
    }

    private static <T> T read(Path file, Content<T> content) throws IOException {
        try (FileChannel channel = open(file)) {
            return read(file, channel, content);
        }
    }

    private static FileChannel open(Path file) throws IOException {
        try {
            InputFile.check(file);
            return FileChannel.open(file, StandardOpenOption.READ);
        } catch (IOException failure) {
            throw new IOException(file + ": " + SystemReason.of(failure), failure);
        }
    }

    private static <T> T read(Path file, FileChannel channel, Content<T> content) throws IOException {
        try {
            return content.of(new OpenExrFile(ExrBytes.of(channel)));
        } catch (EOFException problem) {
            throw new IOException(file + " is not whole: it ends before its last row", problem);
        } catch (DataFormatException problem) {
            throw new IOException(file + " is no .exr file, or is damaged", problem);
        } catch (IOException problem) {
            throw new IOException(file + " " + problem.getMessage(), problem);
        }
    }

    private static ExrExtent extent(OpenExrFile exr) throws IOException {
        if (provenance(exr).isPresent()) {
            return new ExrExtent(exr.width(), exr.height(), exr.firstRow(), exr.rows());
        }
        exr.checkEmpty(exr.width(), exr.height());
        return new ExrExtent(exr.width(), exr.height(), 0, exr.height());
    }

    private static ExrPicture picture(OpenExrFile exr) throws IOException, DataFormatException {
        ExrExtent extent = extent(exr);
        List<String> stored = exr.channels();
        List<String> colors = ExrColors.of(stored);
        boolean renamed = !colors.isEmpty()
                && !stored.containsAll(COLORS)
                && provenance(exr).isEmpty();
        List<String> names = renamed ? COLORS : stored;
        List<float[]> values = exr.read(renamed ? colors : stored);
        List<ExrChannel> channels = new ArrayList<>();
        for (int i = 0; i < names.size(); i++) {
            float[] all = values.get(i);
            if (extent.rows() > exr.rows()) {
                all = new float[Math.multiplyExact(extent.width(), extent.rows())];
                System.arraycopy(values.get(i), 0, all, exr.firstRow() * extent.width(), values.get(i).length);
            }
            channels.add(new ExrChannel(names.get(i), all, 0, 1));
        }
        return new ExrPicture(
                extent.width(), extent.height(), extent.firstRow(), extent.rows(), channels, provenance(exr));
    }

    private static Optional<Provenance> provenance(OpenExrFile exr) {
        return exr.text(Provenance.NAME.toLowerCase(Locale.ROOT))
                .flatMap(text -> Provenance.of(
                        exr.text(Provenance.SOFTWARE.toLowerCase(Locale.ROOT)).orElse(""), text))
                .map(made -> made.withDisplay(
                        exr.text(DisplaySettings.NAME.toLowerCase(Locale.ROOT)).flatMap(DisplaySettings::of)));
    }

    /**
     * Where the rows of an OpenEXR file are in a picture.
     *
     * @param width of the whole picture, in pixels
     * @param height of the whole picture
     * @param firstRow of the file, from the top
     * @param rows of the file
     */
    public record ExrExtent(int width, int height, int firstRow, int rows) {
        /** The first row of a picture, from the top, that none of these files has. */
        static int missingRow(List<ExrExtent> files) {
            int covered = 0;
            for (ExrExtent file : files.stream()
                    .sorted(Comparator.comparingInt(ExrExtent::firstRow))
                    .toList()) {
                if (file.firstRow <= covered) {
                    covered = Math.max(covered, file.firstRow + file.rows);
                }
            }
            return covered;
        }
    }
}
