package dev.twister.scene;

import static java.util.Objects.requireNonNull;

import dev.twister.scene.property.Copied;
import java.util.List;

/**
 * The value of a property at a time of a film.
 *
 * @param seconds since the film's beginning, 0 or more
 * @param value one number, or three
 * @param easing how it changes from here to the next keyframe
 */
@Copied
public record Keyframe(double seconds, List<Double> value, Easing easing) implements KeyframeCopy.With {
    /** Has the values of the fields that a file leaves out. */
    public static final Keyframe DEFAULT = new Keyframe(0, List.of(0.0), Easing.SMOOTH);

    public Keyframe {
        requireNonNull(easing, "easing");
        value = List.copyOf(value);
    }

    /** A number at a time, which changes smoothly. */
    public static Keyframe of(double seconds, double number) {
        return new Keyframe(seconds, List.of(number), Easing.SMOOTH);
    }

    /** A position at a time, which changes smoothly. */
    public static Keyframe of(double seconds, Vector3 position) {
        return new Keyframe(seconds, List.of(position.x(), position.y(), position.z()), Easing.SMOOTH);
    }

    /** A color at a time, which changes smoothly. */
    public static Keyframe of(double seconds, Rgb color) {
        return new Keyframe(seconds, List.of(color.red(), color.green(), color.blue()), Easing.SMOOTH);
    }
}
