package dev.twister.gui.edit;

import dev.twister.scene.Vector3;
import java.util.Locale;

/** An axis of the scene. */
public enum Axis {
    X(new Vector3(1, 0, 0)),
    Y(new Vector3(0, 1, 0)),
    Z(new Vector3(0, 0, 1));

    @SuppressWarnings("ImmutableEnumChecker") // a record of numbers
    private final Vector3 direction;

    Axis(Vector3 direction) {
        this.direction = direction;
    }

    /** The axis's displayed name. */
    public String label() {
        return name().toLowerCase(Locale.ROOT);
    }

    /** The point that number of meters along from another one. */
    public Vector3 from(Vector3 place, double meters) {
        return place.plus(direction.times(meters));
    }

    /** The one after it; Z is followed by X. */
    public Axis next() {
        return switch (this) {
            case X -> Y;
            case Y -> Z;
            case Z -> X;
        };
    }

    /** A vector with another part along this axis. */
    public Vector3 with(Vector3 vector, double part) {
        return switch (this) {
            case X -> new Vector3(part, vector.y(), vector.z());
            case Y -> new Vector3(vector.x(), part, vector.z());
            case Z -> new Vector3(vector.x(), vector.y(), part);
        };
    }

    /** A vector's part along this axis. */
    public double of(Vector3 vector) {
        return vector.dot(direction);
    }
}
