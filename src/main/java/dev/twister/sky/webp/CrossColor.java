package dev.twister.sky.webp;

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
