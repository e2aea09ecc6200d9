package dev.twister.engine.vector.crowd;

import dev.twister.kernel.NodeBox;

/**
 * Extent of a {@link Beam} along one axis: from {@code originLow + t slopeLow} to {@code originHigh + t slopeHigh}. It
 * meets a box from the t of the near side until the t of the far side. Where the slopes differ in sign, the beam never
 * leaves the box again, and the later of both sides' t is its entry.
 */
public final class Slab {
    /** Far t of a box that the beam never leaves. */
    static final float NEVER = 1e30f;

    /** 0 for the low sides, 1 for the high sides. */
    int nearSide;

    int farSide;

    float nearOrigin;
    float nearScale;
    float farOrigin;
    float farScale;

    /** Addition to the far side's t: 0, or {@link #NEVER}. */
    float farAddition;

    /** The far side's scale where it is a second near side, else 0. */
    float secondScale;

    void set(float originLow, float originHigh, float lowestSlope, float slopeHigh) {
        // Converging bounds would be a case of their own; the low bound is kept at slope 0 instead, which only widens
        // the beam.
        float slopeLow = slopeHigh < 0f ? Math.min(lowestSlope, 0f) : lowestSlope;
        boolean falls = slopeHigh <= 0f;
        boolean straddles = slopeLow < 0f && slopeHigh > 0f;
        float low = falls || straddles ? -NodeBox.inverse(-slopeLow) : NodeBox.inverse(slopeLow);
        float high = falls ? -NodeBox.inverse(-slopeHigh) : NodeBox.inverse(slopeHigh);
        nearSide = falls ? 1 : 0;
        farSide = 1 - nearSide;
        nearOrigin = falls ? originLow : originHigh;
        nearScale = falls ? low : high;
        farOrigin = falls ? originHigh : originLow;
        farScale = straddles ? 0f : falls ? high : low;
        farAddition = straddles ? NEVER : 0f;
        secondScale = straddles ? low : 0f;
    }
}
