package dev.twister.sky.daylight;

import dev.twister.sky.Skybox;

/**
 * Adds the sun's disc to a panorama so that its light comes out exact at every size: equal shares of the disc are put
 * into the texels they fall on, so a texel gets the disc's brightness times the part of its solid angle that the disc
 * covers.
 */
public final class SunDisc {
    private static final double SHARES_PER_TEXEL = 64;
    private static final double FEWEST_SHARES = 4096;
    private static final double MOST_SHARES = 1 << 20;
    private static final double GOLDEN_ANGLE = Math.PI * (3 - StrictMath.sqrt(5));

    private SunDisc() {}

    /**
     * Adds what of the disc is above the horizon.
     *
     * @param radiance of the disc, in the panorama's unit
     * @param panorama {@code 3 * width * height} floats as in {@link Skybox}
     */
    public static void add(Direction sun, Color radiance, int width, int height, float[] panorama) {
        double texelsAcross = 2 * Sun.ANGULAR_RADIUS * height / Math.PI;
        int shares = (int) Math.clamp(SHARES_PER_TEXEL * texelsAcross * texelsAcross, FEWEST_SHARES, MOST_SHARES);
        Direction side = perpendicular(sun);
        Direction other = cross(sun, side);
        for (int i = 0; i < shares; i++) {
            // Vogel's sunflower spreads points evenly over a disc, here over the disc's area on the sphere.
            double oneMinusCos = (i + 0.5) / shares * Sun.SOLID_ANGLE / (2 * Math.PI);
            double cos = 1 - oneMinusCos;
            double sin = StrictMath.sqrt(oneMinusCos * (1 + cos));
            double across = sin * StrictMath.cos(i * GOLDEN_ANGLE);
            double up = sin * StrictMath.sin(i * GOLDEN_ANGLE);
            Direction point = new Direction(
                    cos * sun.x() + across * side.x() + up * other.x(),
                    cos * sun.y() + across * side.y() + up * other.y(),
                    cos * sun.z() + across * side.z() + up * other.z());
            if (point.y() >= 0) {
                int row = Equirectangular.row(point, height);
                int texel = row * width + Equirectangular.column(point, width);
                double part = Sun.SOLID_ANGLE / shares / Equirectangular.solidAngle(row, width, height);
                panorama[3 * texel] += (float) (part * radiance.red());
                panorama[3 * texel + 1] += (float) (part * radiance.green());
                panorama[3 * texel + 2] += (float) (part * radiance.blue());
            }
        }
    }

    private static Direction perpendicular(Direction to) {
        // Never parallel to it: the axis that it has the least of.
        Direction axis = Math.abs(to.y()) < 0.5 ? new Direction(0, 1, 0) : new Direction(1, 0, 0);
        Direction product = cross(axis, to);
        double length = StrictMath.sqrt(product.dot(product));
        return new Direction(product.x() / length, product.y() / length, product.z() / length);
    }

    private static Direction cross(Direction a, Direction b) {
        return new Direction(
                a.y() * b.z() - a.z() * b.y(), a.z() * b.x() - a.x() * b.z(), a.x() * b.y() - a.y() * b.x());
    }
}
