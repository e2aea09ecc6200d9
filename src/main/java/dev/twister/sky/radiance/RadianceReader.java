package dev.twister.sky.radiance;

import dev.twister.sky.Skybox;
import dev.twister.sky.image.FileBytes;
import dev.twister.sky.image.FileBytes.FileCursor;
import dev.twister.sky.image.Primaries;
import dev.twister.sky.image.ScanOrder;
import java.io.IOException;

/**
 * Reads Radiance pictures. ImageIO plug-ins for them (TwelveMonkeys' imageio-hdr) tone-map to 8 bits unless told not
 * to, fail on flat scanlines and ignore orientation and exposure, while the format itself is small; hence a reader of
 * our own.
 */
public final class RadianceReader {
    private RadianceReader() {}

    public static Skybox read(FileBytes file) throws IOException {
        FileCursor content = new FileCursor(file);
        RadianceHeader header = RadianceHeader.read(content);
        ScanOrder order = header.order();
        int length = order.scanlineLength();
        checkLength(content.remaining(), order);

        byte[] scanline = new byte[4 * length];
        if (content.remaining() < order.scanlines() * RadianceScanlines.fewestBytesWithoutOldRuns(length)) {
            // Old runs can make a picture of any size out of a few bytes: see that they do before making room for it.
            RadianceScanlines rehearsal = new RadianceScanlines(content.copy(), length);
            for (int line = 0; line < order.scanlines(); line++) {
                rehearsal.next(scanline);
            }
        }

        float[] radiance = new float[3 * order.width() * order.height()];
        RadianceScanlines scanlines = new RadianceScanlines(content, length);
        RadianceTexels texels = new RadianceTexels(header);
        for (int line = 0; line < order.scanlines(); line++) {
            scanlines.next(scanline);
            texels.convert(scanline, radiance, order.texel(line, 0), order.step());
        }
        return new Skybox(order.width(), order.height(), radiance);
    }

    private static void checkLength(long remaining, ScanOrder order) throws IOException {
        long needed = order.scanlines() * RadianceScanlines.fewestBytes(order.scanlineLength());
        if (remaining < needed) {
            throw new IOException(order.width() + " x " + order.height() + " texels take " + needed
                    + " bytes or more, but only " + remaining + " follow the header");
        }
    }

    /**
     * Turns shared-exponent texels into linear radiance: {@code m * 2^(e - 136)} over the header's exposures, e = 0 is
     * black.
     */
    private static final class RadianceTexels {
        /**
         * CIE XYZ to red, green and blue of Radiance's own primaries, (0.640, 0.330), (0.290, 0.600), (0.150, 0.060),
         * and its white of equal energy (Radiance's color.h). As for RGBE pictures that name no primaries the result is
         * taken as linear sRGB as it stands, so that a picture is the same in both formats.
         */
        private static final double[][] RGB_OF_XYZ = {
            {2.565312843, -1.166849616, -0.398463227},
            {-1.022108172, 1.978286617, 0.043821555},
            {0.074724377, -0.251939567, 1.177215190}
        };

        /**
         * So much is beyond a float's range for each texel but black; infinite, it would make NaN of black, and of XYZ.
         */
        private static final double LARGEST_SCALE = 1e300;

        /** For channels that are taken as they stand. */
        private static final double[][] NONE = {};

        private final double[][] matrix;
        private final double[][] scales;

        RadianceTexels(RadianceHeader header) {
            if (header.xyz()) {
                matrix = RGB_OF_XYZ;
            } else {
                matrix = header.primaries().near(Primaries.SRGB)
                        ? NONE
                        : header.primaries().toSrgb();
            }
            scales = new double[][] {
                scales(header.redDivisor()), scales(header.greenDivisor()), scales(header.blueDivisor())
            };
        }

        /**
         * Converts a whole scanline.
         *
         * @param scanline four bytes a texel
         * @param radiance the picture, three floats a texel
         * @param texel the first one's index in the picture
         * @param step from one's index to the next one's
         */
        void convert(byte[] scanline, float[] radiance, int texel, int step) {
            int target = texel;
            for (int at = 0; at < scanline.length; at += 4) {
                int exponent = Byte.toUnsignedInt(scanline[at + 3]);
                double first = Byte.toUnsignedInt(scanline[at]) * scales[0][exponent];
                double second = Byte.toUnsignedInt(scanline[at + 1]) * scales[1][exponent];
                double third = Byte.toUnsignedInt(scanline[at + 2]) * scales[2][exponent];
                for (int channel = 0; channel < 3; channel++) {
                    double value = switch (channel) {
                        case 0 -> first;
                        case 1 -> second;
                        default -> third;
                    };
                    radiance[3 * target + channel] =
                            finite(matrix.length > 0 ? color(matrix[channel], first, second, third) : value);
                }
                target += step;
            }
        }

        private static double color(double[] row, double x, double y, double z) {
            return row[0] * x + row[1] * y + row[2] * z;
        }

        /** A color outside the primaries has negative parts, and a small exposure can lead beyond a float's range. */
        private static float finite(double value) {
            return (float) Math.clamp(value, 0, Float.MAX_VALUE);
        }

        private static double[] scales(double divisor) {
            double[] scales = new double[256];
            for (int exponent = 1; exponent < 256; exponent++) {
                scales[exponent] = Math.min(LARGEST_SCALE, Math.scalb(1.0, exponent - 136) / divisor);
            }
            return scales;
        }
    }
}
