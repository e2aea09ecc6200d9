package dev.twister.physics;

import dev.twister.scene.Sphere;
import java.util.Arrays;
import java.util.List;

/**
 * Which sphere of an edited scene is which one of the scene before the edit. Where there are as many as before, each is the
 * one of its number; where some have come or gone, those before and after them are told by their centres.
 */
public final class SameSpheres {
    /** There was none. */
    public static final int NONE = -1;

    private SameSpheres() {}

    /** For each edited sphere, the index of the same one before the edit, or {@link #NONE}. */
    public static int[] of(List<Sphere> before, List<Sphere> edited) {
        if (before.size() != edited.size()) {
            return byPlace(before, edited);
        }
        int[] same = new int[edited.size()];
        Arrays.setAll(same, index -> index);
        return same;
    }

    /** The same where as many may have come as have gone: each is told by its centre. */
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
        return same;
    }

    static boolean isSamePlace(Sphere one, Sphere other) {
        return one.position().equals(other.position());
    }
}
