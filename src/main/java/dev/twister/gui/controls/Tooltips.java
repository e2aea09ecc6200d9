package dev.twister.gui.controls;

import java.util.regex.Pattern;
import java.util.stream.Collectors;
import javafx.scene.control.Tooltip;
import javafx.util.Duration;

/** The tooltips of all controls, with lines of at most {@value #LETTERS_IN_A_LINE} letters. */
public final class Tooltips {
    private static final Duration DELAY = Duration.millis(400);
    private static final Duration TIME = Duration.seconds(30);
    private static final int LETTERS_IN_A_LINE = 60;
    private static final Pattern WHITE_SPACE = Pattern.compile("\\s+");

    private Tooltips() {}

    /** A tooltip with that text, its lines wrapped. */
    public static Tooltip of(String text) {
        Tooltip tooltip = new Tooltip(lines(text));
        tooltip.setShowDelay(DELAY);
        tooltip.setShowDuration(TIME);
        return tooltip;
    }

    /** Sentences, one a line, each wrapped. */
    public static String lines(String text) {
        return text.lines().map(Tooltips::wrap).collect(Collectors.joining("\n"));
    }

    /** A command's hint and key. */
    public static Tooltip of(Command command) {
        return of(command.hint() + "\nKey: " + command.keys().getDisplayText());
    }

    /** Breaks a sentence between words, because JavaFX makes a tooltip as wide as its longest line. */
    public static String wrap(String sentence) {
        StringBuilder lines = new StringBuilder();
        int length = 0;
        for (String word : WHITE_SPACE.splitAsStream(sentence).toList()) {
            boolean fits = length + word.length() < LETTERS_IN_A_LINE;
            lines.append(length == 0 ? "" : fits ? " " : "\n").append(word);
            length = fits ? length + word.length() + 1 : word.length();
        }
        return lines.toString();
    }
}
