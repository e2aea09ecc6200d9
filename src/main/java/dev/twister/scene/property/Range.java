package dev.twister.scene.property;

import dev.twister.scene.SceneException;
import dev.twister.scene.Vector3;
import java.math.BigDecimal;

/**
 * The numbers that a field may have, both ends inside.
 *
 * @param unit what is counted, for a person; may be empty
 */
public record Range(double min, double max, String unit) {
    public Range(double min, double max) {
        this(min, max, "");
    }

    public boolean contains(double number) {
        return number >= min && number <= max;
    }

    /** The number, or the end that it lies beyond; NaN stays NaN. */
    public double clamp(double number) {
        return Math.min(max, Math.max(min, number));
    }

    /** Each coordinate clamped. */
    public Vector3 clamp(Vector3 vector) {
        return vector.map(this::clamp);
    }

    /**
     * Checks a number.
     *
     * @param name of the value, for the message
     * @throws SceneException if it is not in this range; NaN never is
     */
    public void require(String name, double number) {
        if (!contains(number)) {
            throw new SceneException(name + " is " + shown(number) + ", but must be a number " + this);
        }
    }

    /** Checks each coordinate, as {@link #require(String, double)}. */
    public void require(String name, Vector3 vector) {
        require(name + ".x", vector.x());
        require(name + ".y", vector.y());
        require(name + ".z", vector.z());
    }

    /** {@code from -90 to 90 degrees}. */
    @Override
    public String toString() {
        return "from " + plain(min) + " to " + plain(max) + (unit.isEmpty() ? "" : " " + unit);
    }

    private static String shown(double number) {
        return Double.isFinite(number) ? plain(number) : String.valueOf(number);
    }

    private static String plain(double number) {
        return BigDecimal.valueOf(number).stripTrailingZeros().toPlainString();
    }
}
