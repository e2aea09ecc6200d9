package dev.twister.image;

import java.util.Locale;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * A picture's size in pixels.
 *
 * @param width 1 or more
 * @param height 1 or more
 */
public record PictureSize(int width, int height) {
    public static final PictureSize HD = new PictureSize(1280, 720);
    public static final PictureSize FULL_HD = new PictureSize(1920, 1080);
    public static final PictureSize ULTRA_HD = new PictureSize(3840, 2160);

    private static final Map<String, PictureSize> NAMES =
            Map.of("720p", HD, "1080p", FULL_HD, "4k", ULTRA_HD, "2160p", ULTRA_HD);
    private static final Pattern WIDTH_BY_HEIGHT = Pattern.compile("([0-9]{1,9})[xX×]([0-9]{1,9})");

    /**
     * Checks the sides.
     *
     * @throws IllegalArgumentException if a side is less than 1
     */
    public PictureSize {
        if (width < 1 || height < 1) {
            throw new IllegalArgumentException("the size " + width + "x" + height + " has no pixels");
        }
    }

    /**
     * Reads {@code 1280x720}, or one of the names 720p, 1080p and 4k.
     *
     * @throws IllegalArgumentException if it is neither, or a side is less than 1
     */
    public static PictureSize parse(String text) {
        PictureSize named = NAMES.get(text.toLowerCase(Locale.ROOT));
        if (named != null) {
            return named;
        }
        Matcher numbers = WIDTH_BY_HEIGHT.matcher(text);
        if (!numbers.matches()) {
            throw new IllegalArgumentException(
                    "'" + text + "' is not a size; write 1280x720 and the like, 720p, 1080p or 4k");
        }
        return new PictureSize(Integer.parseInt(numbers.group(1)), Integer.parseInt(numbers.group(2)));
    }

    /** Display name: 720p, 1080p, 4K, or the sides. */
    public String name() {
        return equals(ULTRA_HD) ? "4K" : equals(HD) || equals(FULL_HD) ? height + "p" : toString();
    }

    public long pixels() {
        return (long) width * height;
    }

    /** The form that {@link #parse} reads. */
    @Override
    public String toString() {
        return width + "x" + height;
    }
}
