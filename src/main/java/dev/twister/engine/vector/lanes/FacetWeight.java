package dev.twister.engine.vector.lanes;

import dev.twister.kernel.Facet;
import jdk.incubator.vector.FloatVector;
import jdk.incubator.vector.VectorOperators;

/** The weight of a microfacet sample on a rough surface: {@link Facet#weight}. */
public final class FacetWeight {
    private FacetWeight() {}

    /** 1 in smooth lanes; 0 where the ray leaves a rough surface on the wrong side. */
    public static FloatVector of(FloatVector roughness, FloatVector cosineIn, FloatVector cosineOut) {
        FloatVector alpha = roughness.mul(roughness);
        FloatVector squared = alpha.mul(alpha);
        FloatVector in = lambda(squared, cosineIn).add(1f);
        FloatVector weight = in.div(in.add(lambda(squared, cosineOut)));
        return weight.blend(0f, cosineOut.compare(VectorOperators.LE, 0f))
                .blend(1f, roughness.compare(VectorOperators.LE, 0f));
    }

    private static FloatVector lambda(FloatVector alphaSquared, FloatVector cosine) {
        FloatVector squared = Lanes.larger(cosine.mul(cosine), Lanes.all(Facet.LEAST_SQUARE));
        FloatVector slope = Lanes.all(1f).sub(Lanes.smaller(squared, Lanes.all(1f)));
        return alphaSquared.mul(slope).div(squared).add(1f).sqrt().mul(0.5f).sub(0.5f);
    }
}
