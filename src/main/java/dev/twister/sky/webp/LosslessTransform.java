package dev.twister.sky.webp;

import java.util.Arrays;

/** What was done to a picture before it was stored as VP8L (RFC 9649, section 3.5). */
interface LosslessTransform {
    /** Undoes it, in place where the number of texels stays. */
    int[] inverse(int[] argb);

    /** Undoes that green was subtracted from red and blue. */
    static int[] addGreen(int[] argb) {
        for (int i = 0; i < argb.length; i++) {
            int green = argb[i] >> 8 & 0xff;
            argb[i] = (argb[i] & 0xff00ff00) | ((argb[i] & 0xff00ff) + (green << 16 | green) & 0xff00ff);
        }
        return argb;
    }

    /** The sum of two texels, each channel by itself, modulo 256. */
    static int sum(int a, int b) {
        return ((a & 0xff00ff00) + (b & 0xff00ff00) & 0xff00ff00) | ((a & 0xff00ff) + (b & 0xff00ff) & 0xff00ff);
    }

    /** The number of blocks along a side, each of 2 to the power of blockBits texels; the last may be shorter. */
    static int blocks(int length, int blockBits) {
        return (length + (1 << blockBits) - 1) >> blockBits;
    }

    /**
     * A palette, whose indices are packed in green where they are few.
     *
     * @param colors as differences, each from the one before
     */
    @SuppressWarnings("ArrayRecordComponent") // read in place
    record ColorIndexing(int[] colors, int width, int height) implements LosslessTransform {
        /** Indices per packed texel, as a power of two. */
        private int packing() {
            if (colors.length > 16) {
                return 0;
            }
            if (colors.length > 4) {
                return 1;
            }
            return colors.length > 2 ? 2 : 3;
        }

        int packedWidth() {
            return LosslessTransform.blocks(width, packing());
        }

        @Override
        public int[] inverse(int[] argb) {
            int packing = packing();
            int bits = Byte.SIZE >> packing;
            // An index beyond the palette is clear black.
            int[] palette = Arrays.copyOf(colors, 1 << bits);
            for (int i = 1; i < colors.length; i++) {
                palette[i] = LosslessTransform.sum(palette[i], palette[i - 1]);
            }
            int packedWidth = packedWidth();
            int[] unpacked = packing == 0 ? argb : new int[width * height];
            for (int row = 0; row < height; row++) {
                for (int column = 0; column < width; column++) {
                    int packed = argb[row * packedWidth + (column >> packing)] >> 8;
                    int place = column & (1 << packing) - 1;
                    unpacked[row * width + column] = palette[packed >> (place * bits) & palette.length - 1];
                }
            }
            return unpacked;
        }
    }

    /**
     * Red and blue as differences from multiples of other channels.
     *
     * @param multipliers of blocks: green to red in blue, green to blue in green, red to blue in red
     */
    @SuppressWarnings("ArrayRecordComponent") // read in place
    record CrossColor(int[] multipliers, int width, int blockBits) implements LosslessTransform {
        @Override
        public int[] inverse(int[] argb) {
            int perRow = LosslessTransform.blocks(width, blockBits);
            for (int i = 0; i < argb.length; i++) {
                int block = multipliers[((i / width) >> blockBits) * perRow + (i % width >> blockBits)];
                int green = argb[i] >> 8;
                int red = (argb[i] >> 16) + delta(block, green) & 0xff;
                int blue = argb[i] + delta(block >> 8, green) + delta(block >> 16, red) & 0xff;
                argb[i] = (argb[i] & 0xff00ff00) | red << 16 | blue;
            }
            return argb;
        }

        private static int delta(int multiplier, int channel) {
            return ((byte) multiplier * (byte) channel) >> 5;
        }
    }

    /**
     * Texels as differences from what their neighbors let expect (RFC 9649, section 4.1).
     *
     * @param modes of blocks, in green
     */
    @SuppressWarnings("ArrayRecordComponent") // read in place
    record LosslessPrediction(int[] modes, int width, int blockBits) implements LosslessTransform {
        private static final int BLACK = 0xff << 24;

        @Override
        public int[] inverse(int[] argb) {
            argb[0] = LosslessTransform.sum(argb[0], BLACK);
            for (int i = 1; i < Math.min(width, argb.length); i++) {
                argb[i] = LosslessTransform.sum(argb[i], argb[i - 1]);
            }
            int perRow = LosslessTransform.blocks(width, blockBits);
            for (int start = width; start < argb.length; start += width) {
                argb[start] = LosslessTransform.sum(argb[start], argb[start - width]);
                int blocks = ((start / width) >> blockBits) * perRow;
                for (int column = 1; column < width; column++) {
                    int mode = modes[blocks + (column >> blockBits)] >> 8 & 15;
                    int at = start + column;
                    argb[at] = LosslessTransform.sum(argb[at], prediction(mode, argb, at));
                }
            }
            return argb;
        }

        private int prediction(int mode, int[] argb, int at) {
            int left = argb[at - 1];
            int top = argb[at - width];
            int topLeft = argb[at - width - 1];
            int topRight = argb[at - width + 1];
            return switch (mode) {
                case 1 -> left;
                case 2 -> top;
                case 3 -> topRight;
                case 4 -> topLeft;
                case 5 -> mean(mean(left, topRight), top);
                case 6 -> mean(left, topLeft);
                case 7 -> mean(left, top);
                case 8 -> mean(topLeft, top);
                case 9 -> mean(top, topRight);
                case 10 -> mean(mean(left, topLeft), mean(top, topRight));
                case 11 -> select(left, top, topLeft);
                case 12 -> full(left, top, topLeft);
                case 13 -> half(mean(left, top), topLeft);
                default -> BLACK;
            };
        }

        private static int mean(int a, int b) {
            return (((a ^ b) & 0xfefefefe) >>> 1) + (a & b);
        }

        private static int channel(int argb, int shift) {
            return argb >>> shift & 0xff;
        }

        private static int select(int left, int top, int topLeft) {
            int nearer = 0;
            for (int shift = 0; shift < Integer.SIZE; shift += Byte.SIZE) {
                int corner = channel(topLeft, shift);
                nearer += Math.abs(channel(left, shift) - corner) - Math.abs(channel(top, shift) - corner);
            }
            return nearer <= 0 ? top : left;
        }

        private static int full(int left, int top, int topLeft) {
            int argb = 0;
            for (int shift = 0; shift < Integer.SIZE; shift += Byte.SIZE) {
                int sum = channel(left, shift) + channel(top, shift) - channel(topLeft, shift);
                argb |= Math.clamp(sum, 0, 255) << shift;
            }
            return argb;
        }

        private static int half(int mean, int topLeft) {
            int argb = 0;
            for (int shift = 0; shift < Integer.SIZE; shift += Byte.SIZE) {
                int middle = channel(mean, shift);
                argb |= Math.clamp(middle + (middle - channel(topLeft, shift)) / 2, 0, 255) << shift;
            }
            return argb;
        }
    }
}
