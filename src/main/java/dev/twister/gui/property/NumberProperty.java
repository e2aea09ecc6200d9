package dev.twister.gui.property;

import java.util.function.BiFunction;
import java.util.function.Function;
import java.util.function.ToDoubleFunction;
import java.util.function.UnaryOperator;

/**
 * A numeric property of a scene or of a part of it, with all that the panel needs. Lists of them are the tables from
 * which the panel's rows are made.
 *
 * @param label such as "Shadow samples"
 * @param hint one sentence for the tooltip
 * @param key leads to its row, such as "Alt+S"; empty for none
 * @param getter reads the number
 * @param wither returns a copy with another number
 */
public record NumberProperty<T>(
        String label,
        String hint,
        String key,
        NumberScale scale,
        ToDoubleFunction<T> getter,
        BiFunction<T, Double, T> wither) {
    public double read(T from) {
        return getter.applyAsDouble(from);
    }

    public T write(T to, double number) {
        return wither.apply(to, number);
    }

    /**
     * The same number, seen from a whole that has this part.
     *
     * @param part finds the part
     * @param editor returns a copy of the whole with one or more of such parts changed
     */
    public <W> NumberProperty<W> in(Function<W, T> part, BiFunction<W, UnaryOperator<T>, W> editor) {
        return new NumberProperty<>(
                label,
                hint,
                key,
                scale,
                whole -> read(part.apply(whole)),
                (whole, number) -> editor.apply(whole, old -> write(old, number)));
    }

    /** The message for a typed text that is no allowed number. */
    public String complaint(String typed) {
        return label + " is '" + typed.strip() + "', but must be a number " + scale.allowed();
    }

    @Override
    public String toString() {
        return label;
    }
}
