package dev.twister.bench;

import dev.twister.scene.RenderSettings;
import java.util.Locale;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * A picture's size in pixels.
 *
 * @param width 1 to {@value RenderSettings#MAX_SIDE}
 * @param height 1 to {@value RenderSettings#MAX_SIDE}
 */
public record PictureSize(int width, int height) {
    public static final PictureSize HD = new PictureSize(1280, 720);
    public static final PictureSize FULL_HD = new PictureSize(1920, 1080);
    public static final PictureSize ULTRA_HD = new PictureSize(3840, 2160);

    private static final Pattern WIDTH_BY_HEIGHT = Pattern.compile("([0-9]{1,9})[xX×]([0-9]{1,9})");

    /**
     * Checks the sides.
     *
     * @throws IllegalArgumentException where a side is out of range
     */
    public PictureSize {
        if (width < 1 || height < 1 || width > RenderSettings.MAX_SIDE || height > RenderSettings.MAX_SIDE) {
            throw new IllegalArgumentException("the size " + width + "x" + height + " is not from 1x1 to "
                    + RenderSettings.MAX_SIDE + "x" + RenderSettings.MAX_SIDE);
        }
    }

    /**
     * Reads {@code 1280x720}, or one of the names 720p, 1080p and 4k.
     *
     * @throws IllegalArgumentException where it is neither, or out of range
     */
    public static PictureSize parse(String text) {
        return named(text).orElseGet(() -> {
            Matcher numbers = WIDTH_BY_HEIGHT.matcher(text);
            if (!numbers.matches()) {
                throw new IllegalArgumentException(
                        "'" + text + "' is not a size; write 1280x720 and the like, 720p, 1080p or 4k");
            }
            return new PictureSize(Integer.parseInt(numbers.group(1)), Integer.parseInt(numbers.group(2)));
        });
    }

    private static Optional<PictureSize> named(String text) {
        return switch (text.toLowerCase(Locale.ROOT)) {
            case "720p" -> Optional.of(HD);
            case "1080p" -> Optional.of(FULL_HD);
            case "4k", "2160p" -> Optional.of(ULTRA_HD);
            default -> Optional.empty();
        };
    }

    public long pixels() {
        return (long) width * height;
    }

    /** As {@link #parse} reads it. */
    @Override
    public String toString() {
        return width + "x" + height;
    }
}
