package dev.twister.engine.vector.lanes;

import dev.twister.kernel.KernelMath;
import jdk.incubator.vector.FloatVector;
import jdk.incubator.vector.VectorOperators;

/** Sine, by the scalar kernel's polynomial. */
public final class Sine {
    private Sine() {}

    /** The sine of angles in turns, in [0, 1). */
    public static FloatVector ofTurns(FloatVector turns) {
        FloatVector x = turns.blend(Lanes.all(0.5f).sub(turns), turns.compare(VectorOperators.GT, 0.25f))
                .blend(turns.sub(1f), turns.compare(VectorOperators.GT, 0.75f));
        FloatVector s = x.mul(x);
        FloatVector polynomial = Lanes.fma(s, KernelMath.SINE_5, KernelMath.SINE_4);
        polynomial = Lanes.fma(polynomial, s, Lanes.all(KernelMath.SINE_3));
        polynomial = Lanes.fma(polynomial, s, Lanes.all(KernelMath.SINE_2));
        polynomial = Lanes.fma(polynomial, s, Lanes.all(KernelMath.SINE_1));
        return x.mul(Lanes.fma(polynomial, s, Lanes.all(KernelMath.SINE_0)));
    }
}
