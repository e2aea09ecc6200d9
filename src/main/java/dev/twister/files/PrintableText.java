package dev.twister.files;

/** Text of users, file names say, as it may be shown on a terminal. */
public final class PrintableText {
    private PrintableText() {}

    /**
     * The text on one line: characters that control a terminal, end lines, reorder or show nothing become
     * {@code \}{@code u001b} and the like.
     */
    public static String line(String text) {
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
