package dev.twister.scene.format.json;

import java.util.List;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import tools.jackson.core.io.JsonStringEncoder;

/** JSON values as text. */
public final class JsonText {
    private static final double MAX_EXACT_LONG = 1e15;

    /** A pattern sees a pair as one character, so this matches halves only. */
    private static final Pattern LONE_SURROGATE = Pattern.compile("\\p{Cs}");

    private JsonText() {}

    public static String object(List<String> members) {
        return "{" + String.join(", ", members) + "}";
    }

    public static String array(List<String> items) {
        return "[" + String.join(", ", items) + "]";
    }

    public static String member(String name, String value) {
        return string(name) + ": " + value;
    }

    /** As short as reads back to the same double; -0.0 keeps its sign. */
    public static String number(double number) {
        boolean integral = number == Math.rint(number) && Math.abs(number) < MAX_EXACT_LONG;
        boolean negativeZero = number == 0 && Double.compare(number, 0) < 0;
        return integral && !negativeZero ? String.valueOf((long) number) : String.valueOf(number);
    }

    public static String string(String text) {
        StringBuilder quoted = new StringBuilder("\"");
        JsonStringEncoder.getInstance().quoteAsString(text, quoted);
        return LONE_SURROGATE.matcher(quoted.append('"')).replaceAll(JsonText::escape);
    }

    // UTF-8 has no half of a character; JSON's escapes do.
    private static String escape(MatchResult surrogate) {
        return "\\\\u%04x".formatted((int) surrogate.group().charAt(0));
    }
}
