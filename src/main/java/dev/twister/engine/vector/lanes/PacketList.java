package dev.twister.engine.vector.lanes;

/** Some of a tile's packets, each by the place of its first pixel. */
public final class PacketList {
    /** The places; only the first {@link #count} hold. */
    public final int[] places;

    public int count;

    /** With room for that number. */
    PacketList(int most) {
        places = new int[most];
    }

    /** All packets of a tile. */
    public void addAll() {
        for (int packet = 0; packet < places.length; packet++) {
            places[packet] = packet * Lanes.COUNT;
        }
        count = places.length;
    }

    /** What another list has. */
    public void copy(PacketList other) {
        System.arraycopy(other.places, 0, places, 0, other.count);
        count = other.count;
    }

    public void clear() {
        count = 0;
    }

    public void add(int place) {
        places[count] = place;
        count++;
    }
}
