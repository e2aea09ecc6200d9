package dev.twister.engine.vector.lanes;

/** A list of a tile's packets, each by the place of its first pixel. */
public final class PacketList {
    /** The places; only the first {@link #count} are valid. */
    public final int[] places;

    public int count;

    /** Allocates room for {@code most} packets. */
    PacketList(int most) {
        places = new int[most];
    }

    /** Fills the list with all packets of a tile. */
    public void addAll() {
        for (int packet = 0; packet < places.length; packet++) {
            places[packet] = packet * Lanes.COUNT;
        }
        count = places.length;
    }

    /** Copies another list. */
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
