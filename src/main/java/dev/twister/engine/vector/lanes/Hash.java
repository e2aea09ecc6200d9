package dev.twister.engine.vector.lanes;

import dev.twister.kernel.Noise;
import jdk.incubator.vector.IntVector;
import jdk.incubator.vector.VectorOperators;

/** The scalar kernel's {@link Noise}, in lanes. */
public final class Hash {
    private Hash() {}

    /** {@link Noise#mixed}. */
    public static IntVector mixed(IntVector values) {
        IntVector mixed =
                folded(values, Noise.FIRST_SHIFT).mul(Noise.FIRST_FACTOR).and(Noise.BITS);
        mixed = folded(mixed, Noise.SECOND_SHIFT).mul(Noise.SECOND_FACTOR).and(Noise.BITS);
        return folded(mixed, Noise.THIRD_SHIFT);
    }

    private static IntVector folded(IntVector values, int shift) {
        return values.lanewise(VectorOperators.XOR, values.lanewise(VectorOperators.ASHR, shift));
    }
}
