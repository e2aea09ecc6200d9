package dev.twister.oracle;

/** A half-line; the direction is a unit vector. */
record Ray(Vector origin, Vector direction) {
    Vector at(double distance) {
        return origin.plus(direction.times(distance));
    }
}
