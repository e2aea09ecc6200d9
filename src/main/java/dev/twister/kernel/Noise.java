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

    /** Columns and rows are below it. */
    private static final int SIDE = 0x4000;

    /** All shifts are multiples of it. */
    public static final float STEP = 0x1p-16f;

    /** Numbers for each surface of a traced path. */
    private static final int PLACES = 6;

    /** Place of the numbers of blended triangles, after those of all surfaces and their ends. */
    private static final int CROSSING = Layout.SAMPLE_SURFACE + (PLACES + 1) * (Layout.MOST_BOUNCES + 1);

    private static final int CROSSING_PLACES = 5;

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
            int high = high(path, place, frame);
            int swapped = hash((int) path[Layout.PIXEL_ROW], (int) path[Layout.PIXEL_COLUMN], place + 1);
            int low = mixed(high ^ swapped) & 255;
            number = STEP * high + STEP * STEP * 256f * low;
        }
        return number;
    }

    /** 16 bits that depend on pixel, sample and place. */
    private static int high(float[] path, int place, float[] frame) {
        int sample = (int) frame[Layout.FIRST_SAMPLE]
                + ((int) path[Layout.PIXEL_SAMPLE] - (int) frame[Layout.SAMPLES]) / Layout.SAMPLE_STRIDE;
        int pixel = hash((int) path[Layout.PIXEL_COLUMN], (int) path[Layout.PIXEL_ROW], place);
        return mixed(mixed(pixel ^ (sample & BITS)) ^ mixed((sample >> 16) ^ mixed(place)));
    }

    /**
     * The number that decides whether the path's ray goes through a blended triangle of a body. Each key is mixed by
     * itself before it joins the others, so that no two pairs of ray and triangle have the same number.
     */
    static float crossing(float[] path, int body, int triangle, float[] frame) {
        int number = high(path, CROSSING, frame);
        number = mixed(number ^ mixed(((int) path[Layout.RAYS] & BITS) ^ mixed(CROSSING + 1)));
        number = mixed(number ^ mixed((triangle & BITS) ^ mixed(CROSSING + 2)));
        number = mixed(number ^ mixed((body & BITS) ^ mixed(CROSSING + 3)));
        // Bodies and triangles are below 2^24, as floats hold them.
        number = mixed(number ^ mixed(((triangle >> 16) + 256 * (body >> 16)) ^ mixed(CROSSING + 4)));
        return STEP * number;
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

    /** Place of the number that chooses the channel of dispersed light, after those of blended triangles. */
    static int dispersion(int bounce) {
        return CROSSING + CROSSING_PLACES + bounce;
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
     * @param column in [0, 16384), like the row
     * @param place in [0, 32768)
     */
    public static int hash(int column, int row, int place) {
        return mixed(mixed(column ^ columnKey(place)) ^ mixed(row ^ rowKey(place)));
    }

    /** What a pixel's column is combined with before it is mixed, in [0, 65536). */
    public static int columnKey(int place) {
        return mixed(2 * place);
    }

    /**
     * The same for its row. The two keys differ in one of their first two bits: otherwise all pixels whose column and
     * row differ as the keys do, a line across the picture, would have one number. At the sample's own numbers that is
     * so for pictures of up to 2,048 pixels in any case.
     */
    public static int rowKey(int place) {
        int key = mixed(2 * place + 1);
        int lines = (place < Layout.SAMPLE_STRIDE ? 0 : 1) & ((key ^ columnKey(place)) < SIDE ? 1 : 0);
        return lines != 0 ? key ^ 2 * SIDE : key;
    }

    /** A permutation of [0, 65536). */
    public static int mixed(int value) {
        int mixed = ((value ^ (value >> FIRST_SHIFT)) * FIRST_FACTOR) & BITS;
        mixed = ((mixed ^ (mixed >> SECOND_SHIFT)) * SECOND_FACTOR) & BITS;
        return mixed ^ (mixed >> THIRD_SHIFT);
    }
}
