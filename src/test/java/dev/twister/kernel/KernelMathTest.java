package dev.twister.kernel;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.DoubleRange;
import net.jqwik.api.constraints.FloatRange;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Checks the error bounds stated in {@link KernelMath} against {@code StrictMath}. */
class KernelMathTest {
    @ParameterizedTest
    @CsvSource({"0, 0", "-0.0, 0", "0.999, 0", "-0.001, -1", "-1, -1", "-1.5, -2", "7, 7", "-8, -8", "1e6, 1000000"})
    void floorIsTheWholeNumberBelow(float x, int floor) {
        assertThat(KernelMath.floor(x)).isEqualTo(floor);
    }

    @Property(seed = "20261121")
    void floorIsStrictMaths(@ForAll @FloatRange(min = -1e9f, max = 1e9f) float x) {
        assertThat(KernelMath.floor(x)).isEqualTo((int) StrictMath.floor(x));
    }

    @Test
    void inverseRootOfZeroIsZero() {
        assertThat(KernelMath.inverseRoot(0f)).isZero();
    }

    @Property(seed = "20261121")
    void inverseRootIsStrictMaths(@ForAll @DoubleRange(min = -30, max = 30) double logarithm) {
        float squared = (float) Math.pow(10, logarithm);
        double expected = 1 / StrictMath.sqrt(squared);
        assertThat((double) KernelMath.inverseRoot(squared)).isCloseTo(expected, within(2e-7 * expected));
    }

    @Test
    void powKeepsItsBoundOverBasesAndExponents() {
        double largest = 0;
        for (int i = 0; i <= 2000; i++) {
            float base = i / 1000f;
            for (int j = 0; j <= 1024; j++) {
                largest = Math.max(largest, powError(base, j / 8f));
                largest = Math.max(largest, powError(base, Math.min(128f, j * 0.12503f)));
            }
        }
        assertThat(largest).isLessThan(4e-5);
    }

    @Property(seed = "20261121")
    void powKeepsItsBoundAtSmallBases(
            @ForAll @DoubleRange(min = -30, max = 0) double logarithm,
            @ForAll @FloatRange(min = 0f, max = 128f) float exponent) {
        assertThat(powError((float) Math.pow(10, logarithm), exponent)).isLessThan(4e-5);
    }

    @Property(seed = "20261121")
    void powKeepsItsBoundAtFractions(
            @ForAll @DoubleRange(min = -30, max = 0) double logarithm,
            @ForAll @FloatRange(min = 0f, max = 1f) float exponent) {
        assertThat(powError((float) Math.pow(10, logarithm), exponent)).isLessThan(4e-5);
    }

    private static double powError(float base, float exponent) {
        double expected = StrictMath.pow(base, exponent);
        boolean isInRange = expected > 1e-30 && expected < Float.MAX_VALUE;
        return isInRange ? Math.abs(KernelMath.pow(base, exponent) / expected - 1) : 0;
    }

    @ParameterizedTest
    @ValueSource(floats = {0f, 0.3f, 1f, 2f})
    void anythingToTheZeroIsOne(float base) {
        assertThat(KernelMath.pow(base, 0f)).isEqualTo(1f);
    }

    @ParameterizedTest
    @ValueSource(floats = {1f, 1.5f, 24f, 127.9f, 128f})
    void zeroToAnythingIsZero(float exponent) {
        assertThat(KernelMath.pow(0f, exponent)).isZero();
    }

    @Test
    void atan2KeepsItsBoundAllAround() {
        double largest = 0;
        for (int i = 0; i < 1_000_000; i++) {
            double angle = (i - 500_000) * 1e-6 * 2 * Math.PI;
            float y = (float) (0.7 * StrictMath.sin(angle));
            float x = (float) (0.7 * StrictMath.cos(angle));
            largest = Math.max(largest, Math.abs(KernelMath.atan2(y, x) - StrictMath.atan2(y, x)));
        }
        assertThat(largest).isLessThan(4e-7);
    }

    @ParameterizedTest
    @CsvSource({
        "0, 0, 0",
        "0, 1, 0",
        "0, -1, 3.1415927",
        "1, 0, 1.5707964",
        "-1, 0, -1.5707964",
        "1e-30, 1, 1e-30",
        "1, 1, 0.7853982",
        "-1, -1, -2.3561945"
    })
    void atan2OfTheAxes(float y, float x, float angle) {
        assertThat(KernelMath.atan2(y, x)).isCloseTo(angle, within(4e-7f));
    }

    @Test
    void sineAndCosineOfTurnsKeepTheirBounds() {
        double largest = 0;
        for (int i = 0; i < 1_000_000; i++) {
            float turns = i * 1e-6f;
            double angle = turns * 2 * Math.PI;
            largest = Math.max(largest, Math.abs(KernelMath.sineOfTurns(turns) - StrictMath.sin(angle)));
            largest = Math.max(largest, Math.abs(KernelMath.cosineOfTurns(turns) - StrictMath.cos(angle)));
        }
        assertThat(largest).isLessThan(4e-7);
    }

    @ParameterizedTest
    @CsvSource({"0, 0, 1", "0.25, 1, 0", "0.5, 0, -1", "0.75, -1, 0", "0.99999994, 0, 1"})
    void sineAndCosineOfQuarterTurns(float turns, float sine, float cosine) {
        assertThat(KernelMath.sineOfTurns(turns)).isCloseTo(sine, within(4e-7f));
        assertThat(KernelMath.cosineOfTurns(turns)).isCloseTo(cosine, within(4e-7f));
    }

    @Test
    void tenThirdsPowerKeepsItsBound() {
        double largest = 0;
        for (int i = 0; i <= 100_000; i++) {
            float x = (float) (0.486 + i * 0.514e-5);
            largest = Math.max(largest, Math.abs(KernelMath.tenThirdsPower(x) - StrictMath.pow(x, 10 / 3.0)));
        }
        assertThat(largest).isLessThan(1e-6);
    }
}
