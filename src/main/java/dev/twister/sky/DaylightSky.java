package dev.twister.sky;

import dev.twister.sky.daylight.Color;
import dev.twister.sky.daylight.DaylightModel;
import dev.twister.sky.daylight.Direction;
import dev.twister.sky.daylight.Equirectangular;
import dev.twister.sky.daylight.Sun;
import dev.twister.sky.daylight.SunDisc;
import java.util.stream.IntStream;

/**
 * Draws daylight panoramas: the clear sky of Preetham et al. 1999, the CIE's overcast sky, the sun's disc at its real
 * size and a hazy ground. Computed with {@link StrictMath}, so that every machine draws the same floats.
 */
public final class DaylightSky {
    /** The most texels from straight up to straight down. */
    public static final int MAX_HEIGHT = SkyboxLimits.HEIGHT;

    private DaylightSky() {}

    /** A cloudless sky; see {@link #panorama(int, int, Daylight)}. */
    public static Skybox panorama(
            int width, int height, double sunElevationDegrees, double sunAzimuthDegrees, double turbidity) {
        return panorama(width, height, Daylight.clear(sunElevationDegrees, sunAzimuthDegrees, turbidity));
    }

    /**
     * Draws a panorama, scaled so that the sky's mean luminance is what is asked for, whatever the hour; the sun, drawn
     * with the light its disc really has in proportion, is thousands of times brighter.
     *
     * @param width 1 to 16384 texels
     * @param height 1 to {@value #MAX_HEIGHT} texels
     * @throws IllegalArgumentException where the size is outside its range
     */
    public static Skybox panorama(int width, int height, Daylight daylight) {
        if (width < 1 || height < 1 || width > SkyboxLimits.WIDTH || height > MAX_HEIGHT) {
            throw new IllegalArgumentException("a panorama of " + width + " x " + height + " texels; 1 x 1 to "
                    + SkyboxLimits.WIDTH + " x " + MAX_HEIGHT + " can be drawn");
        }
        Sun sun = new Sun(
                StrictMath.toRadians(daylight.sunElevationDegrees()),
                StrictMath.toRadians(daylight.sunAzimuthDegrees()),
                daylight.turbidity());
        DaylightModel model = new DaylightModel(daylight, sun);
        double scale = daylight.meanSkyRadiance() / model.meanSkyLuminance();

        float[] radiance = new float[3 * width * height];
        IntStream.range(0, height).parallel().forEach(row -> drawRow(model, scale, row, width, height, radiance));
        if (!daylight.sunDisc()) {
            return new Skybox(width, height, radiance);
        }
        Color disc = sun.radiance().times(scale * DaylightModel.sunThroughCloud(daylight.cloudCover()));
        SunDisc.add(sun.direction(), disc, width, height, radiance);
        return new Skybox(width, height, radiance);
    }

    private static void drawRow(DaylightModel model, double scale, int row, int width, int height, float[] radiance) {
        double elevation = Equirectangular.elevation(row, height);
        double up = StrictMath.sin(elevation);
        double horizontal = StrictMath.cos(elevation);
        for (int column = 0; column < width; column++) {
            double longitude = Equirectangular.longitude(column, width);
            Direction direction =
                    new Direction(horizontal * StrictMath.sin(longitude), up, horizontal * StrictMath.cos(longitude));
            Color light = model.radiance(direction).times(scale);
            int target = 3 * (row * width + column);
            radiance[target] = (float) light.red();
            radiance[target + 1] = (float) light.green();
            radiance[target + 2] = (float) light.blue();
        }
    }
}
