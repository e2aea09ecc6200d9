package dev.twister.sky;

/**
 * The daylight panoramas that come with Twister, in the folder {@code skyboxes}, and how each is drawn. The sun's disc
 * is left out: its glow remains, and reflections have no specks.
 */
public enum ShippedSky {
    /**
     * Before noon, the sun behind the default camera's left shoulder: it lights what one sees and shows in reflections.
     */
    DAY("day.hdr", new Daylight(42, -140, 3, 0, 0.35, 0.85, false)),
    /** The sun low and to the right of the default view. */
    SUNSET("sunset.hdr", new Daylight(4, 35, 4, 0, 0.2, 0.35, false)),
    /** An even gray, without shadows to speak of. */
    OVERCAST("overcast.hdr", new Daylight(40, -140, 4, 0.92, 0.3, 0.8, false));

    /** Texels around the horizon of every shipped panorama. */
    public static final int WIDTH = 1024;

    /** Texels from straight up to straight down of every shipped panorama. */
    public static final int HEIGHT = 512;

    private final String fileName;

    @SuppressWarnings("ImmutableEnumChecker") // a record of numbers
    private final Daylight daylight;

    ShippedSky(String fileName, Daylight daylight) {
        this.fileName = fileName;
        this.daylight = daylight;
    }

    /** The file's name in the folder {@code skyboxes}. */
    public String fileName() {
        return fileName;
    }

    public Daylight daylight() {
        return daylight;
    }

    /** Draws the panorama as it is shipped. */
    public Skybox draw() {
        return DaylightSky.panorama(WIDTH, HEIGHT, daylight);
    }
}
