package dev.twister.kernel;

/** Pseudorandom numbers in [0, 1) that are the same on every engine and in every run. */
public final class Noise {
    /** Mask of the hashed bits. Their products stay below 2^31, because overflow is not defined on every device. */
    public static final int BITS = 0xffff;

    /** Congruent to 0x88b5 and 0xdb2d modulo 2^16. */
    public static final int FIRST_FACTOR = -0x774b;

    public static final int SECOND_FACTOR = -0x24d3;
    public static final int FIRST_SHIFT = 8;
    public static final int SECOND_SHIFT = 7;
    public static final int THIRD_SHIFT = 9;

    /** All shifts are multiples of it. */
    public static final float STEP = 0x1p-16f;

    /** Numbers for each surface of a traced path. */
    private static final int PLACES = 6;

    private Noise() {}

    /**
     * One of the path sample's numbers, shifted by a hash of pixel and place, so that neighboring pixels have
     * independent noise.
     *
     * @param path with {@link Layout#PIXEL_COLUMN}, {@link Layout#PIXEL_ROW} and {@link Layout#PIXEL_SAMPLE}
     * @param place from {@link Layout#SAMPLE_LENS} to before {@link Layout#SAMPLE_STRIDE}
     */
    static float number(float[] path, int place, float[] frame) {
        float number = frame[(int) path[Layout.PIXEL_SAMPLE] + place]
                + STEP * hash((int) path[Layout.PIXEL_COLUMN], (int) path[Layout.PIXEL_ROW], place);
        return number >= 1f ? number - 1f : number;
    }

    /**
     * One of the numbers of a path's surfaces, of which no two are the same: the first ones are those of
     * {@link #number}, the others are hashed.
     *
     * @param place {@link #surface}, {@link #emitter}, {@link #scatter} or {@link #roulette}, or the next ones
     */
    static float fresh(float[] path, int place, float[] frame) {
        float number = 0f;
        if (place < Layout.SAMPLE_STRIDE) {
            number = number(path, place, frame);
        }
        if (place >= Layout.SAMPLE_STRIDE) {
            int column = (int) path[Layout.PIXEL_COLUMN];
            int row = (int) path[Layout.PIXEL_ROW];
            int sample = (int) frame[Layout.FIRST_SAMPLE]
                    + ((int) path[Layout.PIXEL_SAMPLE] - (int) frame[Layout.SAMPLES]) / Layout.SAMPLE_STRIDE;
            int pixel = hash(column, row, place);
            int high = mixed(mixed(pixel ^ (sample & BITS)) ^ mixed((sample >> 16) ^ mixed(place)));
            int low = mixed(high ^ hash(row, column, place + 1)) & 255;
            number = STEP * high + STEP * STEP * 256f * low;
        }
        return number;
    }

    /** The number that decides whether the path's ray goes through a blended triangle of a body. */
    static float crossing(float[] path, int body, int triangle, float[] frame) {
        int ray = mixed((int) path[Layout.RAYS] & BITS);
        int place = mixed(mixed(triangle & BITS) ^ mixed((triangle >> 16) ^ mixed(body & BITS)) ^ ray) >> 1;
        return fresh(path, Math.max(place, Layout.SAMPLE_STRIDE), frame);
    }

    /** Place of the three numbers that choose an emitter. */
    static int emitter(int bounce) {
        return Layout.SAMPLE_SURFACE + PLACES * bounce;
    }

    /** Place of the three numbers that choose a lobe and a direction. */
    static int scatter(int bounce) {
        return Layout.SAMPLE_SURFACE + PLACES * bounce + 3;
    }

    /** Place of the number that ends the path. */
    static int roulette(int bounce) {
        return Layout.SAMPLE_SURFACE + PLACES * (Layout.MOST_BOUNCES + 1) + bounce;
    }

    /**
     * Place of the pair of numbers for the surface hit after that many bounces.
     *
     * @param bounce at least 0
     */
    public static int surface(int bounce) {
        return Layout.SAMPLE_SURFACE + 2 * bounce;
    }

    /**
     * A hash in [0, 65536), uniformly distributed. Two pixels with equal hashes at one place differ at another.
     *
     * @param column in [0, 65536), like the row
     * @param place in [0, 32768)
     */
    public static int hash(int column, int row, int place) {
        return mixed(mixed(column ^ mixed(2 * place)) ^ mixed(row ^ mixed(2 * place + 1)));
    }

    /** A permutation of [0, 65536). */
    public static int mixed(int value) {
        int mixed = ((value ^ (value >> FIRST_SHIFT)) * FIRST_FACTOR) & BITS;
        mixed = ((mixed ^ (mixed >> SECOND_SHIFT)) * SECOND_FACTOR) & BITS;
        return mixed ^ (mixed >> THIRD_SHIFT);
    }
}
