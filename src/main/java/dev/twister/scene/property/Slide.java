package dev.twister.scene.property;

/**
 * A slider's ends and how it shows numbers.
 *
 * @param least at its left end; with {@link Spread#AROUND} relative to the value
 * @param decimals shown places after the point, 0 for whole numbers; also the finest step
 * @param unit such as "m"; may be empty
 */
public record Slide(double least, double most, Spread spread, int decimals, String unit) {
    /** How a slider's places become numbers. */
    public enum Spread {
        LINEAR,
        /** Every step multiplies; the range is above 0. */
        LOGARITHMIC,
        /** Linear around the value that the slider is taken at. */
        AROUND
    }

    public static final Slide PLACE = new Slide(-5, 5, Spread.AROUND, 2, "m");
    public static final Slide ANGLE = linear(-180, 180, 1, "°");
    public static final Slide SHARE = linear(0, 1, 2, "");

    public static Slide linear(double least, double most, int decimals, String unit) {
        return new Slide(least, most, Spread.LINEAR, decimals, unit);
    }

    public static Slide logarithmic(double least, double most, int decimals, String unit) {
        return new Slide(least, most, Spread.LOGARITHMIC, decimals, unit);
    }
}
