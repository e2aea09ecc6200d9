package dev.twister.image;

import static org.assertj.core.api.Assertions.assertThat;

import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.FloatRange;
import net.jqwik.api.constraints.IntRange;
import org.junit.jupiter.api.Test;

class HdrWriterTest {
    @Property(tries = 2000)
    void readsBackWithinAPartIn256OfTheLargestChannel(
            @ForAll @FloatRange(min = 0, max = 2) float red,
            @ForAll @FloatRange(min = 0, max = 2) float green,
            @ForAll @FloatRange(min = 1, max = 2) float blue,
            @ForAll @IntRange(min = -126, max = 125) int exponent) {
        float[] written = {Math.scalb(red, exponent), Math.scalb(green, exponent), Math.scalb(blue, exponent)};
        double largest = Math.max(written[0], Math.max(written[1], written[2]));
        double[] read = readBack(written);
        for (int channel = 0; channel < 3; channel++) {
            assertThat(Math.abs(read[channel] - written[channel])).isLessThanOrEqualTo(largest / 256);
        }
    }

    @Test
    void keepsWhatTheFormatHoldsExactly() {
        assertThat(readBack(1, 0.5f, 0.25f)).containsExactly(1, 0.5, 0.25);
        assertThat(readBack(255, 0, 1)).containsExactly(255, 0, 1);
        assertThat(readBack(0, 0, 0)).containsExactly(0, 0, 0);
    }

    @Test
    void roundsNextToAPowerOfTwoWithoutLosingTheOtherChannels() {
        assertThat(readBack(255.9f, 3, 0)).containsExactly(255, 3, 0);
        assertThat(readBack(256, 3, 0)).containsExactly(256, 4, 0);
    }

    @Test
    void takesNaNAndNegativeAsNothing() {
        assertThat(readBack(Float.NaN, -3, 2)).containsExactly(0, 0, 2);
        assertThat(readBack(Float.NEGATIVE_INFINITY, -0f, Float.NaN)).containsExactly(0, 0, 0);
    }

    @Test
    void cutsAtTheLargestAndDropsTheSmallest() {
        double largest = 255 * 0x1p119;
        assertThat(readBack(Float.POSITIVE_INFINITY, Float.MAX_VALUE, 0)).containsExactly(largest, largest, 0);
        assertThat(readBack(0x1p-128f, 0, 0)).containsExactly(0x1p-128, 0, 0);
        assertThat(readBack(0x1p-129f, Float.MIN_VALUE, 0)).containsExactly(0, 0, 0);
    }

    private static double[] readBack(float... radiance) {
        byte[] rgbe = new byte[4];
        HdrWriter.encode(radiance, 0, rgbe, 0);
        int exponent = Byte.toUnsignedInt(rgbe[3]);
        double[] read = new double[3];
        for (int channel = 0; channel < 3; channel++) {
            read[channel] = exponent == 0 ? 0 : Math.scalb((double) Byte.toUnsignedInt(rgbe[channel]), exponent - 136);
        }
        return read;
    }
}
