package dev.twister.sky;

/**
 * What a daylight sky depends on.
 *
 * @param sunElevationDegrees of the sun's center above the horizon, 0 to 90
 * @param sunAzimuthDegrees where the sun stands: 0 straight ahead of the default camera (+z), 90 to its right (+x); any
 *     finite number
 * @param turbidity how hazy the air is: 2 very clear, 3 clear, 6 hazy, 10 nearly fog; 2 to 10
 * @param cloudCover 0 a clear sky, 1 an even layer of cloud that hides the sun; between the two a mixture
 * @param groundAlbedo the part of the light that the ground reflects, 0 to 1; grass and soil about 0.2
 * @param meanSkyRadiance the mean luminance of the sky, the sun's disc aside, above 0 to 100: how bright a picture at
 *     exposure 0 becomes
 * @param sunDisc whether the sun itself is drawn, at its real size and thousands of times brighter than the sky; at a
 *     modest size it is a texel or two, whose reflections in small spheres are specks
 */
public record Daylight(
        double sunElevationDegrees,
        double sunAzimuthDegrees,
        double turbidity,
        double cloudCover,
        double groundAlbedo,
        double meanSkyRadiance,
        boolean sunDisc) {
    /** What the mean of the sky usually is: mid tones of a picture at exposure 0. */
    public static final double USUAL_MEAN_SKY_RADIANCE = 0.4;

    public static final double MAX_ELEVATION_DEGREES = 90;
    public static final double MIN_TURBIDITY = 2;
    public static final double MAX_TURBIDITY = 10;
    public static final double MAX_MEAN_SKY_RADIANCE = 100;

    private static final double USUAL_GROUND_ALBEDO = 0.2;

    /** @throws IllegalArgumentException where a value is outside its range, naming it and the range */
    public Daylight {
        check("sun elevation in degrees", sunElevationDegrees, 0, MAX_ELEVATION_DEGREES);
        if (!Double.isFinite(sunAzimuthDegrees)) {
            throw new IllegalArgumentException(
                    "the sun azimuth in degrees is " + sunAzimuthDegrees + "; any finite number");
        }
        check("turbidity", turbidity, MIN_TURBIDITY, MAX_TURBIDITY);
        check("cloud cover", cloudCover, 0, 1);
        check("ground albedo", groundAlbedo, 0, 1);
        check("mean sky radiance", meanSkyRadiance, Double.MIN_NORMAL, MAX_MEAN_SKY_RADIANCE);
    }

    /** A cloudless sky over grass and soil. */
    public static Daylight clear(double sunElevationDegrees, double sunAzimuthDegrees, double turbidity) {
        return new Daylight(sunElevationDegrees, sunAzimuthDegrees, turbidity, 0, USUAL_GROUND_ALBEDO);
    }

    /** A sky of the usual brightness, with the sun in it. */
    public Daylight(
            double sunElevationDegrees,
            double sunAzimuthDegrees,
            double turbidity,
            double cloudCover,
            double groundAlbedo) {
        this(
                sunElevationDegrees,
                sunAzimuthDegrees,
                turbidity,
                cloudCover,
                groundAlbedo,
                USUAL_MEAN_SKY_RADIANCE,
                true);
    }

    private static void check(String name, double value, double least, double most) {
        // Written so that NaN fails too.
        if (!(value >= least && value <= most)) {
            throw new IllegalArgumentException("the " + name + " is " + value + "; " + least + " to " + most);
        }
    }
}
