package dev.twister.engine.vector;

/** Some of a tile's packets, each by the place of its first pixel. */
final class PacketList {
    /** The places; only the first {@link #count} hold. */
    final int[] places = new int[Tile.SIZE / Lanes.COUNT];

    int count;

    /** All packets of a tile. */
    void addAll() {
        for (int packet = 0; packet < places.length; packet++) {
            places[packet] = packet * Lanes.COUNT;
        }
        count = places.length;
    }

    void clear() {
        count = 0;
    }

    void add(int place) {
        places[count] = place;
        count++;
    }
}
