package dev.twister.kernel;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Checks Fresnel's and Snell's laws where a closed form is known. */
class RefractionTest {
    @ParameterizedTest
    @ValueSource(floats = {1f, 1.1f, 1.333f, 1.5f, 2.42f, 4f})
    void straightOnTheReflectanceIsThatOfTheIndex(float ior) {
        double expected = Math.pow((ior - 1.0) / (ior + 1.0), 2);
        assertThat((double) Refraction.reflectance(1f, 1f / ior)).isCloseTo(expected, within(1e-6));
        assertThat((double) Refraction.reflectance(1f, ior)).isCloseTo(expected, within(1e-6));
    }

    @ParameterizedTest
    @ValueSource(floats = {1.1f, 1.333f, 1.5f, 2.42f, 4f})
    void grazingLightIsReflected(float ior) {
        assertThat(Refraction.reflectance(0f, 1f / ior)).isEqualTo(1f);
    }

    /**
     * At Brewster's angle, tan = n, light polarized in the plane of incidence is not reflected, which leaves half of
     * the other polarization.
     */
    @ParameterizedTest
    @ValueSource(floats = {1.1f, 1.333f, 1.5f, 2.42f, 4f})
    void atBrewstersAngleHalfOfOnePolarizationIsReflected(float ior) {
        double squared = (double) ior * ior;
        double perpendicular = (1 - squared) / (1 + squared);
        float cosine = (float) (1 / Math.sqrt(1 + squared));
        assertThat((double) Refraction.reflectance(cosine, 1f / ior))
                .isCloseTo(perpendicular * perpendicular / 2, within(1e-6));
    }

    @ParameterizedTest
    @CsvSource({"1.333, 0.999, 0.999", "1.5, 0.999, 0.99", "2.42, 0.999, 0.99", "4, 0.5, 0.9"})
    void beyondTheCriticalAngleAllIsReflected(float ior, double beyond, double before) {
        double critical = Math.sqrt(1 - 1 / ((double) ior * ior));
        assertThat(Refraction.reflectance((float) (beyond * critical), ior)).isEqualTo(1f);
        assertThat(Refraction.reflectance((float) (critical / before), ior)).isLessThan(1f);
    }

    /** At any grazing angle, an index of 1 neither refracts nor reflects. */
    @ParameterizedTest
    @ValueSource(floats = {1e-4f, 1e-3f, 0.01f, 0.1f, 0.7f, 1f})
    void indexOfOneChangesNothing(float cosine) {
        assertThat(Refraction.reflectance(cosine, 1f)).isZero();
        assertThat(Refraction.along(cosine, 1f)).isZero();
    }

    @ParameterizedTest
    @CsvSource({"10, 1.5", "45, 1.5", "80, 1.5", "60, 4", "35, 0.6666667", "14, 0.25"})
    void sinesAreAsTheIndices(double degrees, float ior) {
        double angle = Math.toRadians(degrees);
        double refracted = Math.asin(Math.sin(angle) / ior);
        float along = Refraction.along((float) Math.cos(angle), 1f / ior);
        // The refracted ray's component along the normal: ratio * -cos + along.
        assertThat(along - Math.cos(angle) / ior).isCloseTo(-Math.cos(refracted), within(1e-6));
    }
}
