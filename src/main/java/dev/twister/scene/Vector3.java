package dev.twister.scene;

import java.util.function.DoubleBinaryOperator;
import java.util.function.DoubleUnaryOperator;

/** A place or a displacement in meters; x points right, y up, z into the picture. */
public record Vector3(double x, double y, double z) {
    public static final Vector3 ZERO = new Vector3(0, 0, 0);

    public Vector3 plus(Vector3 other) {
        return new Vector3(x + other.x, y + other.y, z + other.z);
    }

    public Vector3 minus(Vector3 other) {
        return new Vector3(x - other.x, y - other.y, z - other.z);
    }

    public Vector3 times(double factor) {
        return new Vector3(x * factor, y * factor, z * factor);
    }

    public double dot(Vector3 other) {
        return x * other.x + y * other.y + z * other.z;
    }

    public Vector3 cross(Vector3 other) {
        return new Vector3(y * other.z - z * other.y, z * other.x - x * other.z, x * other.y - y * other.x);
    }

    public double length() {
        return Math.sqrt(dot(this));
    }

    /** The vector of length 1 in the same direction; not a number where the length is 0. */
    public Vector3 normalized() {
        double length = length();
        return new Vector3(x / length, y / length, z / length);
    }

    /** Each coordinate changed. */
    public Vector3 map(DoubleUnaryOperator change) {
        return new Vector3(change.applyAsDouble(x), change.applyAsDouble(y), change.applyAsDouble(z));
    }

    /** Each coordinate combined with the other one's, such as by {@link Math#min}. */
    public Vector3 map(Vector3 other, DoubleBinaryOperator combine) {
        return new Vector3(
                combine.applyAsDouble(x, other.x),
                combine.applyAsDouble(y, other.y),
                combine.applyAsDouble(z, other.z));
    }
}
