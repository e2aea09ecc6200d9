package dev.twister.engine.vector;

/** What is known of a packet's shadow candidates, {@link Lanes#COUNT} floats a fact; grows, never shrinks. */
final class ShadowScratch {
    /** The disc's axes U (its x is 0) and W. */
    static final int U_Y = 0;

    static final int U_Z = Lanes.COUNT;
    static final int W_X = 2 * Lanes.COUNT;
    static final int W_Y = 3 * Lanes.COUNT;
    static final int W_Z = 4 * Lanes.COUNT;

    /** From the unit disc to the plane at distance 1. */
    static final int SCALE = 5 * Lanes.COUNT;

    /** How many samples are blocked. */
    static final int BLOCKED = 6 * Lanes.COUNT;

    private static final int FRAME_LENGTH = 7 * Lanes.COUNT;

    /** A candidate's centre along A, U and W, and its squared radius: less than 0 in lanes it cannot shade. */
    static final int ALONG = 0;

    static final int ACROSS_U = Lanes.COUNT;
    static final int ACROSS_W = 2 * Lanes.COUNT;
    static final int RADIUS_SQUARED = 3 * Lanes.COUNT;

    /** The conic {@code xx X^2 + xy X Y + yy Y^2 + x X + y Y + c} over the unit disc, below 0 where a sample is blocked. */
    static final int XX = 4 * Lanes.COUNT;

    static final int XY = 5 * Lanes.COUNT;
    static final int YY = 6 * Lanes.COUNT;
    static final int X = 7 * Lanes.COUNT;
    static final int Y = 8 * Lanes.COUNT;
    static final int CONSTANT = 9 * Lanes.COUNT;

    /** From one candidate to the next. */
    static final int STRIDE = 10 * Lanes.COUNT;

    final Hull hull = new Hull();

    /** Spheres between a tile's points and the light, and those between one packet's. */
    final BodyList tileCandidates = new BodyList();

    final BodyList candidates = new BodyList();

    /** Those of one point at a time. */
    final LoneCandidates lone = new LoneCandidates();

    /** One bit a lane that some candidate may shade, and one that a candidate shades wholly. */
    long touched;

    long dark;

    /** Of the spheres near a packet's lines, one bit a lane that each may come between. */
    final long[] betweens = new long[Shadows.MOST_TOGETHER];

    final float[] frame = new float[FRAME_LENGTH];

    /** The facts of {@link #candidates}. */
    float[] facts = new float[16 * STRIDE];

    /** The lowest conic at each sample, {@link Lanes#COUNT} floats a sample. */
    float[] conics = {};

    /** Whether conics tell what each candidate blocks, from all points that it may shade. */
    boolean conical;

    /** Forgets the last packet. */
    void startPacket() {
        candidates.clear();
        touched = 0;
        dark = 0;
    }

    /** Adds a candidate that may shade some lanes, and some of them wholly. */
    void add(int body, long between, long hidden) {
        candidates.add(body);
        touched |= between;
        dark |= between & hidden;
    }

    /** Makes room for a frame's bodies. */
    void reserveBodies(int most) {
        tileCandidates.reserve(most);
        candidates.reserve(most);
    }

    /** Makes room for the conics at so many samples. */
    void reserveConics(int samples) {
        if (conics.length < samples * Lanes.COUNT) {
            conics = new float[samples * Lanes.COUNT];
        }
    }

    /** Makes room for the facts of so many candidates. */
    void reserveFacts(int count) {
        if (facts.length < count * STRIDE) {
            facts = new float[2 * Integer.highestOneBit(count) * STRIDE];
        }
    }
}
