package dev.twister.scene.format.json;

import java.util.Collection;
import java.util.Comparator;
import java.util.Locale;
import java.util.Optional;

/** Guesses which name was meant by a misspelt one. */
public final class NearestName {
    private static final int MAX_LENGTH = 40;

    private NearestName() {}

    /**
     * The closest of the allowed names by Levenshtein distance, letter case aside, where it is close enough to help.
     */
    public static Optional<String> of(String misspelt, Collection<String> allowed) {
        if (misspelt.length() > MAX_LENGTH) {
            return Optional.empty();
        }
        return allowed.stream()
                .filter(name -> distance(misspelt, name) <= Math.max(1, name.length() / 3))
                .min(Comparator.comparingInt(name -> distance(misspelt, name)));
    }

    // Wagner and Fischer's algorithm, of which only the last row is kept.
    private static int distance(String one, String other) {
        String a = one.toLowerCase(Locale.ROOT);
        String b = other.toLowerCase(Locale.ROOT);
        int[] row = new int[b.length() + 1];
        for (int j = 0; j <= b.length(); j++) {
            row[j] = j;
        }
        for (int i = 1; i <= a.length(); i++) {
            int diagonal = row[0];
            row[0] = i;
            for (int j = 1; j <= b.length(); j++) {
                int replaced = diagonal + (a.charAt(i - 1) == b.charAt(j - 1) ? 0 : 1);
                diagonal = row[j];
                row[j] = Math.min(replaced, Math.min(row[j], row[j - 1]) + 1);
            }
        }
        return row[b.length()];
    }
}
