package dev.twister.engine.vector.lanes;

import dev.twister.kernel.KernelMath;
import jdk.incubator.vector.FloatVector;

/** Arc tangent, by the scalar kernel's polynomial. */
public final class ArcTangent {
    private ArcTangent() {}

    /** The arc tangent of ratios in [0, 1]. */
    public static FloatVector of(FloatVector ratio) {
        FloatVector s = ratio.mul(ratio);
        FloatVector polynomial = Lanes.fma(s, KernelMath.ATAN_8, KernelMath.ATAN_7);
        polynomial = Lanes.fma(polynomial, s, Lanes.all(KernelMath.ATAN_6));
        polynomial = Lanes.fma(polynomial, s, Lanes.all(KernelMath.ATAN_5));
        polynomial = Lanes.fma(polynomial, s, Lanes.all(KernelMath.ATAN_4));
        polynomial = Lanes.fma(polynomial, s, Lanes.all(KernelMath.ATAN_3));
        polynomial = Lanes.fma(polynomial, s, Lanes.all(KernelMath.ATAN_2));
        polynomial = Lanes.fma(polynomial, s, Lanes.all(KernelMath.ATAN_1));
        return Lanes.fma(ratio, polynomial.mul(s), ratio);
    }
}
