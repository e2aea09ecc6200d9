package dev.twister.image;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class HistogramTest {
    @Test
    void aGrayPictureHasOneLevel() {
        Histogram histogram = Histogram.of(filled(30, 0xFF808080), 6, 30);

        assertThat(histogram.pixels()).isEqualTo(30);
        assertThat(histogram.red()[0x80]).isEqualTo(30);
        assertThat(histogram.green()[0x80]).isEqualTo(30);
        assertThat(histogram.blue()[0x80]).isEqualTo(30);
        assertThat(histogram.luma()[0x80]).isEqualTo(30);
        assertThat(histogram.whiteShare()).isZero();
        assertThat(histogram.blackShare()).isZero();
    }

    @Test
    void channelsAreCountedApart() {
        Histogram histogram = Histogram.of(new int[] {0xFF102030}, 1, 1);

        assertThat(histogram.red()[0x10]).isEqualTo(1);
        assertThat(histogram.green()[0x20]).isEqualTo(1);
        assertThat(histogram.blue()[0x30]).isEqualTo(1);
        assertThat(histogram.luma()[0x1D]).isEqualTo(1);
    }

    @Test
    void halfBlackHalfWhiteIsAllClipped() {
        int[] argb = filled(100, 0xFF000000);
        Arrays.fill(argb, 50, 100, 0xFFFFFFFF);

        Histogram histogram = Histogram.of(argb, 10, 100);

        assertThat(histogram.whiteShare()).isEqualTo(0.5);
        assertThat(histogram.blackShare()).isEqualTo(0.5);
        assertThat(histogram.luma()[0]).isEqualTo(50);
        assertThat(histogram.luma()[255]).isEqualTo(50);
    }

    @ParameterizedTest
    @CsvSource({
        "0xFFFF0000, true, false",
        "0xFF00FF00, true, false",
        "0xFF0000FF, true, false",
        "0xFFFEFEFE, false, false",
        "0xFF000001, false, false",
        "0xFF000000, false, true"
    })
    void oneChannelClipsWhiteAndAllClipBlack(String argb, boolean white, boolean black) {
        int pixel = Long.decode(argb).intValue();

        assertThat(Histogram.isWhite(pixel)).isEqualTo(white);
        assertThat(Histogram.isBlack(pixel)).isEqualTo(black);
    }

    @Test
    void aShareOfTheColumnsIsSeenInFewPixelsToo() {
        int width = 100;
        // Every tenth column is white, which a stride of ten would take for all or nothing.
        int[] argb = IntStream.range(0, width * 100)
                .map(at -> at % width % 10 == 0 ? 0xFFFFFFFF : 0xFF404040)
                .toArray();

        Histogram histogram = Histogram.of(argb, width, argb.length / 10);

        assertThat(histogram.pixels()).isLessThanOrEqualTo(argb.length / 10);
        assertThat(histogram.whiteShare()).isCloseTo(0.1, within(0.01));
    }

    private static int[] filled(int pixels, int argb) {
        int[] all = new int[pixels];
        Arrays.fill(all, argb);
        return all;
    }
}
