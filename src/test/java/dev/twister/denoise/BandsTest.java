package dev.twister.denoise;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class BandsTest {
    @Test
    void anOrdinaryPictureIsOneBand() {
        Bands bands = Bands.of(3840, 2160);

        assertThat(bands.count()).isEqualTo(1);
        assertThat(bands.mostRows()).isEqualTo(2160);
    }

    @Test
    void theLargestPictureIsCutIntoBandsThatOverlap() {
        Bands bands = Bands.of(16384, 16384);

        assertThat(16384L * bands.mostRows()).isLessThanOrEqualTo(1 << 24);
        assertThat(bands.first(0)).isZero();
        assertThat(bands.top(1)).isEqualTo(bands.end(0) - Bands.OVERLAP);
        assertThat(bands.bottom(0)).isEqualTo(bands.end(0) + Bands.OVERLAP);
        assertThat(bands.end(bands.count() - 1)).isEqualTo(16384);
    }
}
