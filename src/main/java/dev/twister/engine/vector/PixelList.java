package dev.twister.engine.vector;

/** Some of a tile's pixels, each by its number. */
final class PixelList {
    /** The numbers; only the first {@link #count} hold, and as many more as there are lanes may be written. */
    final int[] pixels = new int[Tile.SIZE + Lanes.COUNT];

    int count;

    void clear() {
        count = 0;
    }

    /**
     * Adds some pixels of a packet.
     *
     * @param at the packet's place
     * @param lanes one bit a pixel that is added
     */
    void add(int at, long lanes) {
        for (long rest = lanes; rest != 0L; rest &= rest - 1) {
            pixels[count] = at + Long.numberOfTrailingZeros(rest);
            count++;
        }
    }
}
