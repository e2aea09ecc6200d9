package dev.twister.cli.option;

import dev.twister.cli.file.BadInputException;
import dev.twister.scene.property.Property;
import dev.twister.scene.property.Range;
import java.math.BigDecimal;
import java.util.Optional;

/** Numbers that options take, both ends inside. */
public final class Ranges {
    private Ranges() {}

    public static int check(String option, int value, int least, int most) {
        if (value < least || value > most) {
            throw outside(option, Integer.toString(value), Integer.toString(least), Integer.toString(most));
        }
        return value;
    }

    public static double check(String option, double value, double least, double most) {
        // Written so that NaN fails too.
        if (!(value >= least && value <= most)) {
            throw outside(option, Double.toString(value), plain(least), plain(most));
        }
        return value;
    }

    public static double check(String option, double value, Range range) {
        return check(option, value, range.min(), range.max());
    }

    /** A part of a scene with what an option says of a property, where it is given. */
    static <T, V> T over(T part, String option, Optional<V> given, Property<T, V> property) {
        given.ifPresent(value -> {
            if (value instanceof Number number && !property.range().contains(number.doubleValue())) {
                throw outside(
                        option,
                        value.toString(),
                        plain(property.range().min()),
                        plain(property.range().max()));
            }
        });
        return given.map(value -> property.wither().apply(part, value)).orElse(part);
    }

    private static BadInputException outside(String option, String value, String least, String most) {
        return new BadInputException(option + " is " + value + ", but must be from " + least + " to " + most);
    }

    private static String plain(double number) {
        return BigDecimal.valueOf(number).stripTrailingZeros().toPlainString();
    }
}
