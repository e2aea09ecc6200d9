package dev.twister.image;

import dev.twister.files.WholeFile;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.Locale;

/** Writes linear radiance as a Radiance RGBE file ({@code .hdr}). */
public final class HdrWriter {
    private static final double LARGEST = 255 * 0x1p119;
    private static final double SMALLEST = 0x1p-128;

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
                    encode(radiance, 3 * (y * width + x), row, 4 * x);
                }
                if (RgbeRunLengths.fits(width)) {
                    runLengths.write(row, out);
                } else {
                    out.write(row);
                }
            }
        });
    }

    /**
     * Encodes one texel. A texel that is not black has a largest mantissa of 128 or more, so that no texel of a flat
     * row looks like a run length code, (1, 1, 1, n) or (2, 2, n, n).
     *
     * @param radiance red, green, blue from index {@code from} on; any values
     * @param rgbe receives three mantissas and the exponent from index {@code to} on
     */
    static void encode(float[] radiance, int from, byte[] rgbe, int to) {
        double red = representable(radiance[from]);
        double green = representable(radiance[from + 1]);
        double blue = representable(radiance[from + 2]);
        double largest = Math.max(red, Math.max(green, blue));
        if (largest < SMALLEST) {
            rgbe[to] = 0;
            rgbe[to + 1] = 0;
            rgbe[to + 2] = 0;
            rgbe[to + 3] = 0;
            return;
        }
        int exponent = Math.getExponent(largest) + 1;
        rgbe[to] = mantissa(red, exponent);
        rgbe[to + 1] = mantissa(green, exponent);
        rgbe[to + 2] = mantissa(blue, exponent);
        rgbe[to + 3] = (byte) (exponent + 128);
    }

    /** Limited to 255 instead of carrying into the exponent, which would double the error of the other two channels. */
    private static byte mantissa(double channel, int exponent) {
        return (byte) Math.min(255, Math.rint(Math.scalb(channel, 8 - exponent)));
    }

    private static double representable(float channel) {
        return channel > 0 ? Math.min(channel, LARGEST) : 0;
    }
}
