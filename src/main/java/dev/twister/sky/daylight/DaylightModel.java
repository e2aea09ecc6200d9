package dev.twister.sky.daylight;

import dev.twister.sky.Daylight;

/** The light of sky and ground in any direction, without the sun's disc, in kcd/m². */
public final class DaylightModel {
    /** How soon the haze swallows the ground towards the horizon; it hides half of it at 3 degrees below. */
    private static final double HAZE = 0.002;

    /** The hue of soil and dry grass, of luminance 1. */
    private static final Color SOIL = new Color(1.15, 0.98, 0.75);

    /** Optical thickness of a cloud cover of 0.5. */
    private static final double THICKNESS_OF_HALF_COVER = 10;

    /** Directions of the sums over the sky: fine enough for a smooth function, few enough to cost nothing. */
    private static final int SUM_COLUMNS = 128;

    private static final int SUM_ROWS = 64;

    private final PreethamSky clearSky;
    private final Direction sun;
    private final double cloudCover;
    private final double cloudZenithLuminance;
    private final Color ground;
    private final double meanSkyLuminance;

    public DaylightModel(Daylight daylight, Sun sun) {
        double elevation = StrictMath.toRadians(daylight.sunElevationDegrees());
        this.clearSky = new PreethamSky(Math.PI / 2 - elevation, daylight.turbidity());
        this.sun = sun.direction();
        this.cloudCover = daylight.cloudCover();
        this.cloudZenithLuminance = cloudZenithLuminance(elevation);

        Color irradiance =
                sun.radiance().times(sunThroughCloud(cloudCover) * Sun.SOLID_ANGLE * StrictMath.sin(elevation));
        double luminance = 0;
        for (int row = 0; row < SUM_ROWS / 2; row++) {
            double solidAngle = Equirectangular.solidAngle(row, SUM_COLUMNS, SUM_ROWS);
            double rowElevation = Equirectangular.elevation(row, SUM_ROWS);
            for (int column = 0; column < SUM_COLUMNS; column++) {
                Direction direction = Direction.of(rowElevation, Equirectangular.longitude(column, SUM_COLUMNS));
                Color light = sky(direction).times(solidAngle);
                irradiance = irradiance.plus(light.times(direction.y()));
                luminance += light.luminance();
            }
        }
        meanSkyLuminance = luminance / (2 * Math.PI);
        ground = irradiance.times(SOIL).times(daylight.groundAlbedo() / Math.PI);
    }

    /** The mean over the upper half, each direction counting the same. */
    public double meanSkyLuminance() {
        return meanSkyLuminance;
    }

    /**
     * The part of the sun's light that gets through a layer of cloud, whose thickness grows without bound as it closes.
     */
    public static double sunThroughCloud(double cloudCover) {
        return cloudCover < 1 ? StrictMath.exp(-THICKNESS_OF_HALF_COVER * cloudCover / (1 - cloudCover)) : 0;
    }

    public Color radiance(Direction direction) {
        return direction.y() >= 0 ? sky(direction) : groundInHaze(direction);
    }

    private Color sky(Direction direction) {
        Color clear = clearSky.radiance(direction.y(), direction.dot(sun));
        return clear.mixedWith(Color.gray(cloudLuminance(direction.y())), cloudCover);
    }

    /** The standard overcast sky, three times as bright overhead as on the horizon (Moon and Spencer 1942, CIE). */
    private double cloudLuminance(double cosTheta) {
        return cloudZenithLuminance * (1 + 2 * cosTheta) / 3;
    }

    /** Luminance of an overcast sky straight up, in kcd/m² (Krochmann 1963, DIN 5034). */
    private static double cloudZenithLuminance(double sunElevation) {
        return 0.123 + 8.6 * StrictMath.sin(sunElevation);
    }

    /** A dull ground lit by sun and sky, behind ever more haze of the horizon's color the flatter one looks at it. */
    private Color groundInHaze(Direction direction) {
        double horizontal = StrictMath.sqrt(Math.max(0, 1 - direction.y() * direction.y()));
        // Straight down there is no direction on the horizon, and no haze either.
        Direction horizon = horizontal > 0
                ? new Direction(direction.x() / horizontal, 0, direction.z() / horizontal)
                : new Direction(0, 0, 1);
        double seen = StrictMath.exp(HAZE * (1 - 1 / (direction.y() * direction.y())));
        return sky(horizon).mixedWith(ground, seen);
    }
}
