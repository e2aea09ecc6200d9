package dev.twister.sky.radiance;

import dev.twister.sky.SkyboxLimits;
import dev.twister.sky.image.FileBytes;
import dev.twister.sky.image.FileBytes.FileCursor;
import dev.twister.sky.image.Primaries;
import dev.twister.sky.image.ScanOrder;
import java.io.IOException;
import java.util.Arrays;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * What a Radiance picture says before its texels ("The Radiance file formats", Ward 1992 to 2003).
 *
 * @param xyz whether texels hold CIE XYZ and not red, green and blue
 * @param primaries what red, green and blue are, where the texels hold them
 * @param redDivisor the product of all EXPOSURE and COLORCORR factors of the first channel, which is to be divided by
 *     it
 * @param greenDivisor likewise, second channel
 * @param blueDivisor likewise, third channel
 * @param order size and order of the texels
 */
public record RadianceHeader(
        boolean xyz, Primaries primaries, double redDivisor, double greenDivisor, double blueDivisor, ScanOrder order) {
    /** The primaries of pictures that name none; as usual, their channels are taken for linear sRGB as they stand. */
    private static final Primaries RADIANCE = Primaries.of(0.640, 0.330, 0.290, 0.600, 0.150, 0.060, 1 / 3.0, 1 / 3.0);

    /** What follows names the program that wrote the file. */
    private static final String MAGIC = "#?";

    private static final String RGBE = "32-bit_rle_rgbe";
    private static final String XYZE = "32-bit_rle_xyze";
    private static final int MOST_BYTES = 1 << 16;
    private static final int MOST_QUOTED = 60;

    /** Whether the content starts as a Radiance picture does. */
    public static boolean startsIn(FileBytes file) throws IOException {
        return file.startsWith(MAGIC);
    }

    /**
     * Reads the header and the resolution line, and leaves the cursor at the first texel. Values of EXPOSURE, COLORCORR
     * and PRIMARIES that make no sense, of which there are many in files, count as absent.
     */
    public static RadianceHeader read(FileCursor content) throws IOException {
        boolean xyz = false;
        Primaries primaries = Primaries.SRGB;
        double[] exposure = {1, 1, 1};
        double[] correction = {1, 1, 1};
        String line = line(content);
        while (!line.isEmpty()) {
            // Lines of the pictures that this one was made from are indented; they do not count.
            if (line.startsWith("FORMAT=")) {
                xyz = isXyz(value(line));
            } else if (line.startsWith("EXPOSURE=")) {
                double factor = numbers(line, 1)[0];
                multiply(exposure, factor, factor, factor);
            } else if (line.startsWith("COLORCORR=")) {
                multiply(correction, numbers(line, 3));
            } else if (line.startsWith("PRIMARIES=")) {
                primaries = primaries(numbers(line, 8), primaries);
            }
            line = line(content);
        }
        multiply(exposure, correction);
        return new RadianceHeader(
                xyz, primaries, exposure[0], exposure[1], exposure[2], ResolutionLine.parse(line(content)));
    }

    /** A piece of a file made fit for a message of one line. */
    public static String quotable(String text) {
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

    /** The numbers of a line that has as many; NaN each where it has not. */
    private static double[] numbers(String line, int count) {
        double[] numbers = new double[count];
        Arrays.fill(numbers, Double.NaN);
        String[] words = value(line).split("\\s+", -1);
        try {
            for (int i = 0; words.length == count && i < count; i++) {
                numbers[i] = Double.parseDouble(words[i]);
            }
        } catch (NumberFormatException notANumber) {
            Arrays.fill(numbers, Double.NaN);
        }
        return numbers;
    }

    /** Multiplies by factors above 0, unless that leads out of a double's range. */
    private static void multiply(double[] divisors, double... factors) {
        double[] products = new double[3];
        for (int channel = 0; channel < 3; channel++) {
            products[channel] = divisors[channel] * factors[channel];
            // Written so that NaN fails too.
            if (!(factors[channel] > 0 && products[channel] > 0 && products[channel] < Double.POSITIVE_INFINITY)) {
                return;
            }
        }
        System.arraycopy(products, 0, divisors, 0, 3);
    }

    private static Primaries primaries(double[] named, Primaries before) {
        Primaries primaries = Primaries.of(named);
        if (!primaries.makeSense()) {
            return before;
        }
        return primaries.near(RADIANCE) ? Primaries.SRGB : primaries;
    }

    /** The next line without its end, which is a line feed or, as some Windows programs write it, CR and LF. */
    private static String line(FileCursor content) throws IOException {
        StringBuilder line = new StringBuilder();
        while (content.remaining() > 0 && content.position() < MOST_BYTES) {
            char next = (char) content.next();
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

    /**
     * The resolution line of a Radiance picture, {@code -Y 512 +X 1024} for one: how many texels there are and in which
     * order they come. The axis named first is the slow one; +Y runs upwards, +X to the right.
     */
    private static final class ResolutionLine {
        private static final Pattern LINE =
                Pattern.compile("([+-])([XY])\\s+(\\d{1,18})\\s+([+-])([XY])\\s+(\\d{1,18})\\s*");

        private ResolutionLine() {}

        static ScanOrder parse(String line) throws IOException {
            Matcher parts = LINE.matcher(line);
            if (!parts.matches() || parts.group(2).equals(parts.group(5))) {
                throw new IOException("the resolution line \"" + RadianceHeader.quotable(line)
                        + "\"; a line such as \"-Y 512 +X 1024\" is needed after the header's empty line");
            }
            boolean byColumns = parts.group(2).equals("X");
            boolean slowRises = parts.group(1).equals("+");
            boolean fastRises = parts.group(4).equals("+");
            long slow = Long.parseLong(parts.group(3));
            long fast = Long.parseLong(parts.group(6));
            long width = byColumns ? slow : fast;
            long height = byColumns ? fast : slow;
            SkyboxLimits.checkSize(width, height);
            boolean leftToRight = byColumns ? slowRises : fastRises;
            boolean upwards = byColumns ? fastRises : slowRises;
            return new ScanOrder((int) width, (int) height, byColumns, !leftToRight, upwards);
        }
    }
}
