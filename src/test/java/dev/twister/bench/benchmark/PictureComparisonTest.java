package dev.twister.bench.benchmark;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.Arrays;
import org.junit.jupiter.api.Test;

class PictureComparisonTest {
    @Test
    void oneStepInEveryChannelIsRounding() {
        int[] reference = filled(100, 0xff808080);

        PictureComparison comparison = PictureComparison.of(reference, filled(100, 0xff7f8181));

        assertThat(comparison).isEqualTo(new PictureComparison(100, 0, 1));
        assertThat(comparison.withinTolerance()).isTrue();
    }

    @Test
    void twoStepsInAnyChannelCount() {
        for (int other : new int[] {0xfd808080, 0xff828080, 0xff807e80, 0xff808082}) {
            assertThat(PictureComparison.of(new int[] {0xff808080}, new int[] {other}))
                    .isEqualTo(new PictureComparison(1, 1, 2));
        }
    }

    @Test
    void onePixelInFiveThousandMayDiffer() {
        int[] reference = filled(10_000, 0xff000000);
        int[] picture = reference.clone();
        picture[0] = 0xffffffff;
        picture[9999] = 0xff0000ff;
        assertThat(PictureComparison.of(reference, picture).withinTolerance()).isTrue();

        picture[5000] = 0xff000002;
        assertThat(PictureComparison.of(reference, picture).withinTolerance()).isFalse();
    }

    @Test
    void aPictureLeftUnwrittenFails() {
        assertThat(PictureComparison.of(filled(9, 0xff000000), new int[9]).withinTolerance())
                .isFalse();
    }

    @Test
    void sizesMustAgree() {
        assertThatThrownBy(() -> PictureComparison.of(new int[2], new int[3]))
                .isInstanceOf(IllegalArgumentException.class);
    }

    private static int[] filled(int pixels, int argb) {
        int[] picture = new int[pixels];
        Arrays.fill(picture, argb);
        return picture;
    }
}
