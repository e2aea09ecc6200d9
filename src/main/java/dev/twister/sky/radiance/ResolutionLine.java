package dev.twister.sky.radiance;

import dev.twister.sky.SkyboxLimits;
import dev.twister.sky.image.ScanOrder;
import java.io.IOException;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * The resolution line of a Radiance picture, {@code -Y 512 +X 1024} for one: how many texels there are and in which
 * order they come. The axis named first is the slow one; +Y runs upwards, +X to the right.
 */
final class ResolutionLine {
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
