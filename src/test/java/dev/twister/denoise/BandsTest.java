package dev.twister.denoise;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class BandsTest {
    @Test
    void anOrdinaryPictureIsOneBand() {
        Bands bands = Bands.of(3840, 2160, Bands.MOST_PIXELS);

        assertThat(bands.count()).isEqualTo(1);
        assertThat(bands.bottom(0) - bands.top(0)).isEqualTo(2160);
    }

    @Test
    void theLargestPictureIsCutIntoBandsThatOverlap() {
        Bands bands = Bands.of(16384, 16384, Bands.MOST_PIXELS);

        for (int band = 0; band < bands.count(); band++) {
            assertThat(16384L * (bands.bottom(band) - bands.top(band))).isLessThanOrEqualTo(Bands.MOST_PIXELS);
        }
        assertThat(bands.first(0)).isZero();
        assertThat(bands.top(1)).isEqualTo(bands.end(0) - Bands.OVERLAP);
        assertThat(bands.bottom(0)).isEqualTo(bands.end(0) + Bands.OVERLAP);
        assertThat(bands.end(bands.count() - 1)).isEqualTo(16384);
    }
}
