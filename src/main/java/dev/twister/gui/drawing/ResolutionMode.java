package dev.twister.gui.drawing;

import dev.twister.image.PictureSize;
import dev.twister.scene.property.SceneProperties;
import java.util.Optional;

/** How large the picture is drawn; it is scaled to fit the window. */
public enum ResolutionMode {
    WINDOW(Optional.empty()),
    HD(Optional.of(PictureSize.HD)),
    FULL_HD(Optional.of(PictureSize.FULL_HD)),
    ULTRA_HD(Optional.of(PictureSize.ULTRA_HD));

    @SuppressWarnings("ImmutableEnumChecker") // of a record of numbers
    private final Optional<PictureSize> fixed;

    ResolutionMode(Optional<PictureSize> fixed) {
        this.fixed = fixed;
    }

    /** The displayed name, such as "720p". */
    public String label() {
        return fixed.map(PictureSize::name).orElse("window size");
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
        return (int) SceneProperties.WIDTH.range().clamp(Math.floor(pixels));
    }
}
