package dev.twister.gui.property;

import dev.twister.scene.Rgb;

/**
 * A light's color as the user sets it: a hue that a color chooser can show, and a strength.
 *
 * @param hue its largest channel is 1
 * @param strength 0 or more
 */
public record Radiance(Rgb hue, double strength) {
    private static final Rgb WHITE = new Rgb(1, 1, 1);

    /** A light that is out counts as white. */
    public static Radiance of(Rgb color) {
        double strength = Math.max(color.red(), Math.max(color.green(), color.blue()));
        if (strength == 0) {
            return new Radiance(WHITE, 0);
        }
        return new Radiance(
                new Rgb(color.red() / strength, color.green() / strength, color.blue() / strength), strength);
    }

    /** The same strength in the hue of another color, however dark that is; black is white. */
    public Radiance withHueOf(Rgb color) {
        return new Radiance(of(color).hue(), strength);
    }

    public Rgb color() {
        return new Rgb(hue.red() * strength, hue.green() * strength, hue.blue() * strength);
    }
}
