package dev.twister.sky.webp;

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
