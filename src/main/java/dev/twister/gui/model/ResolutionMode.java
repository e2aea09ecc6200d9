package dev.twister.gui.model;

import dev.twister.bench.PictureSize;
import dev.twister.scene.SceneLimits;
import java.util.Optional;

/** How large the picture is drawn; it is scaled to fit the window. */
public enum ResolutionMode {
    WINDOW("window size", Optional.empty()),
    HD("720p", Optional.of(PictureSize.HD)),
    FULL_HD("1080p", Optional.of(PictureSize.FULL_HD)),
    ULTRA_HD("4K", Optional.of(PictureSize.ULTRA_HD));

    private final String label;

    @SuppressWarnings("ImmutableEnumChecker") // of a record of numbers
    private final Optional<PictureSize> fixed;

    ResolutionMode(String label, Optional<PictureSize> fixed) {
        this.label = label;
        this.fixed = fixed;
    }

    /** For a person, such as "720p". */
    public String label() {
        return label;
    }

    /**
     * The picture's size.
     *
     * @param areaWidth of the window's area for the picture, in the screen's pixels; any number
     * @param areaHeight as the width
     */
    public PictureSize size(double areaWidth, double areaHeight) {
        return fixed.orElseGet(() -> new PictureSize(side(areaWidth), side(areaHeight)));
    }

    private static int side(double pixels) {
        return (int) SceneLimits.SIDE.clamp(Math.floor(pixels));
    }
}
