package dev.twister.mesh.input;

import dev.twister.mesh.MeshException;
import dev.twister.mesh.assembly.TableHash;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.Locale;

/**
 * Reads words and numbers of a text and tracks the line number. Lines end in a line feed, a carriage return or both; a
 * line that ends in a backslash continues in the next one. Lines may be longer than the buffer.
 */
public final class TextCursor {
    private static final int END = -1;
    private static final int MAX_WORD_BYTES = 4096;
    private static final int BUFFER_BYTES = 1 << 16;

    /** Below this limit, another digit still fits into a long. */
    private static final long MANTISSA_LIMIT = 100_000_000_000_000_000L;

    private static final double[] POWERS_OF_TEN = {
        1, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19,
        1e20, 1e21, 1e22
    };

    private final Bytes bytes;
    private final byte[] buffer;
    private final WordCache shortWords = new WordCache();

    /** The position of the buffer's first byte. */
    private long bufferStart;

    private int at;
    private int buffered;
    private long line = 1;

    public TextCursor(Bytes bytes) {
        this.bytes = bytes;
        this.buffer = new byte[(int) Math.min(BUFFER_BYTES, bytes.length())];
    }

    /** Skips the UTF-8 byte order mark that some programs write. */
    public void skipByteOrderMark() throws IOException {
        if (bytes.startsWith("\u00ef\u00bb\u00bf")) {
            moveTo(3);
        }
    }

    public long position() {
        return bufferStart + at;
    }

    public long remaining() {
        return bytes.length() - position();
    }

    public MeshException failure(String problem) {
        return new MeshException(bytes.name() + ":" + line + ": " + problem);
    }

    public boolean atEnd() {
        return position() >= bytes.length();
    }

    /** Whether only blanks or a comment are left on the line. */
    public boolean atLineEnd() throws IOException {
        skipBlanks();
        int next = peek();
        return isLineEnd(next) || next == '#';
    }

    /** Moves to the start of the next line. */
    public void skipLine() throws IOException {
        int next = peek();
        while (!isLineEnd(next)) {
            next = advance();
        }
        endLine(next);
    }

    /** Skips blanks and line ends. */
    public void skipSpace() throws IOException {
        skipBlanks();
        for (int next = peek(); isLineEnd(next) && next != END; next = peek()) {
            endLine(next);
            skipBlanks();
        }
    }

    /** The next word of the line; empty if there is none. */
    public String word() throws IOException {
        skipBlanks();
        long start = position();
        int next = peek();
        while (!isBlank(next) && !isLineEnd(next)) {
            next = advance();
        }
        return text(start);
    }

    /** The rest of the line without leading and trailing blanks. */
    public String rest() throws IOException {
        skipBlanks();
        long start = position();
        int next = peek();
        while (!isLineEnd(next)) {
            next = advance();
        }
        return text(start).strip();
    }

    /** The next number of the line; NaN if the text spells NaN or infinity. */
    public double number() throws IOException {
        skipBlanks();
        long start = position();
        int next = peek();
        boolean negative = next == '-';
        if (negative || next == '+') {
            next = advance();
        }
        long mantissa = 0;
        int scale = 0;
        int digits = 0;
        for (; isDigit(next); next = advance(), digits++) {
            if (mantissa < MANTISSA_LIMIT) {
                mantissa = 10 * mantissa + (next - '0');
            } else {
                scale++;
            }
        }
        if (next == '.') {
            next = advance();
            for (; isDigit(next); next = advance(), digits++) {
                if (mantissa < MANTISSA_LIMIT) {
                    mantissa = 10 * mantissa + (next - '0');
                    scale--;
                }
            }
        }
        if (digits > 0 && (next == 'e' || next == 'E')) {
            advance();
            scale += exponent(start);
            next = peek();
        }
        if (digits == 0 || !(isBlank(next) || isLineEnd(next))) {
            return noNumber(start);
        }
        double value = scaled(mantissa, scale);
        return negative ? -value : value;
    }

    /**
     * The next integer.
     *
     * @param what what is expected, for messages
     */
    public long integer(String what) throws IOException {
        skipBlanks();
        long start = position();
        int next = peek();
        boolean negative = next == '-';
        if (negative || next == '+') {
            next = advance();
        }
        if (!isDigit(next)) {
            throw unexpected(start, what);
        }
        long value = 0;
        for (; isDigit(next); next = advance()) {
            if (value > MANTISSA_LIMIT) {
                throw unexpected(start, what);
            }
            value = 10 * value + (next - '0');
        }
        return negative ? -value : value;
    }

    /** Skips a character if it comes next. */
    public boolean skip(char character) throws IOException {
        if (peek() == character) {
            at++;
            return true;
        }
        return false;
    }

    /** Whether a blank, a line end or a comment comes next. */
    public boolean atWordEnd() throws IOException {
        int next = peek();
        return isBlank(next) || isLineEnd(next) || next == '#';
    }

    /** Whether a digit or a sign comes next. */
    public boolean atInteger() throws IOException {
        int next = peek();
        return isDigit(next) || next == '-' || next == '+';
    }

    /** Whether a number comes next, judging by its first character. */
    public boolean atNumber() throws IOException {
        return atInteger() || peek() == '.';
    }

    public MeshException unexpected(String expected) throws IOException {
        return unexpected(position(), expected);
    }

    private MeshException unexpected(long start, String expected) throws IOException {
        moveTo(start);
        String found = word();
        return failure((found.isEmpty() ? "the line ends" : QuotedText.text(found)) + "; expected " + expected);
    }

    private int exponent(long start) throws IOException {
        int next = peek();
        boolean negative = next == '-';
        if (negative || next == '+') {
            next = advance();
        }
        if (!isDigit(next)) {
            throw unexpected(start, "a number");
        }
        int exponent = 0;
        for (; isDigit(next); next = advance()) {
            exponent = Math.min(99_999, 10 * exponent + (next - '0'));
        }
        return negative ? -exponent : exponent;
    }

    private static double scaled(long mantissa, int scale) {
        if (scale == 0 || mantissa == 0) {
            return mantissa;
        }
        if (Math.abs(scale) < POWERS_OF_TEN.length) {
            return scale < 0 ? mantissa / POWERS_OF_TEN[-scale] : mantissa * POWERS_OF_TEN[scale];
        }
        return mantissa * Math.pow(10, scale);
    }

    /** Accepts the notations of C and C++ libraries for NaN and infinity. */
    private double noNumber(long start) throws IOException {
        moveTo(start);
        String word = word().toLowerCase(Locale.ROOT);
        if (word.matches("[+-]?(nan|inf).*|.*#(qnan|snan|ind|inf).*")) {
            return Double.NaN;
        }
        // As in 1,5, or with a comma after the number.
        throw unexpected(
                start,
                word.matches("[+-]?\\d*,\\d+.*")
                        ? "a number with a decimal point, not a decimal comma; export it with points"
                        : "a number");
    }

    private String text(long start) throws IOException {
        long count = position() - start;
        if (count > MAX_WORD_BYTES) {
            throw failure("a word or name of " + count + " bytes; at most " + MAX_WORD_BYTES + " are read");
        }
        if (start < bufferStart) {
            return new String(bytes.copy(start, (int) count), StandardCharsets.UTF_8);
        }
        return shortWords.text(buffer, (int) (start - bufferStart), (int) count);
    }

    private void skipBlanks() throws IOException {
        int next = peek();
        while (isBlank(next) || (next == '\\' && continued())) {
            next = advance();
        }
    }

    /** Moves to the end of a line that ends in a backslash. */
    private boolean continued() throws IOException {
        long after = position() + 1;
        if (after >= bytes.length()) {
            return false;
        }
        int end = bytes.at(after);
        if (end != '\n' && end != '\r') {
            return false;
        }
        boolean two = end == '\r' && after + 1 < bytes.length() && bytes.at(after + 1) == '\n';
        moveTo(two ? after + 1 : after);
        line++;
        return true;
    }

    private void endLine(int end) throws IOException {
        if (end == END) {
            return;
        }
        at++;
        if (end == '\r' && peek() == '\n') {
            at++;
        }
        line++;
    }

    private int advance() throws IOException {
        at++;
        return peek();
    }

    private int peek() throws IOException {
        return at < buffered || fill() ? buffer[at] & 0xff : END;
    }

    /** Reads on behind the buffer; returns whether anything is there. */
    private boolean fill() throws IOException {
        bufferStart = position();
        at = 0;
        buffered = (int) Math.min(buffer.length, remaining());
        bytes.copy(bufferStart, buffer, buffered);
        return buffered > 0;
    }

    private void moveTo(long position) {
        boolean within = position >= bufferStart && position <= bufferStart + buffered;
        if (!within) {
            bufferStart = position;
            buffered = 0;
        }
        at = (int) (position - bufferStart);
    }

    private static boolean isDigit(int character) {
        return character >= '0' && character <= '9';
    }

    private static boolean isBlank(int character) {
        return character == ' ' || character == '\t';
    }

    private static boolean isLineEnd(int character) {
        return character == '\n' || character == '\r' || character == END;
    }

    /** Strings of text in UTF-8. Short words come again and again, such as keywords, so a string of each is kept. */
    private static final class WordCache {
        private static final int SLOTS = 64;

        /** Bytes of a word, the first in the highest byte in use. Words that begin with a byte of 0 are not kept. */
        private final long[] keys = new long[SLOTS];

        private final String[] words = new String[SLOTS];

        String text(byte[] bytes, int from, int count) {
            if (count == 0 || count > Long.BYTES || bytes[from] == 0) {
                return new String(bytes, from, count, StandardCharsets.UTF_8);
            }
            long key = 0;
            for (int i = 0; i < count; i++) {
                key = (key << Byte.SIZE) | (bytes[from + i] & 0xff);
            }
            int slot = TableHash.of((int) key, (int) (key >>> 32), count) & SLOTS - 1;
            if (keys[slot] != key) {
                keys[slot] = key;
                words[slot] = new String(bytes, from, count, StandardCharsets.UTF_8);
            }
            return words[slot];
        }
    }
}
