package dev.twister.engine.vector.lanes;

import java.util.Arrays;
import jdk.incubator.vector.FloatVector;
import jdk.incubator.vector.IntVector;
import jdk.incubator.vector.VectorMask;
import jdk.incubator.vector.VectorOperators;
import jdk.incubator.vector.VectorSpecies;

/**
 * How wide a packet is, fixed once a class loader: the compiler makes good code of a species only where it is a
 * constant. The system property {@value #BITS_PROPERTY} (128, 256 or 512) overrides the CPU's own width.
 */
public final class Lanes {
    public static final String BITS_PROPERTY = "dev.twister.vector.bits";

    public static final VectorSpecies<Float> FLOATS = species(Integer.getInteger(BITS_PROPERTY, 0));
    public static final VectorSpecies<Integer> INTS = FLOATS.withLanes(int.class);

    /** A packet lies in one of a tile's blocks. */
    private static final int MOST = 16;

    /** Pixels a packet: 4, 8 or 16, which divides a tile's block. */
    public static final int COUNT = FLOATS.length();

    /** Whether lanes can be packed together by the CPU; where they cannot, {@code compress} makes objects. */
    public static final boolean PACK = FLOATS.vectorBitSize() == 512;

    /**
     * Where vectors begin in the arrays that most of them are read from and written to: behind the 16 bytes of an
     * array's header, so many floats or ints later a cache line begins, in a JVM that lays every object on the border
     * of one (see {@code scripts/jvm.options}). A vector that lies across two lines takes a quarter to a half longer to
     * write and to read. In other JVMs it is a place like any other.
     */
    public static final int BORDER = 12;

    private static final boolean FUSED = FusedMultiplyAdd.isFast();

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

    /** Each lane's number. */
    public static IntVector numbers() {
        return IntVector.fromArray(INTS, NUMBERS, 0);
    }

    /** One bit each of the first lanes: that number, or all where there are fewer. */
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
     * {@code a * b + c}, in one step where the CPU has one: where it has none, the Vector API's own calls a library for
     * each lane, which takes a thousand times as long.
     */
    public static FloatVector fma(FloatVector a, FloatVector b, FloatVector c) {
        return FUSED ? a.fma(b, c) : a.mul(b).add(c);
    }

    /** The same with one number for all lanes each. */
    public static FloatVector fma(FloatVector a, float b, float c) {
        return FUSED ? a.fma(b, c) : a.mul(b).add(c);
    }

    /** The larger, lane by lane, {@code a} where either is NaN; cheaper than {@code max}, which minds NaN and -0. */
    public static FloatVector larger(FloatVector a, FloatVector b) {
        return a.blend(b, b.compare(VectorOperators.GT, a));
    }

    public static FloatVector smaller(FloatVector a, FloatVector b) {
        return a.blend(b, b.compare(VectorOperators.LT, a));
    }

    /** The least of all lanes; by ints in the same order, as a float's minimum minds NaN and -0 at every step. */
    public static float least(FloatVector values) {
        return ordered(ordered(values.reinterpretAsInts()).reduceLanes(VectorOperators.MIN));
    }

    /** The greatest of all lanes. */
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

    /** Towards zero, for values within an int's range. */
    public static IntVector truncated(FloatVector values) {
        return (IntVector) values.convertShape(VectorOperators.F2I, INTS, 0);
    }

    public static FloatVector toFloats(IntVector values) {
        return (FloatVector) values.convertShape(VectorOperators.I2F, FLOATS, 0);
    }

    /** {@code floor(values)}, for values within an int's range. */
    public static FloatVector floor(FloatVector values) {
        FloatVector whole = toFloats(truncated(values));
        return whole.blend(whole.sub(1f), whole.compare(VectorOperators.GT, values));
    }

    /** Writes the values of those lanes close together; {@link #COUNT} places are written. */
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

    /** The same with floats. */
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
