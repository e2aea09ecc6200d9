package dev.twister.scene;

/** Text from outside made fit for a message: one line, short, and without characters that a terminal would obey. */
final class Excerpt {
    private static final int MAX_VALUE_LENGTH = 40;
    private static final int MAX_SENTENCE_LENGTH = 160;
    private static final int MAX_PATH_LENGTH = 300;

    private Excerpt() {}

    /** In quotation marks, at most {@value #MAX_VALUE_LENGTH} characters of it. */
    static String quoted(String text) {
        return '"' + shortened(text) + '"';
    }

    /** At most {@value #MAX_VALUE_LENGTH} characters of it. */
    static String shortened(String text) {
        return start(text, MAX_VALUE_LENGTH);
    }

    /** At most {@value #MAX_SENTENCE_LENGTH} characters of it. */
    static String sentence(String text) {
        return start(text, MAX_SENTENCE_LENGTH);
    }

    /** A file's name, of which the end says most. */
    static String ofPath(String path) {
        if (path.length() <= MAX_PATH_LENGTH) {
            return escaped(path);
        }
        return "..." + escaped(path.substring(path.length() - MAX_PATH_LENGTH));
    }

    private static String start(String text, int length) {
        return text.length() <= length ? escaped(text) : escaped(text.substring(0, length)) + "...";
    }

    private static String escaped(String text) {
        StringBuilder shown = new StringBuilder(text.length());
        text.codePoints().forEach(point -> {
            if (isPrintable(point)) {
                shown.appendCodePoint(point);
            } else {
                shown.append("\\u").append("%04x".formatted(point));
            }
        });
        return shown.toString();
    }

    // Format characters (bidirectional overrides, for one) reorder what a terminal shows; a private one shows nothing.
    private static boolean isPrintable(int point) {
        return switch (Character.getType(point)) {
            case Character.CONTROL,
                    Character.FORMAT,
                    Character.SURROGATE,
                    Character.PRIVATE_USE,
                    Character.UNASSIGNED,
                    Character.LINE_SEPARATOR,
                    Character.PARAGRAPH_SEPARATOR -> false;
            default -> true;
        };
    }
}
