package dev.twister.sky;

import java.awt.color.ColorSpace;
import java.awt.image.BufferedImage;
import java.awt.image.Raster;
import java.awt.image.SampleModel;
import java.io.IOException;
import java.util.Arrays;

/** Turns decoded images into linear radiance. */
final class LinearImage {
    private LinearImage() {}

    /** @param overBlack whether transparent texels are darker; otherwise the opacity is kept apart */
    static Skybox skybox(BufferedImage image, ImageMeaning meaning, boolean overBlack) throws IOException {
        int type = image.getColorModel().getColorSpace().getType();
        if (type != ColorSpace.TYPE_RGB && type != ColorSpace.TYPE_GRAY) {
            throw new IOException("an image that is neither RGB nor gray");
        }
        ScanOrder order = meaning.order(image.getWidth(), image.getHeight());
        Texels texels = new Texels(order, overBlack);
        if (meaning.isPalette()) {
            fromPalette(image, meaning, texels);
        } else {
            fromSamples(image, meaning, texels);
        }
        return new Skybox(order.width(), order.height(), texels.radiance, texels.opacity());
    }

    private static void fromPalette(BufferedImage image, ImageMeaning meaning, Texels texels) {
        int width = image.getWidth();
        int[] row = new int[width];
        int[] samples = new int[3 * width];
        float[] opacity = new float[width];
        ColorEncoding.Rows rows = meaning.colors().rows(width, 3, 255);
        for (int y = 0; y < image.getHeight(); y++) {
            image.getRGB(0, y, width, 1, row, 0, width);
            for (int x = 0; x < width; x++) {
                opacity[x] = (row[x] >>> 24) / 255f;
                samples[3 * x] = row[x] >> 16 & 0xff;
                samples[3 * x + 1] = row[x] >> 8 & 0xff;
                samples[3 * x + 2] = row[x] & 0xff;
            }
            texels.put(y, rows, samples, opacity);
        }
    }

    /**
     * Reads samples at their own depth. Not {@code getRGB}: it cuts 16 bits to 8, and takes gray for linear where the
     * file means sRGB.
     */
    private static void fromSamples(BufferedImage image, ImageMeaning meaning, Texels texels) throws IOException {
        Raster raster = image.getRaster();
        SampleModel model = raster.getSampleModel();
        int bands = model.getNumBands();
        int bits = model.getSampleSize(0);
        for (int band = 0; band < bands; band++) {
            if (bands > 4 || model.getSampleSize(band) != bits || bits > 16) {
                throw new IOException("an image with " + bands + " channels of " + model.getSampleSize(band)
                        + " bits; 1 to 4 equal ones of up to 16 bits are read");
            }
        }
        int largest = (1 << bits) - 1;
        boolean alpha = bands == 2 || bands == 4;
        int channels = bands < 3 ? 1 : 3;
        int width = image.getWidth();
        int[] row = new int[bands * width];
        int[] samples = alpha ? new int[channels * width] : row;
        float[] opacity = new float[width];
        Arrays.fill(opacity, 1);
        ColorEncoding.Rows rows = meaning.colors().rows(width, channels, largest);
        for (int y = 0; y < image.getHeight(); y++) {
            raster.getPixels(0, y, width, 1, row);
            for (int x = 0; alpha && x < width; x++) {
                System.arraycopy(row, bands * x, samples, channels * x, channels);
                opacity[x] = (float) row[bands * x + channels] / largest;
            }
            for (int x = 0; meaning.hasTransparentColor() && x < width; x++) {
                opacity[x] = meaning.isTransparent(samples, channels * x) ? 0 : 1;
            }
            texels.put(y, rows, samples, opacity);
        }
    }

    /** The upright picture, filled scanline by scanline. */
    private static final class Texels {
        private final ScanOrder order;
        private final float[] linear;
        private final float[] radiance;
        private final boolean overBlack;
        private float[] kept = {};

        Texels(ScanOrder order, boolean overBlack) {
            this.order = order;
            this.overBlack = overBlack;
            this.linear = new float[3 * order.scanlineLength()];
            this.radiance = new float[3 * order.width() * order.height()];
        }

        private void keep(int texel, float opacity) {
            if (kept.length == 0) {
                kept = new float[radiance.length / 3];
                Arrays.fill(kept, 1);
            }
            kept[texel] = opacity;
        }

        /** Of none if all texels are opaque. */
        float[] opacity() {
            return kept;
        }

        void put(int scanline, ColorEncoding.Rows rows, int[] samples, float[] opacity) {
            rows.convert(samples, linear);
            int target = order.texel(scanline, 0);
            for (int place = 0; place < opacity.length; place++) {
                float part = overBlack ? opacity[place] : 1;
                for (int channel = 0; channel < 3; channel++) {
                    radiance[3 * target + channel] = part * linear[3 * place + channel];
                }
                if (!overBlack && opacity[place] < 1) {
                    keep(target, opacity[place]);
                }
                target += order.step();
            }
        }
    }
}
