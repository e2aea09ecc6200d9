package dev.twister.engine.vector.crowd;

import dev.twister.kernel.NodeBox;

/**
 * What a {@link Beam} is along one axis: at t it reaches from {@code originLow + t slopeLow} to {@code originHigh + t
 * slopeHigh}. A box is there from the t at which one of its sides is met, its near one, until that of the far one;
 * where the slopes differ in sign, the beam never leaves the box again, and both sides say when it comes.
 */
public final class Slab {
    /** The far side of a box that is never left. */
    static final float NEVER = 1e30f;

    /** 0 for the low sides, 1 for the high ones. */
    int nearSide;

    int farSide;

    float nearOrigin;
    float nearScale;
    float farOrigin;
    float farScale;

    /** Added to what the far side gives: 0, or {@link #NEVER}. */
    float farAddition;

    /** The far side's scale where it is a second near one, else 0. */
    float secondScale;

    void set(float originLow, float originHigh, float lowestSlope, float slopeHigh) {
        // Where the bounds close in on each other, the low one is let stand: a little more, and one case less.
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
