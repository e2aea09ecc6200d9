package dev.twister.kernel;

/**
 * The choice of one of many emitters by a tree: at each node the child that may light the point more is the more
 * probable one (Conty Estevez and Kulla, "Importance Sampling of Many Lights with Adaptive Tree Splitting", 2018).
 * {@link Layout#LIGHTS_STRIDE} describes the tree.
 */
public final class LightTree {
    /** Least factor of an angle, so that rounding never leaves out an emitter. */
    private static final float LEAST = 0.01f;

    /** Keeps squared distances above 0, in square meters. */
    private static final float LEAST_SQUARED = 1e-12f;

    private static final float BELOW_ONE = 1f - 0x1p-24f;

    private LightTree() {}

    /**
     * The number of an emitter that may light {@link Layout#POINT}, or of a sun's or the sky's. Writes its probability
     * to {@link Layout#CHOICE}, and {@link Layout#LIT_NORMAL}.
     *
     * @param number in [0, 1)
     */
    public static int choose(float[] path, float number, float[] frame, float[] looks) {
        int both = path[Layout.TRANSMISSION] > 0f ? 1 : 0;
        float normalX = both != 0 ? 0f : path[Layout.NORMAL];
        float normalY = both != 0 ? 0f : path[Layout.NORMAL + 1];
        float normalZ = both != 0 ? 0f : path[Layout.NORMAL + 2];
        path[Layout.LIT_NORMAL] = normalX;
        path[Layout.LIT_NORMAL + 1] = normalY;
        path[Layout.LIT_NORMAL + 2] = normalZ;
        float x = path[Layout.POINT];
        float y = path[Layout.POINT + 1];
        float z = path[Layout.POINT + 2];
        float lights = lightsPart(frame, looks);
        float chance = lights;
        float rest = number / lights;
        int node = (int) frame[Layout.LIGHT_TREE];
        int start = 0;
        int end = number < lights ? leaves(frame) : 1;
        while (end - start > 1) {
            int middle = (start + end) / 2;
            int first = node + Layout.LIGHTS_STRIDE;
            int second = node + 2 * Layout.LIGHTS_STRIDE * (middle - start);
            float part = part(x, y, z, normalX, normalY, normalZ, first, second, looks);
            int isFirst = rest < part ? 1 : 0;
            float taken = isFirst != 0 ? part : 1f - part;
            rest = Math.min((isFirst != 0 ? rest : rest - part) / taken, BELOW_ONE);
            chance = chance * taken;
            node = isFirst != 0 ? first : second;
            start = isFirst != 0 ? start : middle;
            end = isFirst != 0 ? middle : end;
        }
        int emitter = (int) looks[node + Layout.LIGHTS_EMITTER];
        if (number < lights) {
            path[Layout.CHOICE] = chance;
        } else {
            emitter = byPower(path, leaves(frame), number, frame, looks);
        }
        return emitter;
    }

    /**
     * The number of the emitter whose part of all probabilities holds a number. Writes its probability to
     * {@link Layout#CHOICE}.
     *
     * @param first the emitters before it are left out
     */
    static int byPower(float[] path, int first, float number, float[] frame, float[] looks) {
        int start = (int) frame[Layout.EMITTER_TABLE];
        int low = first;
        int high = (int) frame[Layout.EMITTERS] - 1;
        while (low < high) {
            int middle = (low + high) / 2;
            int above = looks[start + Layout.EMITTER_STRIDE * middle + Layout.EMITTER_END] <= number ? 1 : 0;
            low = above != 0 ? middle + 1 : low;
            high = above != 0 ? high : middle;
        }
        path[Layout.CHOICE] = looks[start + Layout.EMITTER_STRIDE * low + Layout.EMITTER_PROBABILITY];
        return low;
    }

    /**
     * The probability with which {@link #choose} took a leaf at {@link Layout#ORIGIN}.
     *
     * @param leaf its number
     */
    public static float probability(float[] path, int leaf, float[] frame, float[] looks) {
        float x = path[Layout.ORIGIN];
        float y = path[Layout.ORIGIN + 1];
        float z = path[Layout.ORIGIN + 2];
        float normalX = path[Layout.LIT_NORMAL];
        float normalY = path[Layout.LIT_NORMAL + 1];
        float normalZ = path[Layout.LIT_NORMAL + 2];
        float chance = lightsPart(frame, looks);
        int node = (int) frame[Layout.LIGHT_TREE];
        int start = 0;
        int end = leaves(frame);
        while (end - start > 1) {
            int middle = (start + end) / 2;
            int first = node + Layout.LIGHTS_STRIDE;
            int second = node + 2 * Layout.LIGHTS_STRIDE * (middle - start);
            float part = part(x, y, z, normalX, normalY, normalZ, first, second, looks);
            int isFirst = leaf < middle ? 1 : 0;
            chance = chance * (isFirst != 0 ? part : 1f - part);
            node = isFirst != 0 ? first : second;
            start = isFirst != 0 ? start : middle;
            end = isFirst != 0 ? middle : end;
        }
        return chance;
    }

    /** Number of the emitters but suns and sky. */
    private static int leaves(float[] frame) {
        return (int) frame[Layout.EMITTERS] - (int) frame[Layout.SUNS] - (frame[Layout.SKY_EMITTER] > 0f ? 1 : 0);
    }

    /** Probability of the emitters but suns and sky. */
    private static float lightsPart(float[] frame, float[] looks) {
        int last = (int) frame[Layout.EMITTER_TABLE] + Layout.EMITTER_STRIDE * (leaves(frame) - 1);
        return looks[last + Layout.EMITTER_END];
    }

    /** The probability of the first of two nodes, seen from a point. */
    private static float part(
            float x,
            float y,
            float z,
            float normalX,
            float normalY,
            float normalZ,
            int first,
            int second,
            float[] looks) {
        float one = importance(x, y, z, normalX, normalY, normalZ, first, looks);
        float other = importance(x, y, z, normalX, normalY, normalZ, second, looks);
        float sum = one + other;
        return sum > 0f ? one / sum : 0.5f;
    }

    /** How much a node's emitters may light a point: their power over the squared distance, times two cosines. */
    private static float importance(
            float x, float y, float z, float normalX, float normalY, float normalZ, int node, float[] looks) {
        float toX = looks[node + Layout.LIGHTS_CENTER] - x;
        float toY = looks[node + Layout.LIGHTS_CENTER + 1] - y;
        float toZ = looks[node + Layout.LIGHTS_CENTER + 2] - z;
        float radius = looks[node + Layout.LIGHTS_RADIUS];
        float squared = Math.max(toX * toX + toY * toY + toZ * toZ, LEAST_SQUARED);
        float inverse = KernelMath.inverseRoot(squared);
        // The sphere's half angle, at most a right one; it is met from inside at any angle.
        float sine = Math.min(radius * inverse, 1f);
        float cosine = (float) Math.sqrt(1f - sine * sine);
        int inside = radius * radius < squared ? 0 : 1;
        float lit = (normalX * toX + normalY * toY + normalZ * toZ) * inverse;
        int anySide = (normalX == 0f ? 1 : 0) & (normalY == 0f ? 1 : 0) & (normalZ == 0f ? 1 : 0);
        float received = (inside | anySide) != 0 ? 1f : nearer(lit, cosine, sine);
        float along = -(looks[node + Layout.LIGHTS_AXIS] * toX
                        + looks[node + Layout.LIGHTS_AXIS + 1] * toY
                        + looks[node + Layout.LIGHTS_AXIS + 2] * toZ)
                * inverse;
        float off = nearer(along, looks[node + Layout.LIGHTS_COSINE], looks[node + Layout.LIGHTS_SINE]);
        float emitted = inside != 0 ? 1f : nearer(off, cosine, sine);
        return looks[node + Layout.LIGHTS_POWER]
                * Math.max(received, LEAST)
                * Math.max(emitted, LEAST)
                / Math.max(squared, radius * radius);
    }

    /** The cosine of an angle less another one, or 1 where that is the larger. */
    private static float nearer(float cosine, float otherCosine, float otherSine) {
        float sine = (float) Math.sqrt(Math.max(1f - cosine * cosine, 0f));
        return cosine >= otherCosine ? 1f : cosine * otherCosine + sine * otherSine;
    }
}
