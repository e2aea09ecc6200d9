package dev.twister.sky;

import java.awt.Transparency;
import java.awt.color.ColorSpace;
import java.awt.image.BufferedImage;
import java.awt.image.ColorConvertOp;
import java.awt.image.ColorModel;
import java.awt.image.ComponentColorModel;
import java.awt.image.DataBuffer;
import java.awt.image.IndexColorModel;
import java.awt.image.Raster;
import java.awt.image.SampleModel;
import java.io.IOException;

/** Turns decoded images into linear radiance by the sRGB curve (IEC 61966-2-1), over black where they are transparent. */
final class LinearImage {
    private LinearImage() {}

    static Skybox skybox(BufferedImage decoded) throws IOException {
        BufferedImage image = inSrgb(decoded);
        int width = image.getWidth();
        int height = image.getHeight();
        float[] radiance = new float[3 * width * height];
        if (image.getColorModel() instanceof IndexColorModel) {
            fromPackedColours(image, radiance);
        } else {
            fromSamples(image, radiance);
        }
        return new Skybox(width, height, radiance);
    }

    /** Linear intensity, 0 to 1, of an sRGB value of 0 to 1. */
    static double linear(double encoded) {
        return encoded <= 0.04045 ? encoded / 12.92 : Math.pow((encoded + 0.055) / 1.055, 2.4);
    }

    private static void fromPackedColours(BufferedImage image, float[] radiance) {
        float[] curve = curve(255);
        int width = image.getWidth();
        int[] row = new int[width];
        int target = 0;
        for (int y = 0; y < image.getHeight(); y++) {
            image.getRGB(0, y, width, 1, row, 0, width);
            for (int argb : row) {
                float opacity = (argb >>> 24) / 255f;
                radiance[target++] = opacity * curve[argb >> 16 & 0xff];
                radiance[target++] = opacity * curve[argb >> 8 & 0xff];
                radiance[target++] = opacity * curve[argb & 0xff];
            }
        }
    }

    /**
     * Reads samples at their own depth. Not {@code getRGB}: it cuts 16 bits to 8, and takes grey for linear where the file
     * means sRGB.
     */
    private static void fromSamples(BufferedImage image, float[] radiance) throws IOException {
        Raster raster = image.getRaster();
        SampleModel samples = raster.getSampleModel();
        int bands = samples.getNumBands();
        int bits = samples.getSampleSize(0);
        for (int band = 0; band < bands; band++) {
            if (bands > 4 || samples.getSampleSize(band) != bits || bits > 16) {
                throw new IOException("an image with " + bands + " channels of " + samples.getSampleSize(band)
                        + " bits; 1 to 4 equal ones of up to 16 bits are read");
            }
        }
        int largest = (1 << bits) - 1;
        float[] curve = curve(largest);
        boolean alpha = bands == 2 || bands == 4;
        int green = bands < 3 ? 0 : 1;
        int blue = bands < 3 ? 0 : 2;
        int width = image.getWidth();
        int[] row = new int[bands * width];
        int target = 0;
        for (int y = 0; y < image.getHeight(); y++) {
            raster.getPixels(0, y, width, 1, row);
            for (int at = 0; at < row.length; at += bands) {
                float opacity = alpha ? (float) row[at + bands - 1] / largest : 1;
                radiance[target++] = opacity * curve[row[at]];
                radiance[target++] = opacity * curve[row[at + green]];
                radiance[target++] = opacity * curve[row[at + blue]];
            }
        }
    }

    /** An image with another colour profile, converted at 16 bits; grey is left alone, since its profile is a guess. */
    private static BufferedImage inSrgb(BufferedImage image) throws IOException {
        ColorModel model = image.getColorModel();
        ColorSpace space = model.getColorSpace();
        if (space.isCS_sRGB() || space.getType() == ColorSpace.TYPE_GRAY) {
            return image;
        }
        if (space.getType() != ColorSpace.TYPE_RGB) {
            throw new IOException("an image that is neither RGB nor greyscale");
        }
        boolean alpha = model.hasAlpha();
        ComponentColorModel wide = new ComponentColorModel(
                ColorSpace.getInstance(ColorSpace.CS_sRGB),
                alpha,
                false,
                alpha ? Transparency.TRANSLUCENT : Transparency.OPAQUE,
                DataBuffer.TYPE_USHORT);
        BufferedImage converted = new BufferedImage(
                wide, wide.createCompatibleWritableRaster(image.getWidth(), image.getHeight()), false, null);
        return new ColorConvertOp(null).filter(image, converted);
    }

    private static float[] curve(int largest) {
        float[] curve = new float[largest + 1];
        for (int value = 0; value <= largest; value++) {
            curve[value] = (float) linear((double) value / largest);
        }
        return curve;
    }
}
