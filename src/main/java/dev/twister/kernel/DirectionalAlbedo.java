package dev.twister.kernel;

/**
 * The part of white light from one direction that GGX facets scatter once, with Smith's masking and shadowing: what is
 * missing to 1 is scattered more often. Tables over the roughness and the root of the cosine, whose last row has the
 * means over all directions, weighted by the cosine.
 */
public final class DirectionalAlbedo {
    public static final int COSINES = 32;
    public static final int ROUGHNESSES = 32;
    public static final int TABLE_LENGTH = COSINES * ROUGHNESSES + ROUGHNESSES;

    /** The tables of an index of refraction, one after another: of a perfect mirror, which all have. */
    public static final int MIRROR = 0;

    /** What the dielectric reflects, from outside. */
    public static final int COAT = 1;

    /** What the dielectric reflects and refracts, from outside and from inside. */
    public static final int GLASS = 2;

    public static final int TABLES = 4;

    private DirectionalAlbedo() {}

    /**
     * The albedo of light from a direction.
     *
     * @param table place in {@code looks}
     * @param roughness in [0, 1]
     * @param cosine between the direction and the normal, in [0, 1]
     */
    static float of(int table, float roughness, float cosine, float[] looks) {
        float column = (float) Math.sqrt(cosine) * (COSINES - 1);
        int left = Math.min((int) column, COSINES - 2);
        float right = column - left;
        float row = roughness * (ROUGHNESSES - 1);
        int upper = Math.min((int) row, ROUGHNESSES - 2);
        float lower = row - upper;
        int place = table + COSINES * upper + left;
        float first = looks[place] + right * (looks[place + 1] - looks[place]);
        float second = looks[place + COSINES] + right * (looks[place + COSINES + 1] - looks[place + COSINES]);
        return first + lower * (second - first);
    }

    /** The mean of {@link #of} over all directions. */
    static float mean(int table, float roughness, float[] looks) {
        float row = roughness * (ROUGHNESSES - 1);
        int upper = Math.min((int) row, ROUGHNESSES - 2);
        int place = table + COSINES * ROUGHNESSES + upper;
        return looks[place] + (row - upper) * (looks[place + 1] - looks[place]);
    }
}
