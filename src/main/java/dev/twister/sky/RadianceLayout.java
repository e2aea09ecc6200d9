package dev.twister.sky;

import java.io.IOException;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * The resolution line of a Radiance picture, {@code -Y 512 +X 1024} for one: how many texels there are and in which of the
 * eight orders they come. The axis named first is the slow one; +Y runs upwards, +X to the right.
 *
 * @param width texels in a row of the upright picture
 * @param height rows of the upright picture
 * @param byColumns whether a scanline is a column of the picture and not a row
 * @param rightToLeft whether x falls as texels are read
 * @param bottomToTop whether y rises as texels are read
 */
record RadianceLayout(int width, int height, boolean byColumns, boolean rightToLeft, boolean bottomToTop) {
    private static final Pattern LINE =
            Pattern.compile("([+-])([XY])\\s+(\\d{1,18})\\s+([+-])([XY])\\s+(\\d{1,18})\\s*");

    static RadianceLayout parse(String line) throws IOException {
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
        return new RadianceLayout((int) width, (int) height, byColumns, !leftToRight, upwards);
    }

    int scanlines() {
        return byColumns ? width : height;
    }

    int scanlineLength() {
        return byColumns ? height : width;
    }

    /** The index, {@code y * width + x} of the upright picture, of a scanline's texel. */
    int texel(int scanline, int place) {
        int x = byColumns ? scanline : place;
        int y = byColumns ? place : scanline;
        return (bottomToTop ? height - 1 - y : y) * width + (rightToLeft ? width - 1 - x : x);
    }

    /** The distance between the indices of neighbours in a scanline. */
    int step() {
        if (byColumns) {
            return bottomToTop ? -width : width;
        }
        return rightToLeft ? -1 : 1;
    }
}
