package dev.twister.sky.image;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.image.DataBuffer;
import java.awt.image.Raster;
import java.awt.image.WritableRaster;
import org.junit.jupiter.api.Test;

class CmykColorsTest {
    private static int color(CmykColors colors, int... samples) {
        WritableRaster inks = Raster.createInterleavedRaster(DataBuffer.TYPE_BYTE, 1, 1, 4, null);
        inks.setPixel(0, 0, samples);
        return colors.rgb(inks).getRGB(0, 0) & 0xffffff;
    }

    @Test
    void inksTakeLightAway() {
        assertThat(color(new CmykColors(false, false), 0, 255, 255, 0)).isEqualTo(0xff0000);
        assertThat(color(new CmykColors(false, false), 0, 0, 0, 255)).isZero();
        assertThat(color(new CmykColors(false, false), 0, 0, 0, 127)).isEqualTo(0x808080);
    }

    @Test
    void invertedInksLeaveLight() {
        assertThat(color(new CmykColors(true, false), 255, 0, 0, 255)).isEqualTo(0xff0000);
        assertThat(color(new CmykColors(true, false), 255, 255, 255, 0)).isZero();
    }

    @Test
    void luminanceAndChrominanceBecomeInks() {
        // Inverted inks (255, 0, 0) are the complement of (0, 255, 255), which has this luminance and chrominance.
        assertThat(color(new CmykColors(true, true), 179, 171, 0, 255)).isEqualTo(0xff0000);
        assertThat(color(new CmykColors(true, true), 0, 128, 128, 255)).isEqualTo(0xffffff);
    }
}
