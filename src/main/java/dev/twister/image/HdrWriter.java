package dev.twister.image;

import dev.twister.files.WholeFile;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.Locale;

/** Writes linear radiance as a Radiance RGBE file ({@code .hdr}). */
public final class HdrWriter {
    private HdrWriter() {}

    /**
     * Writes a Radiance picture, rows from the top, run length coded if the format allows it (widths of 8 to 32767
     * pixels), otherwise flat; on failure the file is unchanged. A value read back, as {@code m * 2^(e - 136)}, lies
     * within 1/256 of a pixel's largest channel of what was written. NaN and negative channels become 0, a pixel whose
     * largest channel is below 2^-128 becomes black, and channels are cut at 255 * 2^119, the largest the format holds.
     *
     * @param width pixels in a row, 1 or more
     * @param height rows, 1 or more
     * @param radiance {@code 3 * width * height} floats: red, green, blue of each pixel, row by row from the top
     * @throws IllegalArgumentException if the array has another length
     * @throws IOException as {@link WholeFile#write}
     */
    public static void write(Path file, int width, int height, float[] radiance) throws IOException {
        write(file, width, height, radiance, "");
    }

    /** As above, with the provenance in the header. */
    public static void write(Path file, int width, int height, float[] radiance, Provenance made) throws IOException {
        String lines = Provenance.SOFTWARE.toUpperCase(Locale.ROOT) + "=" + made.software() + "\n" + HdrNotes.VARIABLE
                + made.text() + "\n"
                + made.display()
                        .map(display -> HdrNotes.DISPLAY + display.text() + "\n")
                        .orElse("");
        write(file, width, height, radiance, lines);
    }

    private static void write(Path file, int width, int height, float[] radiance, String lines) throws IOException {
        if (width < 1 || height < 1 || radiance.length != 3L * width * height) {
            throw new IllegalArgumentException("a picture of " + width + " x " + height + " pixels needs "
                    + 3L * width * height + " floats, not " + radiance.length);
        }
        String header = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n" + lines + "\n-Y " + height + " +X " + width + "\n";
        WholeFile.write(file, out -> {
            out.write(header.getBytes(StandardCharsets.US_ASCII));
            byte[] row = new byte[Math.multiplyExact(4, width)];
            RgbeRunLengths runLengths = new RgbeRunLengths(width);
            for (int y = 0; y < height; y++) {
                for (int x = 0; x < width; x++) {
                    RgbeCodec.encode(radiance, 3 * (y * width + x), row, 4 * x);
                }
                if (RgbeRunLengths.fits(width)) {
                    runLengths.write(row, out);
                } else {
                    out.write(row);
                }
            }
        });
    }
}
