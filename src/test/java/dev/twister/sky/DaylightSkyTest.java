package dev.twister.sky;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;

import dev.twister.sky.daylight.Color;
import dev.twister.sky.daylight.Direction;
import dev.twister.sky.daylight.Equirectangular;
import dev.twister.sky.daylight.PreethamSky;
import dev.twister.sky.daylight.Sun;
import dev.twister.sky.daylight.SunDisc;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.DoubleRange;
import net.jqwik.api.constraints.IntRange;
import org.assertj.core.data.Percentage;
import org.junit.jupiter.api.Test;

class DaylightSkyTest {
    private static final int WIDTH = 128;
    private static final int HEIGHT = 64;

    @Property(tries = 150)
    void isFiniteAndNowhereNegative(
            @ForAll @DoubleRange(min = 0, max = 90) double elevation,
            @ForAll @DoubleRange(min = -360, max = 360) double azimuth,
            @ForAll @DoubleRange(min = 2, max = 10) double turbidity,
            @ForAll @DoubleRange(min = 0, max = 1) double cloudCover,
            @ForAll @IntRange(min = 1, max = 40) int width,
            @ForAll @IntRange(min = 1, max = 20) int height) {
        Skybox sky = DaylightSky.panorama(width, height, new Daylight(elevation, azimuth, turbidity, cloudCover, 0.3));
        for (float radiance : sky.radiance()) {
            assertThat(radiance >= 0 && radiance <= Float.MAX_VALUE).isTrue();
        }
    }

    @Test
    void zenithLuminanceIsThePapers() {
        // Y_z = (4.0453 T - 4.9710) tan chi - 0.2155 T + 2.4192 for T = 3, sun at 60 degrees.
        double zenithAngle = Math.PI / 6;
        double chi = (4.0 / 9 - 3.0 / 120) * (Math.PI - 2 * zenithAngle);
        double expected = (4.0453 * 3 - 4.9710) * Math.tan(chi) - 0.2155 * 3 + 2.4192;
        assertThat(PreethamSky.zenithLuminance(zenithAngle, 3)).isCloseTo(expected, within(1e-9));
        assertThat(new PreethamSky(zenithAngle, 3)
                        .radiance(1, Math.cos(zenithAngle))
                        .luminance())
                .isCloseTo(expected, within(1e-3));
    }

    @Test
    void theSunIsTheBrightestAndWhereItWasPut() {
        for (double elevation : new double[] {8, 30, 60, 89}) {
            for (double azimuth : new double[] {0, 77, 180, -120}) {
                Skybox sky = DaylightSky.panorama(WIDTH, HEIGHT, elevation, azimuth, 3);
                Direction sun = Direction.of(Math.toRadians(elevation), Math.toRadians(azimuth));
                int brightest = 0;
                for (int texel = 0; texel < WIDTH * HEIGHT; texel++) {
                    brightest = luminance(sky, texel) > luminance(sky, brightest) ? texel : brightest;
                }
                Direction found = center(brightest);
                assertThat(found.dot(sun)).isGreaterThan(Math.cos(Math.toRadians(3)));
                assertThat(luminance(sky, brightest)).isGreaterThan(20);
            }
        }
    }

    @Test
    void theSunsLightIsTheSameAtEverySize() {
        for (int height : new int[] {8, 64, 300, 1024}) {
            float[] panorama = new float[3 * 2 * height * height];
            SunDisc.add(Direction.of(0.7, 2), new Color(1, 2, 3), 2 * height, height, panorama);
            double light = 0;
            for (int texel = 0; texel < 2 * height * height; texel++) {
                light += panorama[3 * texel] * Equirectangular.solidAngle(texel / (2 * height), 2 * height, height);
            }
            assertThat(light).isCloseTo(Sun.SOLID_ANGLE, within(1e-4 * Sun.SOLID_ANGLE));
        }
    }

    @Test
    void theDiscIsAsBrightAsTheSunWhereTexelsAreSmall() {
        int height = 4096;
        float[] panorama = new float[3 * 2 * height * height];
        SunDisc.add(Direction.of(0.2, 0), new Color(1, 1, 1), 2 * height, height, panorama);
        int center = Equirectangular.row(Direction.of(0.2, 0), height) * 2 * height
                + Equirectangular.column(Direction.of(0.2, 0), 2 * height);
        assertThat(panorama[3 * center]).isCloseTo(1f, within(0.05f));
    }

    @Test
    void isSymmetricAboutTheSunsMeridian() {
        // With the sun along +z, mirroring in x changes nothing.
        Skybox sky = DaylightSky.panorama(WIDTH, HEIGHT, 35, 0, 4);
        for (int row = 0; row < HEIGHT; row++) {
            for (int column = 0; column < WIDTH; column++) {
                int texel = row * WIDTH + column;
                int mirrored = row * WIDTH + WIDTH - 1 - column;
                Direction here = center(texel);
                assertThat(center(mirrored).x()).isCloseTo(-here.x(), within(1e-12));
                if (here.dot(Direction.of(Math.toRadians(35), 0)) < 0.99) {
                    assertThat(luminance(sky, texel)).isCloseTo(luminance(sky, mirrored), within(1e-6));
                }
            }
        }
    }

    @Test
    void skyIsAsBrightAsAsked() {
        for (ShippedSky shipped : ShippedSky.values()) {
            Skybox sky = DaylightSky.panorama(WIDTH, HEIGHT, shipped.daylight());
            double sum = 0;
            double weight = 0;
            for (int texel = 0; texel < WIDTH * HEIGHT / 2; texel++) {
                double solidAngle = Equirectangular.solidAngle(texel / WIDTH, WIDTH, HEIGHT);
                sum += solidAngle * Math.min(3, luminance(sky, texel));
                weight += solidAngle;
            }
            assertThat(sum / weight).isCloseTo(shipped.daylight().meanSkyRadiance(), Percentage.withPercentage(15));
        }
    }

    @Test
    void anOvercastSkyIsThreeTimesAsBrightOverhead() {
        Skybox sky = DaylightSky.panorama(WIDTH, 512, new Daylight(50, 20, 3, 1, 0.2));
        double overhead = luminance(sky, 0);
        double horizon = luminance(sky, 255 * WIDTH);
        assertThat(overhead / horizon).isCloseTo(3, within(0.03));
    }

    @Test
    void namesWhatIsOutsideItsRange() {
        assertThatIllegalArgumentException()
                .isThrownBy(() -> DaylightSky.panorama(4, 2, -1, 0, 3))
                .withMessage("the sun elevation in degrees is -1.0; 0.0 to 90.0");
        assertThatIllegalArgumentException().isThrownBy(() -> DaylightSky.panorama(4, 2, Double.NaN, 0, 3));
        assertThatIllegalArgumentException().isThrownBy(() -> DaylightSky.panorama(4, 2, 10, Double.NaN, 3));
        assertThatIllegalArgumentException()
                .isThrownBy(() -> DaylightSky.panorama(4, 2, 10, 0, 1.7))
                .withMessage("the turbidity is 1.7; 2.0 to 10.0");
        assertThatIllegalArgumentException().isThrownBy(() -> new Daylight(10, 0, 3, 1.1, 0.2));
        assertThatIllegalArgumentException().isThrownBy(() -> new Daylight(10, 0, 3, 0, -0.1));
        assertThatIllegalArgumentException().isThrownBy(() -> DaylightSky.panorama(0, 2, 10, 0, 3));
        assertThatIllegalArgumentException().isThrownBy(() -> DaylightSky.panorama(16385, 2, 10, 0, 3));
    }

    private static Direction center(int texel) {
        double elevation = Equirectangular.elevation(texel / WIDTH, HEIGHT);
        double longitude = Equirectangular.longitude(texel % WIDTH, WIDTH);
        return new Direction(
                Math.cos(elevation) * Math.sin(longitude),
                Math.sin(elevation),
                Math.cos(elevation) * Math.cos(longitude));
    }

    private static double luminance(Skybox sky, int texel) {
        float[] radiance = sky.radiance();
        return new Color(radiance[3 * texel], radiance[3 * texel + 1], radiance[3 * texel + 2]).luminance();
    }
}
