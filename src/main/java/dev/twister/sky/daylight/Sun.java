package dev.twister.sky.daylight;

/** The sun as seen through the air: a disc of one brightness, reddened and dimmed towards the horizon. */
public final class Sun {
    /** Half the sun's mean diameter of 0.533 degrees, in radians. */
    static final double ANGULAR_RADIUS = StrictMath.toRadians(0.533 / 2);

    /** In steradians: 2 pi (1 - cos radius), written so that nothing cancels. */
    public static final double SOLID_ANGLE =
            4 * Math.PI * StrictMath.sin(ANGULAR_RADIUS / 2) * StrictMath.sin(ANGULAR_RADIUS / 2);

    /** Illuminance of the sun before it meets the air, in klx (solar illuminance constant, IES 1984: 127.5 klx). */
    private static final double KILOLUX_ABOVE_THE_AIR = 127.5;

    /** Wavelengths in micrometers that stand for sRGB's three primaries. */
    private static final double RED = 0.611;

    private static final double GREEN = 0.549;
    private static final double BLUE = 0.465;

    private final Direction direction;
    private final Color radiance;

    /**
     * @param elevation of the disc's center in radians
     * @param azimuth in radians, 0 along +z
     * @param turbidity 2 to 10
     */
    public Sun(double elevation, double azimuth, double turbidity) {
        direction = Direction.of(elevation, azimuth);
        radiance = new Color(
                        transmittance(RED, elevation, turbidity),
                        transmittance(GREEN, elevation, turbidity),
                        transmittance(BLUE, elevation, turbidity))
                .times(KILOLUX_ABOVE_THE_AIR / SOLID_ANGLE);
    }

    public Direction direction() {
        return direction;
    }

    /** Of the disc, linear sRGB in kcd/m². */
    public Color radiance() {
        return radiance;
    }

    /**
     * The part of the light of one wavelength that gets through: Rayleigh scattering and Ångström's haze with the
     * coefficients of Preetham et al. 1999, appendix A.1. Ozone, mixed gases and water vapour, of which the visible
     * loses a few per cent, are left out.
     */
    private static double transmittance(double micrometers, double elevation, double turbidity) {
        double zenithDegrees = 90 - StrictMath.toDegrees(elevation);
        double airMass = 1 / (StrictMath.sin(elevation) + 0.15 * StrictMath.pow(93.885 - zenithDegrees, -1.253));
        double rayleigh = 0.008735 * StrictMath.pow(micrometers, -4.08);
        double haze = (0.04608 * turbidity - 0.04586) * StrictMath.pow(micrometers, -1.3);
        return StrictMath.exp(-(rayleigh + haze) * airMass);
    }
}
