package dev.twister.gui.property;

import dev.twister.scene.property.Range;
import dev.twister.scene.property.Slide;
import dev.twister.scene.property.Slide.Spread;
import java.math.BigDecimal;
import java.math.RoundingMode;
import java.util.Optional;

/**
 * The values that a number may have, and how a slider and a text field show them.
 *
 * @param allowed the values that a scene may have
 * @param slid the values of the slider, within the allowed ones; with {@link Spread#AROUND} relative to the value
 * @param spread how the slider spreads them
 * @param decimals shown places after the point, 0 for whole numbers; also the finest step
 * @param unit such as "m"; may be empty
 */
public record NumberScale(Range allowed, Range slid, Spread spread, int decimals, String unit) {
    private static final double STEPS_LINEAR = 100;

    /** Significant digits of a small number on a logarithmic slider, at least. */
    private static final int DIGITS = 2;

    /** The scale of a property's slider. */
    public NumberScale(Range allowed, Slide slide) {
        this(allowed, new Range(slide.least(), slide.most()), slide.spread(), slide.decimals(), slide.unit());
    }

    /** The scale of the slider at a value. */
    public NumberScale around(double value) {
        if (spread != Spread.AROUND) {
            return this;
        }
        Range near = new Range(allowed.clamp(value + slid.min()), allowed.clamp(value + slid.max()));
        return new NumberScale(allowed, near, Spread.LINEAR, decimals, unit);
    }

    /** The number's place on the slider, 0 to 1; clamped to the ends. */
    public double placeOf(double number) {
        double within = slid.clamp(number);
        return switch (spread) {
            case LINEAR, AROUND -> (within - slid.min()) / (slid.max() - slid.min());
            case LOGARITHMIC -> Math.log(within / slid.min()) / Math.log(slid.max() / slid.min());
        };
    }

    /** The number at a place from 0 to 1, rounded to the shown decimals. */
    public double numberAt(double place) {
        double number = switch (spread) {
            case LINEAR, AROUND -> slid.min() + place * (slid.max() - slid.min());
            case LOGARITHMIC -> slid.min() * Math.pow(slid.max() / slid.min(), place);
        };
        return slid.clamp(rounded(number));
    }

    /**
     * The number that an arrow key leads to; at the slider's end or beyond it, the number itself.
     *
     * @param steps steps of 1 % of the slider; the step is at least the last decimal
     */
    public double stepped(double number, double steps) {
        if (steps > 0 ? number >= slid.max() : number <= slid.min()) {
            return number;
        }
        double finest = Math.pow(10, -places(number));
        double next = numberAt(Math.clamp(placeOf(number) + steps / STEPS_LINEAR, 0, 1));
        boolean moved = Math.abs(next - number) >= finest / 2 && Math.signum(next - number) == Math.signum(steps);
        return moved ? next : slid.clamp(rounded(number + Math.signum(steps) * finest));
    }

    /** The number moved by a multiple of the slider's width, not rounded and not bounded by the slider's ends. */
    public double movedBy(double number, double widths) {
        double moved = switch (spread) {
            case LINEAR, AROUND -> number + widths * (slid.max() - slid.min());
            case LOGARITHMIC -> (number > 0 ? number : slid.min()) * Math.pow(slid.max() / slid.min(), widths);
        };
        return allowed.clamp(moved);
    }

    /** Rounds to the shown decimals. */
    public double rounded(double number) {
        return decimal(number).doubleValue();
    }

    /** The number as it is shown: {@code 50} or {@code -1.25}. */
    public String text(double number) {
        return decimal(number).stripTrailingZeros().toPlainString();
    }

    /** Reads a typed number or sum; empty if it is none or not allowed. */
    public Optional<Double> parse(String typed) {
        return Arithmetic.value(typed)
                .map(number -> decimals == 0 ? Math.rint(number) : number)
                .filter(allowed::contains);
    }

    private BigDecimal decimal(double number) {
        return BigDecimal.valueOf(number).setScale(places(number), RoundingMode.HALF_UP);
    }

    private int places(double number) {
        boolean small = spread == Spread.LOGARITHMIC && decimals > 0 && number > 0;
        return small ? Math.max(decimals, DIGITS - 1 - (int) Math.floor(Math.log10(number))) : decimals;
    }
}
