package dev.twister.engine.vector.lanes;

import java.util.Arrays;

/**
 * Rays that wait to be followed, by how many surfaces they have left. Those that have left the most go first where they
 * fill a tile, so that no more than {@value #ROOM} of a kind wait.
 */
public final class WaitingRays {
    private static final int ROOM = 3 * Tile.SIZE;

    /** From one column to the next. */
    private static final int STRIDE = ROOM + Lanes.COUNT;

    /** Which of a tile's columns wait. */
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

    /** Makes room for rays that have left that number of surfaces. */
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

    /** How many surfaces those that go next have left; less than 0 where none wait. */
    public int next() {
        int fullest = -1;
        int first = -1;
        for (int bounce = counts.length - 1; bounce >= 0 && fullest < 0; bounce--) {
            fullest = counts[bounce] >= Tile.SIZE ? bounce : fullest;
            first = counts[bounce] > 0 ? bounce : first;
        }
        return fullest < 0 ? first : fullest;
    }

    /** Moves as many rays as fit into the tile's columns; tells how many. */
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
     * @param lanes one bit a ray
     * @param from of each of the columns that wait, in which of the tile's columns it is
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
