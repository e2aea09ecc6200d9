package dev.twister.engine.vector.lanes;

import dev.twister.engine.JvmOptions;
import java.util.Arrays;
import java.util.Optional;
import jdk.incubator.vector.FloatVector;
import jdk.incubator.vector.IntVector;
import jdk.incubator.vector.VectorMask;
import jdk.incubator.vector.VectorOperators;
import jdk.incubator.vector.VectorSpecies;

/**
 * The width of a packet, constant per class loader because C2 generates good code only for a constant species. The
 * system property {@value #BITS_PROPERTY} (128, 256 or 512) overrides the CPU's preferred width.
 */
public final class Lanes {
    public static final String BITS_PROPERTY = "dev.twister.vector.bits";

    /** System property that overrides the JVM's setting of fused multiply-adds: {@code true} or {@code false}. */
    public static final String FMA_PROPERTY = "dev.twister.vector.fma";

    public static final VectorSpecies<Float> FLOATS = species(Integer.getInteger(BITS_PROPERTY, 0));
    public static final VectorSpecies<Integer> INTS = FLOATS.withLanes(int.class);

    /** Upper limit of the lanes, so that a packet lies within one of a tile's blocks. */
    private static final int MOST = 16;

    /** Pixels per packet: 4, 8 or 16, a divisor of a tile's block. */
    public static final int COUNT = FLOATS.length();

    /** Whether the CPU can compress lanes; elsewhere {@code compress} allocates objects. */
    public static final boolean PACK = FLOATS.vectorBitSize() == 512;

    /**
     * Start of the vectors in the most used arrays. An array's header has 16 bytes, so this many floats or ints later a
     * cache line begins, provided that the JVM aligns objects to cache lines (see {@code scripts/engine.options}).
     * Loads and stores across two lines take 25 to 50 % longer. In other JVMs the value has no effect.
     */
    public static final int BORDER = 12;

    /** Whether the CPU has a fused multiply-add; CPUs older than 2013 and some small or virtual ones lack it. */
    public static final boolean FUSED = Optional.ofNullable(System.getProperty(FMA_PROPERTY))
            .or(() -> JvmOptions.value("UseFMA"))
            .map(Boolean::parseBoolean)
            .orElse(true);

    private static final int[] NUMBERS = new int[COUNT];

    static {
        Arrays.setAll(NUMBERS, lane -> lane);
    }

    private Lanes() {}

    private static VectorSpecies<Float> species(int bits) {
        return switch (bits) {
            case 0 ->
                FloatVector.SPECIES_PREFERRED.length() > MOST ? FloatVector.SPECIES_512 : FloatVector.SPECIES_PREFERRED;
            case 128 -> FloatVector.SPECIES_128;
            case 256 -> FloatVector.SPECIES_256;
            case 512 -> FloatVector.SPECIES_512;
            default ->
                throw new IllegalArgumentException(BITS_PROPERTY + " is " + bits + ", but must be 128, 256 or 512");
        };
    }

    /** The number of each lane. */
    public static IntVector numbers() {
        return IntVector.fromArray(INTS, NUMBERS, 0);
    }

    /** A mask of the first {@code number} lanes, or of all where there are fewer. */
    public static long first(int number) {
        return (1L << Math.min(COUNT, number)) - 1;
    }

    public static FloatVector all(float value) {
        return FloatVector.broadcast(FLOATS, value);
    }

    public static FloatVector load(float[] values, int at) {
        return FloatVector.fromArray(FLOATS, values, at);
    }

    /**
     * {@code a * b + c}, fused where the CPU can. Elsewhere the Vector API's own method calls a library per lane, about
     * 1000 times slower.
     */
    public static FloatVector fma(FloatVector a, FloatVector b, FloatVector c) {
        return FUSED ? a.fma(b, c) : a.mul(b).add(c);
    }

    /** As above, with scalar {@code b} and {@code c}. */
    public static FloatVector fma(FloatVector a, float b, float c) {
        return FUSED ? a.fma(b, c) : a.mul(b).add(c);
    }

    /** The larger value per lane; {@code a} where either is NaN. Faster than {@code max}, which handles NaN and -0. */
    public static FloatVector larger(FloatVector a, FloatVector b) {
        return a.blend(b, b.compare(VectorOperators.GT, a));
    }

    public static FloatVector smaller(FloatVector a, FloatVector b) {
        return a.blend(b, b.compare(VectorOperators.LT, a));
    }

    /**
     * The minimum of all lanes, by ints in the floats' order, because a float minimum handles NaN and -0 at every step.
     */
    public static float least(FloatVector values) {
        return ordered(ordered(values.reinterpretAsInts()).reduceLanes(VectorOperators.MIN));
    }

    /** The maximum of all lanes. */
    public static float greatest(FloatVector values) {
        return ordered(ordered(values.reinterpretAsInts()).reduceLanes(VectorOperators.MAX));
    }

    private static IntVector ordered(IntVector bits) {
        return bits.lanewise(
                VectorOperators.XOR, bits.lanewise(VectorOperators.ASHR, 31).lanewise(VectorOperators.LSHR, 1));
    }

    private static float ordered(int bits) {
        return Float.intBitsToFloat(bits ^ bits >> 31 >>> 1);
    }

    /** {@code 1 / sqrt(squared)}, and 0 for 0. */
    public static FloatVector inverseRoot(FloatVector squared) {
        FloatVector inverse = all(1f).div(squared.sqrt());
        VectorMask<Float> zero = squared.compare(VectorOperators.LE, 0f);
        return inverse.blend(0f, zero);
    }

    /** Rounds toward zero; the values must be in an int's range. */
    public static IntVector truncated(FloatVector values) {
        return (IntVector) values.convertShape(VectorOperators.F2I, INTS, 0);
    }

    public static FloatVector toFloats(IntVector values) {
        return (FloatVector) values.convertShape(VectorOperators.I2F, FLOATS, 0);
    }

    /** {@code floor(values)}; the values must be in an int's range. */
    public static FloatVector floor(FloatVector values) {
        FloatVector whole = toFloats(truncated(values));
        return whole.blend(whole.sub(1f), whole.compare(VectorOperators.GT, values));
    }

    /** Writes the selected lanes contiguously; {@link #COUNT} places may be overwritten. */
    public static void pack(int[] from, int first, long lanes, int[] to, int at) {
        if (PACK) {
            IntVector.fromArray(INTS, from, first)
                    .compress(VectorMask.fromLong(INTS, lanes))
                    .intoArray(to, at);
        } else {
            int place = at;
            for (long rest = lanes; rest != 0L; rest &= rest - 1) {
                to[place] = from[first + Long.numberOfTrailingZeros(rest)];
                place++;
            }
        }
    }

    /** As above, for floats. */
    public static void pack(float[] from, int first, long lanes, float[] to, int at) {
        if (PACK) {
            FloatVector.fromArray(FLOATS, from, first)
                    .compress(VectorMask.fromLong(FLOATS, lanes))
                    .intoArray(to, at);
        } else {
            int place = at;
            for (long rest = lanes; rest != 0L; rest &= rest - 1) {
                to[place] = from[first + Long.numberOfTrailingZeros(rest)];
                place++;
            }
        }
    }
}
