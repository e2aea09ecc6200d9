package dev.twister.engine.vector.lanes;

/** A list of a tile's pixels, each by its number. */
public final class PixelList {
    /** The numbers; only the first {@link #count} are valid. {@link Lanes#COUNT} entries beyond are scratch space. */
    public final int[] pixels;

    public int count;

    /** Allocates room for {@code most} pixels. */
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
     * @param lanes one bit per pixel to add
     */
    public void add(int at, long lanes) {
        for (long rest = lanes; rest != 0L; rest &= rest - 1) {
            pixels[count] = at + Long.numberOfTrailingZeros(rest);
            count++;
        }
    }
}
