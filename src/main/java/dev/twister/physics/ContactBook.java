package dev.twister.physics;

import java.util.Arrays;

/**
 * The contacts of one search, in lists that are processed in parallel, with the range of each body, so that the next
 * search finds each pair's accumulated impulses.
 */
final class ContactBook {
    private final int[] list;
    private final int[] start;
    private final int[] end;
    private Contacts[] lists = {};

    ContactBook(int bodies) {
        list = new int[bodies];
        start = new int[bodies];
        end = new int[bodies];
    }

    /** Clears {@code count} lists and all ranges. */
    void open(int count) {
        if (lists.length < count) {
            int old = lists.length;
            lists = Arrays.copyOf(lists, count);
            for (int i = old; i < count; i++) {
                lists[i] = new Contacts();
            }
        }
        for (Contacts contacts : lists) {
            contacts.clear();
        }
        Arrays.fill(end, 0);
        Arrays.fill(start, 0);
    }

    Contacts list(int index) {
        return lists[index];
    }

    /** Records that a body's contacts are in a list, from a place to its end. */
    void setRange(int body, int index, int from) {
        list[body] = index;
        start[body] = from;
        end[body] = lists[index].count;
    }

    /** Copies the impulses of a body's contacts from an earlier search. */
    void inherit(ContactBook earlier, int body) {
        Contacts contacts = lists[list[body]];
        int from = start[body];
        if (earlier.start[body] < earlier.end[body]) {
            // Usually nothing has changed since the last search.
            Contacts old = earlier.lists[earlier.list[body]];
            from += contacts.inheritWhileAlike(from, end[body], old, earlier.start[body], earlier.end[body]);
        }
        for (int contact = from; contact < end[body]; contact++) {
            int other = contacts.second[contact];
            int to = Contacts.IMPULSES * contact;
            int found = earlier.find(body, other);
            if (found >= 0) {
                double[] old = earlier.lists[earlier.list[body]].impulses;
                System.arraycopy(old, Contacts.IMPULSES * found, contacts.impulses, to, Contacts.IMPULSES);
            } else {
                found = other < 0 ? -1 : earlier.find(other, body);
                if (found >= 0) {
                    double[] old = earlier.lists[earlier.list[other]].impulses;
                    int at = Contacts.IMPULSES * found;
                    // The stored impulse acts on the other body.
                    contacts.impulses[to] = -old[at];
                    contacts.impulses[to + 1] = -old[at + 1];
                    contacts.impulses[to + 2] = -old[at + 2];
                    contacts.impulses[to + Contacts.BUILT] = old[at + Contacts.BUILT];
                } else {
                    Arrays.fill(contacts.impulses, to, to + Contacts.IMPULSES, 0);
                }
            }
        }
    }

    /**
     * Applies a change of the bodies' order.
     *
     * @param order for each new number, the old one
     * @param places for each old number, the new one
     * @param count number of bodies
     */
    void reorder(int[] order, int[] places, int count) {
        int[] oldList = Arrays.copyOf(list, count);
        int[] oldStart = Arrays.copyOf(start, count);
        int[] oldEnd = Arrays.copyOf(end, count);
        for (int body = 0; body < count; body++) {
            list[body] = oldList[order[body]];
            start[body] = oldStart[order[body]];
            end[body] = oldEnd[order[body]];
        }
        for (Contacts contacts : lists) {
            for (int contact = 0; contact < contacts.count; contact++) {
                contacts.first[contact] = places[contacts.first[contact]];
                int other = contacts.second[contact];
                contacts.second[contact] = other < 0 ? other : places[other];
            }
        }
    }

    /** Scales all impulses, after a change of the sub-step's length. */
    void scale(double factor) {
        for (Contacts contacts : lists) {
            for (int i = 0; i < Contacts.IMPULSES * contacts.count; i++) {
                contacts.impulses[i] *= factor;
            }
        }
    }

    /** Whether a body's contact with another body or a surface carries a load. */
    boolean isLoaded(int body, int other) {
        int found = find(body, other);
        return found >= 0 && lists[list[body]].impulses[Contacts.IMPULSES * found + Contacts.BUILT] != 0;
    }

    private int find(int body, int other) {
        int[] second = end[body] > start[body] ? lists[list[body]].second : start;
        for (int contact = start[body]; contact < end[body]; contact++) {
            if (second[contact] == other) {
                return contact;
            }
        }
        return -1;
    }
}
