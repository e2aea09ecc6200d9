package dev.twister.physics;

import dev.twister.scene.Sphere;
import dev.twister.scene.Vector3;
import java.util.ArrayDeque;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Queue;

/**
 * Which sphere of an edited scene is which one of the scene before the edits: the one with the same centre, whatever its number is
 * now. Where there are as many as before, one that is nowhere to be found is the one of its number, put elsewhere.
 */
public final class SameSpheres {
    /** There was none. */
    public static final int NONE = -1;

    private SameSpheres() {}

    /** For each edited sphere, the index of the same one before the edits, or {@link #NONE}. */
    public static int[] of(List<Sphere> before, List<Sphere> edited) {
        int[] same = byPlace(before, edited);
        if (before.size() == edited.size()) {
            keepNumbers(same);
        }
        return same;
    }

    /** The same where as many may have come as have gone: each is told by its centre alone. */
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

    /** Finds what is neither at the lists' beginnings nor at their ends, where both have any left. */
    private static void findBetween(List<Sphere> before, List<Sphere> edited, int head, int[] same) {
        if (before.isEmpty() || edited.isEmpty()) {
            return;
        }
        Map<Vector3, Queue<Integer>> numbers = new HashMap<>();
        for (int k = 0; k < before.size(); k++) {
            numbers.computeIfAbsent(before.get(k).position(), _ -> new ArrayDeque<>(1))
                    .add(head + k);
        }
        for (int k = 0; k < edited.size(); k++) {
            Queue<Integer> there = numbers.get(edited.get(k).position());
            if (there != null && !there.isEmpty()) {
                same[head + k] = there.remove();
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
