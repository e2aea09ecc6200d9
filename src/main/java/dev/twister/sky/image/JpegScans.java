package dev.twister.sky.image;

import java.util.Arrays;
import java.util.HashMap;
import java.util.Map;

/** The scans of a JPEG file, each of which brings some coefficients of some channels, or further bits of them. */
final class JpegScans {
    private static final int COEFFICIENTS = 64;
    private static final int MISSING = 64;

    /** For each channel's number and coefficient the lowest bit that has come. */
    private final Map<Integer, int[]> lowestBits = new HashMap<>();

    private boolean progressive;
    private int count;

    /**
     * Takes a frame header.
     *
     * @param payload from the sample precision on
     */
    void startFrame(boolean isProgressive, byte[] payload) {
        progressive = isProgressive;
        int channels = payload.length > 5 ? Byte.toUnsignedInt(payload[5]) : 0;
        for (int at = 6; at + 2 < payload.length && lowestBits.size() < channels; at += 3) {
            int[] bits = new int[COEFFICIENTS];
            Arrays.fill(bits, MISSING);
            lowestBits.put(Byte.toUnsignedInt(payload[at]), bits);
        }
    }

    /**
     * Takes a scan header.
     *
     * @param payload from the number of channels on
     */
    void add(byte[] payload) {
        count++;
        int channels = payload.length > 0 ? Byte.toUnsignedInt(payload[0]) : 0;
        int rest = 1 + 2 * channels;
        if (payload.length < rest + 3) {
            return;
        }
        int first = progressive ? Byte.toUnsignedInt(payload[rest]) : 0;
        int last = progressive ? Byte.toUnsignedInt(payload[rest + 1]) : COEFFICIENTS - 1;
        int bit = progressive ? payload[rest + 2] & 0xf : 0;
        for (int channel = 0; channel < channels; channel++) {
            int[] bits = lowestBits.get(Byte.toUnsignedInt(payload[1 + 2 * channel]));
            if (bits != null && first <= last && last < COEFFICIENTS) {
                Arrays.fill(bits, first, last + 1, bit);
            }
        }
    }

    int count() {
        return count;
    }

    /** How many channels the frame header names, each once; 0 without one. */
    int channels() {
        return lowestBits.size();
    }

    /** Whether every bit of every channel has come. */
    boolean areComplete() {
        return count > 0
                && lowestBits.values().stream()
                        .allMatch(bits -> Arrays.stream(bits).allMatch(bit -> bit == 0));
    }
}
