package dev.twister.scene.format.json;

import dev.twister.scene.SceneException;

/** A scene file's text, and the messages that point into it. */
public final class SourceText {
    private final String file;
    private final char[] characters;
    private final int length;
    private final boolean isFile;

    /** A file's text. Takes the array over: nobody else may write to it. */
    SourceText(String file, char[] characters, int length) {
        this(file, characters, length, true);
    }

    private SourceText(String file, char[] characters, int length, boolean isFile) {
        this.file = Excerpt.ofPath(file);
        this.characters = characters;
        this.length = length;
        this.isFile = isFile;
    }

    /** A text that is in no file, so that messages have no lines; {@code name} is what they begin with. */
    public static SourceText unwritten(String name, String text) {
        return new SourceText(name, text.toCharArray(), text.length(), false);
    }

    /** The text itself, of which the first {@link #length()} characters count; not to be written to. */
    char[] characters() {
        return characters;
    }

    public int length() {
        return length;
    }

    /**
     * A failure at a place: {@code file:line:column: what}, or {@code name: what} where there is no file. Offsets
     * outside the text are taken to its nearest end.
     */
    public SceneException failure(long offset, String what) {
        if (!isFile) {
            return new SceneException(file + ": " + what);
        }
        int place = Math.clamp(offset, 0, length);
        int lineStart = 0;
        int line = 1;
        for (int i = 0; i < place; i++) {
            if (endsLine(i)) {
                line++;
                lineStart = i + 1;
            }
        }
        int column = place - lineStart + 1;
        return new SceneException(file + ":" + line + ":" + column + ": " + what);
    }

    int line(int offset) {
        int line = 1;
        for (int i = 0; i < offset; i++) {
            line += endsLine(i) ? 1 : 0;
        }
        return line;
    }

    /** The number or bare word that starts at a place, as it is written. */
    public String word(int offset) {
        int end = offset;
        while (end < length && isWordCharacter(characters[end])) {
            end++;
        }
        return new String(characters, offset, end - offset);
    }

    /** Some characters from a place on, for a message. */
    String excerpt(int offset) {
        int most = 1000;
        return Excerpt.quoted(new String(characters, offset, Math.min(most, length - offset)));
    }

    /** The first place from an offset on that holds anything but white space; the text's length if none does. */
    int skipWhiteSpace(int offset) {
        int place = offset;
        while (place < length && " \t\r\n".indexOf(characters[place]) >= 0) {
            place++;
        }
        return place;
    }

    // Lines end as editors have it: LF, CR LF, or CR alone.
    private boolean endsLine(int i) {
        return characters[i] == '\n' || (characters[i] == '\r' && (i + 1 == length || characters[i + 1] != '\n'));
    }

    private static boolean isWordCharacter(char c) {
        return Character.isLetterOrDigit(c) || c == '+' || c == '-' || c == '.';
    }
}
