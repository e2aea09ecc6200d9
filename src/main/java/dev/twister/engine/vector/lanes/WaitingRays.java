package dev.twister.engine.vector.lanes;

import java.util.Arrays;

/**
 * Branch rays that wait to be followed, by their bounce. The highest bounce that fills a tile goes first, so at most
 * {@value #ROOM} rays wait per bounce.
 */
public final class WaitingRays {
    private static final int ROOM = 3 * Tile.SIZE;

    /** Distance between columns. */
    private static final int STRIDE = ROOM + Lanes.COUNT;

    /** The tile columns that are saved. */
    private static final int[] COLUMNS = {
        Tile.DIRECTION_X,
        Tile.DIRECTION_Y,
        Tile.DIRECTION_Z,
        Tile.ORIGIN_X,
        Tile.ORIGIN_Y,
        Tile.ORIGIN_Z,
        Tile.LEAVING,
        Tile.INSIDE,
        Tile.TINT_RED,
        Tile.TINT_GREEN,
        Tile.TINT_BLUE,
        Tile.PIXEL,
        Tile.PLACE_X,
        Tile.PLACE_Y,
        Tile.LEAVING_TRIANGLE
    };

    private float[][] rays = {};
    private int[] counts = {};

    /** Allocates room for rays up to that number of bounces. */
    public void reserve(int bounces) {
        if (counts.length <= bounces) {
            int before = counts.length;
            counts = Arrays.copyOf(counts, bounces + 1);
            rays = Arrays.copyOf(rays, bounces + 1);
            for (int bounce = before; bounce <= bounces; bounce++) {
                rays[bounce] = new float[COLUMNS.length * STRIDE];
            }
        }
    }

    /** Forgets all rays. */
    public void clear() {
        Arrays.fill(counts, 0);
    }

    /** The bounce of the rays to follow next; negative if none wait. */
    public int next() {
        int fullest = -1;
        int first = -1;
        for (int bounce = counts.length - 1; bounce >= 0 && fullest < 0; bounce--) {
            fullest = counts[bounce] >= Tile.SIZE ? bounce : fullest;
            first = counts[bounce] > 0 ? bounce : first;
        }
        return fullest < 0 ? first : fullest;
    }

    /** Moves as many rays as fit into the tile's columns; returns their number. */
    public int take(Tile tile, int bounce) {
        int count = Math.min(counts[bounce], Tile.SIZE);
        counts[bounce] -= count;
        for (int column = 0; column < COLUMNS.length; column++) {
            System.arraycopy(rays[bounce], column * STRIDE + counts[bounce], tile.values, COLUMNS[column], count);
        }
        return count;
    }

    /**
     * Adds the rays of some lanes of a packet.
     *
     * @param at the packet's place
     * @param lanes one bit per ray
     * @param from for each saved column, the tile column to read it from
     */
    public void add(Tile tile, int at, long lanes, int bounce, int[] from) {
        float[] to = rays[bounce];
        int place = counts[bounce];
        for (int column = 0; column < COLUMNS.length; column++) {
            Lanes.pack(tile.values, at + from[column], lanes, to, column * STRIDE + place);
        }
        counts[bounce] = place + Long.bitCount(lanes);
    }
}
