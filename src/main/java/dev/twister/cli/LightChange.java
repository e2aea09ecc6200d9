package dev.twister.cli;

import dev.twister.scene.Rgb;
import dev.twister.scene.SrgbCurve;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import picocli.CommandLine.ITypeConverter;
import picocli.CommandLine.TypeConversionException;

/**
 * A change of the light of a group of lights.
 *
 * @param factor of each channel
 */
record LightChange(String group, Rgb factor) {
    /** Reads {@code NAME=STRENGTH}, {@code NAME=STRENGTH,#RRGGBB} or {@code NAME=#RRGGBB}. */
    static final class Converter implements ITypeConverter<LightChange> {
        private static final double MOST = 1e6;
        private static final int HEXADECIMAL = 16;
        private static final int BYTE = 8;
        private static final int LARGEST = 255;
        private static final int WHITE = 0xFFFFFF;
        private static final Pattern TEXT = Pattern.compile("([^=]+)=(\\d+(?:\\.\\d+)?)?,?(?:#([0-9A-Fa-f]{6}))?");

        @Override
        public LightChange convert(String text) {
            Matcher parts = TEXT.matcher(text);
            if (!parts.matches() || text.endsWith("=") || text.endsWith(",")) {
                throw new TypeConversionException("'" + text
                        + "' is not a light's change; write NAME=STRENGTH, such as lamp=2.5 or lamp=2.5,#ffcc88");
            }
            String group = parts.group(1);
            double strength = parts.group(2) == null
                    ? 1
                    : Ranges.check("the strength of --light " + group, Double.parseDouble(parts.group(2)), 0, MOST);
            int color = parts.group(3) == null ? WHITE : Integer.parseInt(parts.group(3), HEXADECIMAL);
            return new LightChange(
                    group,
                    new Rgb(
                            strength * linear(color >> (2 * BYTE)),
                            strength * linear(color >> BYTE),
                            strength * linear(color)));
        }

        /** The linear value of the lowest byte, which is encoded as sRGB. */
        private static double linear(int value) {
            return SrgbCurve.linear((value & LARGEST) / (double) LARGEST);
        }
    }
}
