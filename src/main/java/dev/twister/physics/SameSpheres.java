package dev.twister.physics;

import dev.twister.scene.Sphere;
import dev.twister.scene.Vector3;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/**
 * Matches the spheres of an edited scene with those before the edit by their centers. If the number of spheres is
 * unchanged, a sphere without a match is the moved one with the same number.
 */
public final class SameSpheres {
    /** No match. */
    public static final int NONE = -1;

    private SameSpheres() {}

    /** For each edited sphere, the index of the same sphere before the edit, or {@link #NONE}. */
    public static int[] of(List<Sphere> before, List<Sphere> edited) {
        int[] same = byPlace(before, edited);
        if (before.size() == edited.size()) {
            keepNumbers(same);
        }
        return same;
    }

    /** As above, but by the centers alone, for edits that may add and remove equally many spheres. */
    public static int[] byPlace(List<Sphere> before, List<Sphere> edited) {
        int[] same = new int[edited.size()];
        Arrays.fill(same, NONE);
        int shorter = Math.min(before.size(), edited.size());
        int head = 0;
        while (head < shorter && isSamePlace(before.get(head), edited.get(head))) {
            same[head] = head;
            head++;
        }
        int more = before.size() - edited.size();
        int tail = edited.size() - 1;
        while (tail >= head && tail + more >= head && isSamePlace(before.get(tail + more), edited.get(tail))) {
            same[tail] = tail + more;
            tail--;
        }
        findBetween(before.subList(head, tail + more + 1), edited.subList(head, tail + 1), head, same);
        return same;
    }

    /** Matches the spheres between the lists' common beginnings and ends. */
    private static void findBetween(List<Sphere> before, List<Sphere> edited, int head, int[] same) {
        if (before.isEmpty() || edited.isEmpty()) {
            return;
        }
        // A linked list per place in two flat structures, which is twice as fast as a list object per place.
        Map<Vector3, Integer> first = HashMap.newHashMap(before.size());
        int[] next = new int[before.size()];
        for (int k = before.size() - 1; k >= 0; k--) {
            Integer later = first.put(before.get(k).position(), k);
            next[k] = later == null ? NONE : later;
        }
        for (int k = 0; k < edited.size(); k++) {
            Vector3 place = edited.get(k).position();
            int number = first.getOrDefault(place, NONE);
            if (number != NONE) {
                same[head + k] = head + number;
                first.put(place, next[number]);
            }
        }
    }

    private static void keepNumbers(int[] same) {
        boolean[] found = new boolean[same.length];
        for (int number : same) {
            if (number != NONE) {
                found[number] = true;
            }
        }
        for (int index = 0; index < same.length; index++) {
            if (same[index] == NONE && !found[index]) {
                same[index] = index;
            }
        }
    }

    static boolean isSamePlace(Sphere one, Sphere other) {
        return one.position().equals(other.position());
    }
}
