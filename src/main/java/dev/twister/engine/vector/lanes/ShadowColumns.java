package dev.twister.engine.vector.lanes;

/** What is known of a packet's shadow candidates, {@link Lanes#COUNT} floats a fact; grows, never shrinks. */
public final class ShadowColumns {
    /** The disc's axes U (its x is 0) and W. */
    public static final int U_Y = Lanes.BORDER;

    public static final int U_Z = U_Y + Lanes.COUNT;
    public static final int W_X = U_Y + 2 * Lanes.COUNT;
    public static final int W_Y = U_Y + 3 * Lanes.COUNT;
    public static final int W_Z = U_Y + 4 * Lanes.COUNT;

    /** From the unit disc to the plane at distance 1. */
    public static final int SCALE = U_Y + 5 * Lanes.COUNT;

    /** How many samples are blocked. */
    public static final int BLOCKED = U_Y + 6 * Lanes.COUNT;

    private static final int FRAME_LENGTH = U_Y + 7 * Lanes.COUNT;

    /** A candidate's center along A, U and W, and its squared radius: less than 0 in lanes it cannot shade. */
    public static final int ALONG = Lanes.BORDER;

    public static final int ACROSS_U = ALONG + Lanes.COUNT;
    public static final int ACROSS_W = ALONG + 2 * Lanes.COUNT;
    public static final int RADIUS_SQUARED = ALONG + 3 * Lanes.COUNT;

    /**
     * The conic {@code xx X^2 + xy X Y + yy Y^2 + x X + y Y + c} over the unit disc, below 0 where a sample is blocked.
     */
    public static final int XX = ALONG + 4 * Lanes.COUNT;

    public static final int XY = ALONG + 5 * Lanes.COUNT;
    public static final int YY = ALONG + 6 * Lanes.COUNT;
    public static final int X = ALONG + 7 * Lanes.COUNT;
    public static final int Y = ALONG + 8 * Lanes.COUNT;
    public static final int CONSTANT = ALONG + 9 * Lanes.COUNT;

    /**
     * Along {@link #direction}, in radii of the disc: where the candidate's shadow begins and ends, from where on it
     * hides all, and up to where.
     */
    public static final int BEGIN = ALONG + 10 * Lanes.COUNT;

    public static final int END = ALONG + 11 * Lanes.COUNT;
    public static final int HIDDEN_FROM = ALONG + 12 * Lanes.COUNT;
    public static final int HIDDEN_TO = ALONG + 13 * Lanes.COUNT;

    /** From one candidate to the next. */
    public static final int STRIDE = 14 * Lanes.COUNT;

    /** Where more spheres are near a packet\'s lines, its points are better off one by one. */
    public static final int MOST_TOGETHER = 32;

    /** Spheres between a tile's points and the light, and those between one packet's. */
    public final BodyList tileCandidates = new BodyList();

    public final BodyList candidates = new BodyList();

    /** One bit a lane that some candidate may shade, and one that a candidate shades wholly. */
    public long touched;

    public long dark;

    /** Of the spheres near a packet's lines, one bit a lane that each may come between. */
    public final long[] betweens = new long[MOST_TOGETHER];

    public final float[] frame = new float[FRAME_LENGTH];

    /** The facts of {@link #candidates}. */
    public float[] facts = new float[ALONG + 16 * STRIDE];

    /** The lowest conic at each sample, {@link Lanes#COUNT} floats a sample, from {@link Lanes#BORDER} on. */
    public float[] conics = {};

    /**
     * The samples, x and y of each, in order along the direction of that number of {@code DiscOrders} where they are
     * sorted.
     */
    public float[] disc = {};

    public boolean sorted;
    public int direction;

    /** Of each candidate, which of the samples are to be looked at: from that one on, to before that one. */
    public int[] froms = new int[16];

    public int[] tos = new int[16];

    /** Whether conics tell what each candidate blocks, from all points that it may shade. */
    public boolean conical;

    /** Forgets the last packet. */
    public void startPacket() {
        candidates.clear();
        touched = 0;
        dark = 0;
    }

    /** Adds a candidate that may shade some lanes, and some of them wholly. */
    public void add(int body, long between, long hidden) {
        candidates.add(body);
        touched |= between;
        dark |= between & hidden;
    }

    /** Makes room for a frame's bodies. */
    public void reserveBodies(int most) {
        tileCandidates.reserve(most);
        candidates.reserve(most);
    }

    /** Makes room for the conics at that number of samples. */
    public void reserveConics(int samples) {
        int length = Lanes.BORDER + samples * Lanes.COUNT;
        if (conics.length < length) {
            conics = new float[length];
        }
    }

    /** Makes room for the facts of that number of candidates. */
    public void reserveFacts(int count) {
        if (facts.length < ALONG + count * STRIDE) {
            int room = 2 * Integer.highestOneBit(count);
            facts = new float[ALONG + room * STRIDE];
            froms = new int[room];
            tos = new int[room];
        }
    }
}
