package dev.twister.gui.model;

import dev.twister.scene.Range;
import dev.twister.scene.Scene;
import java.math.BigDecimal;
import java.math.RoundingMode;
import java.util.Optional;
import java.util.function.BiFunction;
import java.util.function.ToDoubleFunction;

/**
 * A number of a scene that a person may change.
 *
 * @param label what it is, such as "Shadow samples"
 * @param hint one sentence on what it does
 * @param allowed the values a scene may have
 * @param slid the values that a slider offers, within the allowed ones; with {@link Scale#AROUND} counted from the
 *     value
 * @param scale how the slider spreads them
 * @param decimals places after the point that are shown, 0 for whole numbers; also the finest step
 * @param unit such as "m"; may be empty
 * @param reader takes the number from a scene
 * @param writer puts the number into a scene
 */
public record NumberSetting(
        String label,
        String hint,
        Range allowed,
        Range slid,
        Scale scale,
        int decimals,
        String unit,
        ToDoubleFunction<Scene> reader,
        BiFunction<Scene, Double, Scene> writer) {
    private static final double STEPS_LINEAR = 100;

    /** That a small number has at least, where its relative size counts. */
    private static final int DIGITS = 2;

    /** How a slider's places become numbers. */
    public enum Scale {
        LINEAR,
        /** Every step multiplies; the range lies above 0. */
        LOGARITHMIC,
        /** Linear, about the value that the slider is taken at. */
        AROUND
    }

    /** The setting with the range that its slider has at a value. */
    public NumberSetting around(double value) {
        if (scale != Scale.AROUND) {
            return this;
        }
        Range near = new Range(allowed.clamp(value + slid.min()), allowed.clamp(value + slid.max()));
        return new NumberSetting(label, hint, allowed, near, Scale.LINEAR, decimals, unit, reader, writer);
    }

    /** The number's place on the slider, 0 to 1; at an end where it lies beyond. */
    public double placeOf(double number) {
        double within = slid.clamp(number);
        return switch (scale) {
            case LINEAR, AROUND -> (within - slid.min()) / (slid.max() - slid.min());
            case LOGARITHMIC -> Math.log(within / slid.min()) / Math.log(slid.max() / slid.min());
        };
    }

    /** The number at a place from 0 to 1, rounded to the decimals that are shown. */
    public double numberAt(double place) {
        double number = switch (scale) {
            case LINEAR, AROUND -> slid.min() + place * (slid.max() - slid.min());
            case LOGARITHMIC -> slid.min() * Math.pow(slid.max() / slid.min(), place);
        };
        return slid.clamp(rounded(number));
    }

    /**
     * The next number that an arrow key leads to.
     *
     * @param steps hundredths of the slider; at least the last decimal is stepped
     */
    public double stepped(double number, double steps) {
        double finest = Math.pow(10, -places(number));
        double next = numberAt(Math.clamp(placeOf(number) + steps / STEPS_LINEAR, 0, 1));
        boolean moved = Math.abs(next - number) >= finest / 2 && Math.signum(next - number) == Math.signum(steps);
        return moved ? next : slid.clamp(rounded(number + Math.signum(steps) * finest));
    }

    /** The number that many widths of the slider further, not rounded; beyond the slider's ends, too. */
    public double movedBy(double number, double widths) {
        double moved = switch (scale) {
            case LINEAR, AROUND -> number + widths * (slid.max() - slid.min());
            case LOGARITHMIC -> (number > 0 ? number : slid.min()) * Math.pow(slid.max() / slid.min(), widths);
        };
        return allowed.clamp(moved);
    }

    /** Rounded to what is shown. */
    public double rounded(double number) {
        return BigDecimal.valueOf(number)
                .setScale(places(number), RoundingMode.HALF_UP)
                .doubleValue();
    }

    /** Places after the point: more where a small number's relative size counts. */
    private int places(double number) {
        boolean small = scale == Scale.LOGARITHMIC && decimals > 0 && number > 0;
        return small ? Math.max(decimals, DIGITS - 1 - (int) Math.floor(Math.log10(number))) : decimals;
    }

    /** As it is shown: {@code 50} or {@code -1.25}. */
    public String text(double number) {
        return BigDecimal.valueOf(number)
                .setScale(places(number), RoundingMode.HALF_UP)
                .stripTrailingZeros()
                .toPlainString();
    }

    /**
     * Reads what a person typed.
     *
     * @return empty where it is no number that is allowed; {@link #complaint} says so
     */
    public Optional<Double> parse(String typed) {
        try {
            return Optional.of(new BigDecimal(typed.strip().replace(',', '.')).doubleValue())
                    .map(number -> decimals == 0 ? Math.rint(number) : number)
                    .filter(allowed::contains);
        } catch (NumberFormatException _) {
            return Optional.empty();
        }
    }

    /** What to tell a person who typed something else. */
    public String complaint(String typed) {
        return label + " is '" + typed.strip() + "', but must be a number " + allowed;
    }

    public double read(Scene scene) {
        return reader.applyAsDouble(scene);
    }

    public Scene write(Scene scene, double number) {
        return writer.apply(scene, number);
    }

    /** The label. */
    @Override
    public String toString() {
        return label;
    }
}
