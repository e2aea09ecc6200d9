package dev.twister.gui;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.SequencedSet;
import java.util.function.IntPredicate;

/** The underlined letters of a menu, which choose its items by the keyboard. */
public final class Mnemonics {
    private static final char MARK = '_';
    /** No letter. */
    public static final char NONE = 0;

    private Mnemonics() {}

    /**
     * A unique letter or digit for each label, in lower case, preferably the first of a word. {@link #NONE} if no
     * letter is left.
     */
    public static List<Character> letters(List<String> labels) {
        char[] chosen = new char[labels.size()];
        for (int index = 0; index < chosen.length; index++) {
            SequencedSet<Character> wanted = wanted(labels.get(index));
            chosen[index] = wanted.stream()
                    .filter(letter -> indexOf(chosen, letter) < 0)
                    .findFirst()
                    .orElse(NONE);
            if (chosen[index] == NONE) {
                makeRoom(labels, chosen, index, new boolean[chosen.length]);
            }
        }
        List<Character> letters = new ArrayList<>();
        for (char letter : chosen) {
            letters.add(letter);
        }
        return letters;
    }

    /**
     * The label with JavaFX's mnemonic mark before the letter, preferably at a word's start. Underscores of the label
     * are escaped.
     */
    public static String marked(String label, char letter) {
        String lower = label.toLowerCase(Locale.ROOT);
        int place = place(label, at -> lower.charAt(at) == letter && isInitial(label, at));
        if (place < 0) {
            place = place(label, at -> lower.charAt(at) == letter);
        }
        return place < 0 ? escaped(label) : escaped(label.substring(0, place)) + MARK + escaped(label.substring(place));
    }

    private static int place(String label, IntPredicate fits) {
        for (int at = 0; at < label.length(); at++) {
            if (isKey(label.charAt(at)) && fits.test(at)) {
                return at;
            }
        }
        return -1;
    }

    /** An augmenting path of the matching: who has a wanted letter takes another one. */
    private static boolean makeRoom(List<String> labels, char[] chosen, int index, boolean[] asked) {
        for (char letter : wanted(labels.get(index))) {
            int holder = indexOf(chosen, letter);
            if (holder < 0 || !asked[holder]) {
                if (holder >= 0) {
                    asked[holder] = true;
                }
                if (holder < 0 || makeRoom(labels, chosen, holder, asked)) {
                    chosen[index] = letter;
                    return true;
                }
            }
        }
        return false;
    }

    private static int indexOf(char[] chosen, char letter) {
        for (int index = 0; index < chosen.length; index++) {
            if (chosen[index] == letter) {
                return index;
            }
        }
        return -1;
    }

    /** The words' first letters, then the others, each in its order. */
    private static SequencedSet<Character> wanted(String label) {
        SequencedSet<Character> wanted = new LinkedHashSet<>();
        String lower = label.toLowerCase(Locale.ROOT);
        for (boolean initial : new boolean[] {true, false}) {
            for (int at = 0; at < lower.length(); at++) {
                if (isKey(lower.charAt(at)) && isInitial(lower, at) == initial) {
                    wanted.add(lower.charAt(at));
                }
            }
        }
        return wanted;
    }

    private static boolean isInitial(String label, int at) {
        return at == 0 || !Character.isLetterOrDigit(label.charAt(at - 1));
    }

    /** Whether every keyboard has it. */
    private static boolean isKey(char letter) {
        char lower = Character.toLowerCase(letter);
        return (lower >= 'a' && lower <= 'z') || (lower >= '0' && lower <= '9');
    }

    private static String escaped(String text) {
        return text.replace("_", "__");
    }
}
