package dev.twister.sky;

/** A unit vector: x right, y up, z ahead of the default camera. */
record Direction(double x, double y, double z) {
    /** @param azimuth in radians, 0 along +z, a quarter turn along +x */
    static Direction of(double elevation, double azimuth) {
        double horizontal = StrictMath.cos(elevation);
        return new Direction(
                horizontal * StrictMath.sin(azimuth), StrictMath.sin(elevation), horizontal * StrictMath.cos(azimuth));
    }

    double dot(Direction other) {
        return x * other.x + y * other.y + z * other.z;
    }
}
