package dev.twister.sky.image;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.util.SortedMap;
import java.util.TreeMap;

/** The color profile of a JPEG file, which comes in numbered pieces (ICC.1:2022, B.4). */
final class JpegProfile {
    private static final int HEAD_BYTES = 2;

    private final SortedMap<Integer, byte[]> pieces = new TreeMap<>();
    private int expected;
    private boolean damaged;

    /**
     * Takes a piece.
     *
     * @param payload its number, the number of pieces, and its part of the profile
     */
    void add(byte[] payload) {
        int number = Byte.toUnsignedInt(payload[0]);
        int count = Byte.toUnsignedInt(payload[1]);
        damaged |= number > count || (!pieces.isEmpty() && count != expected);
        expected = count;
        damaged |= pieces.put(number, payload) != null;
    }

    boolean isPresent() {
        return !pieces.isEmpty();
    }

    /**
     * The pieces put together, which some programs number from 0.
     *
     * @throws IOException where they do not fit together, as {@link ProfileEncoding#ignored} tells
     */
    byte[] data() throws IOException {
        int first = pieces.firstKey();
        if (damaged || pieces.size() != expected || first > 1 || pieces.lastKey() - first != expected - 1) {
            throw new IOException("is damaged");
        }
        ByteArrayOutputStream data = new ByteArrayOutputStream();
        for (byte[] piece : pieces.values()) {
            data.write(piece, HEAD_BYTES, piece.length - HEAD_BYTES);
        }
        if (data.size() == 0) {
            throw new IOException("is empty");
        }
        return data.toByteArray();
    }
}
