package dev.twister.engine.vector.lanes;

/** Data about a packet's shadow candidates, in columns of {@link Lanes#COUNT} floats. It grows and never shrinks. */
public final class ShadowColumns {
    /** The disc's axes U (with x = 0) and W. */
    public static final int U_Y = Lanes.BORDER;

    public static final int U_Z = U_Y + Lanes.COUNT;
    public static final int W_X = U_Y + 2 * Lanes.COUNT;
    public static final int W_Y = U_Y + 3 * Lanes.COUNT;
    public static final int W_Z = U_Y + 4 * Lanes.COUNT;

    /** Factor from the unit disc to the plane at distance 1. */
    public static final int SCALE = U_Y + 5 * Lanes.COUNT;

    /** Number of blocked samples. */
    public static final int BLOCKED = U_Y + 6 * Lanes.COUNT;

    private static final int FRAME_LENGTH = U_Y + 7 * Lanes.COUNT;

    /** A candidate's center along A, U and W, and its squared radius, negative in lanes that it cannot shade. */
    public static final int ALONG = Lanes.BORDER;

    public static final int ACROSS_U = ALONG + Lanes.COUNT;
    public static final int ACROSS_W = ALONG + 2 * Lanes.COUNT;
    public static final int RADIUS_SQUARED = ALONG + 3 * Lanes.COUNT;

    /**
     * The conic {@code xx X^2 + xy X Y + yy Y^2 + x X + y Y + c} over the unit disc; negative where a sample is
     * blocked.
     */
    public static final int XX = ALONG + 4 * Lanes.COUNT;

    public static final int XY = ALONG + 5 * Lanes.COUNT;
    public static final int YY = ALONG + 6 * Lanes.COUNT;
    public static final int X = ALONG + 7 * Lanes.COUNT;
    public static final int Y = ALONG + 8 * Lanes.COUNT;
    public static final int CONSTANT = ALONG + 9 * Lanes.COUNT;

    /**
     * Ranges along {@link #direction}, in disc radii: where the candidate's shadow begins and ends, and where it covers
     * the full width of the disc.
     */
    public static final int BEGIN = ALONG + 10 * Lanes.COUNT;

    public static final int END = ALONG + 11 * Lanes.COUNT;
    public static final int HIDDEN_FROM = ALONG + 12 * Lanes.COUNT;
    public static final int HIDDEN_TO = ALONG + 13 * Lanes.COUNT;

    /** Distance between candidates. */
    public static final int STRIDE = 14 * Lanes.COUNT;

    /** With more spheres near a packet's lines, its points are faster one by one. */
    public static final int MOST_TOGETHER = 32;

    /** Spheres between a tile's points and the light, and those between one packet's points and the light. */
    public final BodyList tileCandidates = new BodyList();

    public final BodyList candidates = new BodyList();

    /** Masks of the lanes that some candidate may shade, and of those in full shadow of one. */
    public long touched;

    public long dark;

    /** Per sphere near a packet's lines, the mask of the lanes that it may shade. */
    public final long[] betweens = new long[MOST_TOGETHER];

    public final float[] frame = new float[FRAME_LENGTH];

    /** Data of {@link #candidates}, {@link #STRIDE} floats each. */
    public float[] facts = new float[ALONG + 16 * STRIDE];

    /** The minimum of the conics at each sample, {@link Lanes#COUNT} floats per sample from {@link Lanes#BORDER} on. */
    public float[] conics = {};

    /**
     * x and y of each sample. If {@link #sorted}, they are ordered along {@link #direction}, a number of
     * {@code DiscOrders}.
     */
    public float[] disc = {};

    public boolean sorted;
    public int direction;

    /** Range of samples to test per candidate: inclusive start and exclusive end. */
    public int[] froms = new int[16];

    public int[] tos = new int[16];

    /** Whether conics are valid for all candidates from all points that they may shade. */
    public boolean conical;

    /** Clears the previous packet. */
    public void startPacket() {
        candidates.clear();
        touched = 0;
        dark = 0;
    }

    /**
     * Adds a candidate that may shade the lanes {@code between} and fully covers the light in the lanes {@code hidden}.
     */
    public void add(int body, long between, long hidden) {
        candidates.add(body);
        touched |= between;
        dark |= between & hidden;
    }

    /** Allocates room for a frame's bodies. */
    public void reserveBodies(int most) {
        tileCandidates.reserve(most);
        candidates.reserve(most);
    }

    /** Allocates room for the conics at that number of samples. */
    public void reserveConics(int samples) {
        int length = Lanes.BORDER + samples * Lanes.COUNT;
        if (conics.length < length) {
            conics = new float[length];
        }
    }

    /** Allocates room for the data of that number of candidates. */
    public void reserveFacts(int count) {
        if (facts.length < ALONG + count * STRIDE) {
            int room = 2 * Integer.highestOneBit(count);
            facts = new float[ALONG + room * STRIDE];
            froms = new int[room];
            tos = new int[room];
        }
    }
}
