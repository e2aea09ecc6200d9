package dev.twister.engine.vector.lanes;

import dev.twister.kernel.Noise;
import jdk.incubator.vector.IntVector;
import jdk.incubator.vector.VectorOperators;

/** The scalar kernel's {@link Noise}. */
public final class Hash {
    private Hash() {}

    /** {@link Noise#mixed}. */
    public static IntVector mixed(IntVector values) {
        IntVector product = values.lanewise(VectorOperators.XOR, Noise.FLIPPED)
                .mul(Noise.FIRST_FACTOR)
                .add(Noise.FIRST_SUMMAND);
        product = product.lanewise(VectorOperators.XOR, product.lanewise(VectorOperators.ASHR, Noise.FIRST_SHIFT))
                .and(Noise.BITS)
                .mul(Noise.SECOND_FACTOR)
                .add(Noise.SECOND_SUMMAND);
        return product.lanewise(VectorOperators.XOR, product.lanewise(VectorOperators.ASHR, Noise.SECOND_SHIFT))
                .and(Noise.BITS);
    }
}
