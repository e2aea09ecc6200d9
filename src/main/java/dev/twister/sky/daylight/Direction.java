package dev.twister.sky.daylight;

/** A unit vector: x right, y up, z ahead of the default camera. */
public record Direction(double x, double y, double z) {
    /**
     * The direction at angles in radians.
     *
     * @param azimuth 0 along +z, a quarter turn along +x
     */
    public static Direction of(double elevation, double azimuth) {
        double horizontal = StrictMath.cos(elevation);
        return new Direction(
                horizontal * StrictMath.sin(azimuth), StrictMath.sin(elevation), horizontal * StrictMath.cos(azimuth));
    }

    public double dot(Direction other) {
        return x * other.x + y * other.y + z * other.z;
    }
}
