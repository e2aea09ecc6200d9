package dev.twister.sky.daylight;

/**
 * Where directions lie in a panorama: {@code u = 0.5 + atan2(x, z) / (2 pi)}, {@code v = 0.5 - asin(y) / pi}, a texel's
 * center at {@code ((column + 0.5) / width, (row + 0.5) / height)}.
 */
public final class Equirectangular {
    private Equirectangular() {}

    /** The angle {@code atan2(x, z)} at a column's center, in radians. */
    public static double longitude(int column, int width) {
        return 2 * Math.PI * ((column + 0.5) / width - 0.5);
    }

    /** The angle above the horizon at a row's center, in radians. */
    public static double elevation(int row, int height) {
        return Math.PI * (0.5 - (row + 0.5) / height);
    }

    public static int column(Direction direction, int width) {
        double u = 0.5 + StrictMath.atan2(direction.x(), direction.z()) / (2 * Math.PI);
        return Math.min((int) (u * width), width - 1);
    }

    public static int row(Direction direction, int height) {
        double v = 0.5 - StrictMath.asin(Math.clamp(direction.y(), -1, 1)) / Math.PI;
        return Math.min((int) (v * height), height - 1);
    }

    /** Of each texel in a row, in steradians. */
    public static double solidAngle(int row, int width, int height) {
        double top = Math.PI * (0.5 - (double) row / height);
        double bottom = Math.PI * (0.5 - (row + 1.0) / height);
        return 2 * Math.PI / width * (StrictMath.sin(top) - StrictMath.sin(bottom));
    }
}
