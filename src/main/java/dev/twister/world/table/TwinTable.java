package dev.twister.world.table;

import dev.twister.kernel.Layout;
import dev.twister.kernel.Variant;
import java.util.Arrays;
import java.util.stream.IntStream;

/** Whether some spheres are in one place, one of which transmits. Only those that transmit are remembered by place. */
public final class TwinTable {
    private static final int NONE = -1;

    private float[] looks = {};
    private float[] places = {};
    private int present;
    private int[] transmitting = {};
    private int found;

    /**
     * {@link Variant#TWINS} or 0; looked for again only if an array or the number is another one.
     *
     * @param newPlaces the array {@code bodies} of {@link Layout}
     * @param newLooks the array {@code looks} of {@link Layout}
     * @param room one more than the highest number of a sphere
     * @param newPresent one more than the highest number of a present sphere
     */
    @SuppressWarnings("ReferenceEquality") // the arrays are immutable
    public int variant(float[] newPlaces, float[] newLooks, int room, int newPresent) {
        boolean sameLooks = looks == newLooks;
        if (!sameLooks) {
            transmitting = IntStream.range(Layout.FIRST_SPHERE, room)
                    .filter(body -> passes(newLooks, Layout.LOOK_STRIDE * body))
                    .toArray();
        }
        if (!sameLooks || places != newPlaces || present != newPresent) {
            looks = newLooks;
            places = newPlaces;
            present = newPresent;
            found = transmitting.length > 0 && search() ? Variant.TWINS : 0;
        }
        return found;
    }

    private static boolean passes(float[] looks, int look) {
        return looks[look + Layout.LOOK_TRANSMISSION] + looks[look + Layout.LOOK_SHEET] > 0;
    }

    private boolean search() {
        int[] slots = new int[4 * Integer.highestOneBit(transmitting.length)];
        Arrays.fill(slots, NONE);
        boolean twins = false;
        for (int i = 0; i < transmitting.length && transmitting[i] < present && !twins; i++) {
            int slot = slot(transmitting[i], slots);
            twins = slots[slot] != NONE;
            slots[slot] = transmitting[i];
        }
        for (int body = Layout.FIRST_SPHERE; body < present && !twins; body++) {
            int other = slots[slot(body, slots)];
            twins = other != NONE && other != body;
        }
        return twins;
    }

    /** The slot of a sphere in the body's place, or a free one. */
    private int slot(int body, int[] slots) {
        int place = Layout.PLACE_STRIDE * body;
        int hash = 0;
        for (int i = 0; i <= Layout.PLACE_SIZE; i++) {
            // 0 and -0 are one place.
            hash = 0x9E3779B1 * (hash ^ (hash >>> 15) ^ Float.floatToRawIntBits(places[place + i] + 0f));
        }
        int slot = (hash ^ (hash >>> 15)) & (slots.length - 1);
        while (slots[slot] != NONE && !isSame(place, Layout.PLACE_STRIDE * slots[slot])) {
            slot = (slot + 1) & (slots.length - 1);
        }
        return slot;
    }

    private boolean isSame(int place, int other) {
        boolean same = true;
        for (int i = 0; i <= Layout.PLACE_SIZE; i++) {
            same &= places[place + i] == places[other + i];
        }
        return same;
    }
}
