package dev.twister.sky.image;

import dev.twister.sky.PackedImage;
import dev.twister.sky.Skybox;
import dev.twister.sky.TextureImage;
import java.awt.color.ColorSpace;
import java.awt.image.BufferedImage;
import java.awt.image.Raster;
import java.awt.image.SampleModel;
import java.io.IOException;
import java.util.Arrays;

/** Turns decoded images into linear radiance. */
public final class LinearImage {
    private LinearImage() {}

    /** A panorama, over black where it is transparent. */
    public static Skybox skybox(BufferedImage image, ImageMeaning meaning) throws IOException {
        FloatTexels texels = new FloatTexels(order(image, meaning), true);
        put(image, meaning, rows(image, meaning), texels);
        return texels.image();
    }

    /** A texture, of bytes where they hold all that the file says. */
    public static TextureImage texture(BufferedImage image, ImageMeaning meaning) throws IOException {
        ScanOrder order = order(image, meaning);
        ColorRows rows = rows(image, meaning);
        if (rows.fitsBytes()) {
            PackedTexels texels = new PackedTexels(order);
            put(image, meaning, rows, texels);
            return texels.image(rows.table());
        }
        FloatTexels texels = new FloatTexels(order, false);
        put(image, meaning, rows, texels);
        return texels.image();
    }

    private static ScanOrder order(BufferedImage image, ImageMeaning meaning) throws IOException {
        int type = image.getColorModel().getColorSpace().getType();
        if (type != ColorSpace.TYPE_RGB && type != ColorSpace.TYPE_GRAY) {
            throw new IOException("an image that is neither RGB nor gray");
        }
        return meaning.order(image.getWidth(), image.getHeight());
    }

    private static ColorRows rows(BufferedImage image, ImageMeaning meaning) throws IOException {
        int width = image.getWidth();
        return meaning.isPalette()
                ? meaning.colors().rows(width, 3, 255)
                : meaning.colors().rows(width, image.getRaster().getNumBands() < 3 ? 1 : 3, largest(image.getRaster()));
    }

    private static void put(BufferedImage image, ImageMeaning meaning, ColorRows rows, Texels texels) {
        if (meaning.isPalette()) {
            fromPalette(image, rows, texels);
        } else {
            fromSamples(image.getRaster(), meaning, rows, texels);
        }
    }

    private static void fromPalette(BufferedImage image, ColorRows rows, Texels texels) {
        int width = image.getWidth();
        int[] row = new int[width];
        int[] samples = new int[3 * width];
        float[] opacity = new float[width];
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

    /** The largest sample. */
    private static int largest(Raster raster) throws IOException {
        SampleModel model = raster.getSampleModel();
        int bands = model.getNumBands();
        int bits = model.getSampleSize(0);
        for (int band = 0; band < bands; band++) {
            if (bands > 4 || model.getSampleSize(band) != bits || bits > 16) {
                throw new IOException("an image with " + bands + " channels of " + model.getSampleSize(band)
                        + " bits; 1 to 4 equal ones of up to 16 bits are read");
            }
        }
        return (1 << bits) - 1;
    }

    /**
     * Reads samples at their own depth. Not {@code getRGB}: it cuts 16 bits to 8, and takes gray for linear where the
     * file means sRGB.
     */
    private static void fromSamples(Raster raster, ImageMeaning meaning, ColorRows rows, Texels texels) {
        int bands = raster.getNumBands();
        int largest = (1 << raster.getSampleModel().getSampleSize(0)) - 1;
        boolean alpha = bands == 2 || bands == 4;
        int channels = bands < 3 ? 1 : 3;
        int width = raster.getWidth();
        int[] row = new int[bands * width];
        int[] samples = alpha ? new int[channels * width] : row;
        float[] opacity = new float[width];
        Arrays.fill(opacity, 1);
        for (int y = 0; y < raster.getHeight(); y++) {
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
    private interface Texels {
        void put(int scanline, ColorRows rows, int[] samples, float[] opacity);
    }

    /** Eight bits per channel. */
    private static final class PackedTexels implements Texels {
        private final ScanOrder order;
        private final int[] texels;
        private boolean opaque = true;

        PackedTexels(ScanOrder order) {
            this.order = order;
            this.texels = new int[order.width() * order.height()];
        }

        @Override
        public void put(int scanline, ColorRows rows, int[] samples, float[] opacity) {
            int[] values = rows.recoding().values(samples);
            int target = order.texel(scanline, 0);
            for (int place = 0; place < opacity.length; place++) {
                opaque &= opacity[place] == 1;
                texels[target] = Math.round(255 * opacity[place]) << 24
                        | values[3 * place + 2] << 16
                        | values[3 * place + 1] << 8
                        | values[3 * place];
                target += order.step();
            }
        }

        PackedImage image(float[] table) {
            float[] linear = Arrays.copyOf(table, PackedImage.VALUES);
            return new PackedImage(order.width(), order.height(), texels, linear, opaque);
        }
    }

    /** Floats, as 16 bits and other primaries than sRGB need them. */
    private static final class FloatTexels implements Texels {
        private final ScanOrder order;
        private final float[] linear;
        private final float[] radiance;
        private final boolean overBlack;
        private float[] kept = {};

        /** @param overBlack whether transparent texels are darker; otherwise the opacity is kept apart */
        FloatTexels(ScanOrder order, boolean overBlack) {
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

        @Override
        public void put(int scanline, ColorRows rows, int[] samples, float[] opacity) {
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

        Skybox image() {
            return new Skybox(order.width(), order.height(), radiance, kept);
        }
    }
}
