package dev.twister.sky.webp;

import java.io.IOException;
import java.util.Arrays;

/** What precedes the macroblocks of a key frame (RFC 6386, section 9.2 to 9.11), in the order of the stream. */
final class Vp8Header {
    static final int SEGMENTS = 4;

    /**
     * Factors of coefficients: of the mean (Dc) and of the others (Ac). Those of lumaMean are for the block of luma's
     * means.
     */
    record Factors(int lumaDc, int lumaAc, int lumaMeanDc, int lumaMeanAc, int chromaDc, int chromaAc) {}

    /** The loop filter's numbers for a segment and a kind of macroblock; a limit of 0 is no filter. */
    record Strength(int limit, int interior, int highVariance) {}

    private final Vp8Bits bits;
    private final boolean segmented;
    private boolean updatesMap;
    private boolean absolute = true;
    private final int[] quantizers = new int[SEGMENTS];
    private final int[] filterLevels = new int[SEGMENTS];
    private final int[] segmentProbabilities = {255, 255, 255};
    private final boolean simpleFilter;
    private final int filterLevel;
    private final int sharpness;
    private int referenceDelta;
    private int blockModeDelta;
    private final int partitions;
    private final Factors[] factors = new Factors[SEGMENTS];
    private final int[] probabilities = Vp8Tables.coefficientProbabilities();
    private final boolean mayskip;
    private final int skipProbability;

    Vp8Header(Vp8Bits bits) throws IOException {
        this.bits = bits;
        // Color space and clamping.
        bits.number(2);
        segmented = bits.flag();
        if (segmented) {
            readSegments();
        }
        simpleFilter = bits.flag();
        filterLevel = bits.number(6);
        sharpness = bits.number(3);
        readFilterDeltas();
        partitions = 1 << bits.number(2);
        readFactors();
        // Whether the probabilities are kept for later frames.
        bits.flag();
        for (int i = 0; i < probabilities.length; i++) {
            if (bits.bit(Vp8Tables.updateProbability(i)) == 1) {
                probabilities[i] = bits.number(8);
            }
        }
        mayskip = bits.flag();
        skipProbability = mayskip ? bits.number(8) : 0;
    }

    private void readSegments() throws IOException {
        updatesMap = bits.flag();
        if (bits.flag()) {
            absolute = bits.flag();
            for (int i = 0; i < SEGMENTS; i++) {
                quantizers[i] = bits.optionalSigned(7);
            }
            for (int i = 0; i < SEGMENTS; i++) {
                filterLevels[i] = bits.optionalSigned(6);
            }
        }
        for (int i = 0; updatesMap && i < segmentProbabilities.length; i++) {
            segmentProbabilities[i] = bits.flag() ? bits.number(8) : 255;
        }
    }

    private void readFilterDeltas() throws IOException {
        boolean used = bits.flag();
        if (used && bits.flag()) {
            int[] deltas = new int[8];
            for (int i = 0; i < deltas.length; i++) {
                deltas[i] = bits.optionalSigned(6);
            }
            // The others are for frames that are not key frames.
            referenceDelta = deltas[0];
            blockModeDelta = deltas[4];
        }
    }

    private void readFactors() throws IOException {
        int base = bits.number(7);
        int lumaDc = bits.optionalSigned(4);
        int meanDc = bits.optionalSigned(4);
        int meanAc = bits.optionalSigned(4);
        int chromaDc = bits.optionalSigned(4);
        int chromaAc = bits.optionalSigned(4);
        for (int i = 0; i < SEGMENTS; i++) {
            int index = segmented ? quantizers[i] + (absolute ? 0 : base) : base;
            factors[i] = new Factors(
                    Vp8Tables.dcFactor(index + lumaDc, 127),
                    Vp8Tables.acFactor(index),
                    2 * Vp8Tables.dcFactor(index + meanDc, 127),
                    Math.max(8, Vp8Tables.acFactor(index + meanAc) * 155 / 100),
                    Vp8Tables.dcFactor(index + chromaDc, 117),
                    Vp8Tables.acFactor(index + chromaAc));
        }
    }

    /** Partitions of coefficients, a power of two. */
    int partitions() {
        return partitions;
    }

    Factors factors(int segment) {
        return factors[segment];
    }

    /** By kind, band, context and token. */
    int[] probabilities() {
        return probabilities;
    }

    boolean isSimpleFilter() {
        return simpleFilter;
    }

    /** Reads a macroblock's segment. */
    int segment() throws IOException {
        if (!updatesMap) {
            return 0;
        }
        return bits.bit(segmentProbabilities[0]) == 0
                ? bits.bit(segmentProbabilities[1])
                : 2 + bits.bit(segmentProbabilities[2]);
    }

    /** Reads whether a macroblock has no coefficients. */
    boolean skips() throws IOException {
        return mayskip && bits.bit(skipProbability) == 1;
    }

    /**
     * The filter of every segment (section 9.6, 15.2).
     *
     * @param blocks whether of macroblocks that are predicted block by block
     */
    Strength[] strengths(boolean blocks) {
        Strength[] strengths = new Strength[SEGMENTS];
        Arrays.setAll(strengths, segment -> strength(segment, blocks));
        return strengths;
    }

    private Strength strength(int segment, boolean blocks) {
        int base = segmented ? filterLevels[segment] + (absolute ? 0 : filterLevel) : filterLevel;
        int level = Math.clamp(base + referenceDelta + (blocks ? blockModeDelta : 0), 0, 63);
        if (filterLevel == 0 || level == 0) {
            return new Strength(0, 0, 0);
        }
        int interior = level;
        if (sharpness > 0) {
            interior = Math.min(level >> (sharpness > 4 ? 2 : 1), 9 - sharpness);
        }
        interior = Math.max(1, interior);
        int highVariance = 0;
        if (level >= 15) {
            highVariance = level >= 40 ? 2 : 1;
        }
        return new Strength(2 * level + interior, interior, highVariance);
    }
}
