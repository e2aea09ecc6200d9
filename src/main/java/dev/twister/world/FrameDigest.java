package dev.twister.world;

import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.HexFormat;
import java.util.Map;
import java.util.WeakHashMap;

/**
 * A digest of a picture before it is rendered: equal digests mean equal pictures. It covers every array and number of a
 * snapshot, whatever records it consists of. For use by one thread.
 */
public final class FrameDigest {
    /** Arrays of this size, such as skies, are hashed once and not per frame. */
    private static final int LARGE = 1 << 20;

    private static final int FLOATS_AT_ONCE = 1 << 14;

    private final Map<float[], byte[]> large = new WeakHashMap<>();
    private final RecordParts parts = new RecordParts();

    /**
     * SHA-256 of a snapshot, in hexadecimal.
     *
     * @param more anything else that the picture depends on
     */
    public String of(FrameInput input, String more) {
        MessageDigest digest = sha256();
        add(digest, input);
        digest.update(more.getBytes(StandardCharsets.UTF_8));
        return HexFormat.of().formatHex(digest.digest());
    }

    private void add(MessageDigest digest, Object part) {
        switch (part) {
            case float[] floats
            when floats.length >= LARGE -> digest.update(large.computeIfAbsent(floats, FrameDigest::hash));
            case float[] floats -> add(digest, floats);
            case Record record -> parts.of(record).forEach(value -> add(digest, value));
            case Number number -> addText(digest, number);
            case Enum<?> constant -> addText(digest, constant);
            case Boolean flag -> addText(digest, flag);
            default -> throw new IllegalArgumentException("a snapshot has a " + part.getClass());
        }
    }

    private static byte[] hash(float[] floats) {
        MessageDigest digest = sha256();
        add(digest, floats);
        return digest.digest();
    }

    private static void add(MessageDigest digest, float[] floats) {
        addText(digest, floats.length);
        ByteBuffer buffer = ByteBuffer.allocate(Float.BYTES * FLOATS_AT_ONCE);
        for (int from = 0; from < floats.length; from += FLOATS_AT_ONCE) {
            int count = Math.min(FLOATS_AT_ONCE, floats.length - from);
            buffer.asFloatBuffer().put(floats, from, count);
            digest.update(buffer.array(), 0, Float.BYTES * count);
        }
    }

    private static void addText(MessageDigest digest, Object value) {
        digest.update(String.valueOf(value).getBytes(StandardCharsets.UTF_8));
        digest.update((byte) '\n');
    }

    private static MessageDigest sha256() {
        try {
            return MessageDigest.getInstance("SHA-256");
        } catch (NoSuchAlgorithmException impossible) {
            throw new AssertionError("every Java platform has SHA-256", impossible);
        }
    }
}
