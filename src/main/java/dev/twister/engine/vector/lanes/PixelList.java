package dev.twister.engine.vector.lanes;

/** Some of a tile's pixels, each by its number. */
public final class PixelList {
    /** The numbers; only the first {@link #count} hold, and as many more as there are lanes may be written. */
    public final int[] pixels;

    public int count;

    /** With room for that number. */
    PixelList(int most) {
        pixels = new int[most + Lanes.COUNT];
    }

    public void clear() {
        count = 0;
    }

    /**
     * Adds some pixels of a packet.
     *
     * @param at the packet's place
     * @param lanes one bit a pixel that is added
     */
    public void add(int at, long lanes) {
        for (long rest = lanes; rest != 0L; rest &= rest - 1) {
            pixels[count] = at + Long.numberOfTrailingZeros(rest);
            count++;
        }
    }
}
