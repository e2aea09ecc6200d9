package dev.twister.mesh.input;

import dev.twister.mesh.assembly.TableHash;
import java.nio.charset.StandardCharsets;

/** Strings of text in UTF-8. Short words come again and again, such as keywords, so a string of each is kept. */
final class WordCache {
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
