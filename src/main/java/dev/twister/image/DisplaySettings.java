package dev.twister.image;

import java.util.Locale;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * How linear radiance of a file becomes the picture that was rendered.
 *
 * @param exposure in stops: radiance is multiplied by 2^exposure
 * @param toneMap its name, in lower case
 * @param srgb whether the sRGB transfer function follows the tone map
 */
public record DisplaySettings(double exposure, String toneMap, boolean srgb) {
    /** Metadata name. */
    static final String NAME = "TwisterDisplay";

    private static final Pattern TEXT =
            Pattern.compile("exposure=(-?[0-9.Ee-]{1,32}) tone-map=([a-z]{1,32}) srgb=(true|false)");

    String text() {
        return String.format(Locale.ROOT, "exposure=%s tone-map=%s srgb=%s", exposure, toneMap, srgb);
    }

    /** The settings of a text; empty if it is none of them. */
    static Optional<DisplaySettings> of(String text) {
        Matcher parts = TEXT.matcher(text.strip());
        if (!parts.matches()) {
            return Optional.empty();
        }
        try {
            return Optional.of(new DisplaySettings(
                    Double.parseDouble(parts.group(1)), parts.group(2), Boolean.parseBoolean(parts.group(3))));
        } catch (NumberFormatException _) {
            return Optional.empty();
        }
    }
}
