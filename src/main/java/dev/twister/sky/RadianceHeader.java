package dev.twister.sky;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;

/**
 * What a Radiance picture says before its texels ("The Radiance file formats", Ward 1992 to 2003).
 *
 * @param xyz whether texels hold CIE XYZ and not red, green and blue
 * @param redDivisor the product of all EXPOSURE and COLORCORR factors of the first channel, which is to be divided by it
 * @param greenDivisor likewise, second channel
 * @param blueDivisor likewise, third channel
 * @param layout size and order of the texels
 */
record RadianceHeader(boolean xyz, double redDivisor, double greenDivisor, double blueDivisor, RadianceLayout layout) {
    private static final String[] MAGICS = {"#?RADIANCE", "#?RGBE"};
    private static final String RGBE = "32-bit_rle_rgbe";
    private static final String XYZE = "32-bit_rle_xyze";
    private static final int MOST_BYTES = 1 << 16;
    private static final int MOST_QUOTED = 60;

    /** Whether the content starts as a Radiance picture does. */
    static boolean startsIn(ByteBuffer content) {
        for (String magic : MAGICS) {
            byte[] bytes = magic.getBytes(StandardCharsets.US_ASCII);
            if (content.remaining() >= bytes.length
                    && content.slice(content.position(), bytes.length).equals(ByteBuffer.wrap(bytes))) {
                return true;
            }
        }
        return false;
    }

    /** Reads the header and the resolution line, and leaves the buffer at the first texel. */
    static RadianceHeader read(ByteBuffer content) throws IOException {
        boolean xyz = false;
        double exposure = 1;
        double[] correction = {1, 1, 1};
        String line = line(content);
        while (!line.isEmpty()) {
            // Lines of the pictures that this one was made from are indented; they do not count.
            if (line.startsWith("FORMAT=")) {
                xyz = isXyz(value(line));
            } else if (line.startsWith("EXPOSURE=")) {
                exposure *= factor(value(line), line);
            } else if (line.startsWith("COLORCORR=")) {
                String[] factors = value(line).split("\\s+", -1);
                if (factors.length != 3) {
                    throw new IOException("the header line \"" + quotable(line) + "\"; COLORCORR takes three numbers");
                }
                for (int channel = 0; channel < 3; channel++) {
                    correction[channel] *= factor(factors[channel], line);
                }
            }
            line = line(content);
        }
        double red = divisor(exposure * correction[0]);
        double green = divisor(exposure * correction[1]);
        double blue = divisor(exposure * correction[2]);
        return new RadianceHeader(xyz, red, green, blue, RadianceLayout.parse(line(content)));
    }

    /** A piece of a file made fit for a message of one line. */
    static String quotable(String text) {
        String printable = text.replaceAll("[^\\x20-\\x7e]", "?");
        return printable.length() <= MOST_QUOTED ? printable : printable.substring(0, MOST_QUOTED) + "...";
    }

    private static String value(String line) {
        return line.substring(line.indexOf('=') + 1).strip();
    }

    private static boolean isXyz(String format) throws IOException {
        return switch (format) {
            case RGBE -> false;
            case XYZE -> true;
            default -> throw new IOException("FORMAT=" + quotable(format) + "; " + RGBE + " and " + XYZE + " are read");
        };
    }

    private static double factor(String number, String line) throws IOException {
        try {
            double factor = Double.parseDouble(number);
            if (factor > 0 && factor < Double.POSITIVE_INFINITY) {
                return factor;
            }
        } catch (NumberFormatException notANumber) {
            throw new IOException("the header line \"" + quotable(line) + "\"; a number is needed", notANumber);
        }
        throw new IOException("the header line \"" + quotable(line) + "\"; a number above 0 is needed");
    }

    private static double divisor(double product) throws IOException {
        if (product > 0 && product < Double.POSITIVE_INFINITY) {
            return product;
        }
        throw new IOException("the exposures multiply to " + product + "; a number above 0 is needed");
    }

    /** The next line without its end, which is a line feed or, as some Windows programs write it, CR and LF. */
    private static String line(ByteBuffer content) throws IOException {
        StringBuilder line = new StringBuilder();
        int end = Math.min(content.limit(), MOST_BYTES);
        while (content.position() < end) {
            char next = (char) Byte.toUnsignedInt(content.get());
            if (next == '\n') {
                int length = line.length();
                boolean windows = length > 0 && line.charAt(length - 1) == '\r';
                return windows ? line.substring(0, length - 1) : line.toString();
            }
            line.append(next);
        }
        throw new IOException(
                "a Radiance header without end; an empty line and the resolution line must come within the" + " first "
                        + MOST_BYTES + " bytes");
    }
}
