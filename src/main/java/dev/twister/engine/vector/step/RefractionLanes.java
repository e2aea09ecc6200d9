package dev.twister.engine.vector.step;

import dev.twister.engine.vector.frame.Drawing;
import dev.twister.engine.vector.lanes.Lanes;
import dev.twister.engine.vector.lanes.Tile;
import dev.twister.kernel.Layout;
import jdk.incubator.vector.FloatVector;
import jdk.incubator.vector.VectorMask;
import jdk.incubator.vector.VectorOperators;

/** Refracted rays and their share of the light: {@link dev.twister.kernel.Refraction}. */
public final class RefractionLanes {
    private RefractionLanes() {}

    /**
     * Writes the refracted rays and their part of the throughput, and adds the Fresnel reflection to the throughput of
     * the reflected rays. Requires the facets and the incoming rays.
     */
    public static void find(Drawing drawing, Tile tile) {
        findAll(tile, drawing.looks.transmits(Layout.PLANE));
        if (tile.rough.count > 0) {
            findCosines(tile);
            FacetLanes.weigh(tile, Tile.REFRACTED_PART);
        }
    }

    private static void findAll(Tile tile, boolean sheet) {
        float[] t = tile.values;
        for (int k = 0; k < tile.surfaces.count; k++) {
            int at = tile.surfaces.places[k];
            Lanes.all(0f).intoArray(t, at + Tile.REFRACTED_PART);
        }
        for (int k = 0; k < tile.transparent.count; k++) {
            int at = tile.transparent.places[k];
            findReflectances(tile, at);
            findParts(tile, at);
            findDirections(tile, at);
            if (sheet) {
                passSheet(tile, at);
            }
        }
    }

    /**
     * Writes the factors of facet and incoming ray in the refracted direction to columns x and y, and the Fresnel
     * reflectance to z.
     */
    static void findReflectances(Tile tile, int at) {
        float[] t = tile.values;
        FloatVector cosine = Lanes.load(t, at + Tile.DIRECTION_X)
                .mul(Lanes.load(t, at + Tile.FACET_X))
                .add(Lanes.load(t, at + Tile.DIRECTION_Y).mul(Lanes.load(t, at + Tile.FACET_Y)))
                .add(Lanes.load(t, at + Tile.DIRECTION_Z).mul(Lanes.load(t, at + Tile.FACET_Z)))
                .neg();
        cosine = Lanes.smaller(Lanes.larger(cosine, Lanes.all(0f)), Lanes.all(1f));
        FloatVector index = Lanes.load(t, at + Tile.IOR);
        FloatVector ratio = Lanes.all(1f)
                .div(index)
                .blend(index, Lanes.load(t, at + Tile.FROM_INSIDE).compare(VectorOperators.GT, 0f));
        FloatVector squared =
                Lanes.all(1f).sub(ratio.mul(ratio).mul(Lanes.all(1f).sub(cosine.mul(cosine))));
        VectorMask<Float> passes = squared.compare(VectorOperators.GT, 0f);
        FloatVector passed = Lanes.larger(squared, Lanes.all(0f)).sqrt();
        FloatVector before = ratio.mul(cosine);
        FloatVector beyond = ratio.mul(passed);
        FloatVector across = before.sub(passed).div(before.add(passed));
        FloatVector along = cosine.sub(beyond).div(cosine.add(beyond));
        FloatVector reflectance =
                Lanes.all(1f).blend(across.mul(across).add(along.mul(along)).mul(0.5f), passes);
        reflectance.intoArray(t, at + Tile.REFRACTED_Z);
        ratio.intoArray(t, at + Tile.REFRACTED_Y);
        before.sub(passed).intoArray(t, at + Tile.REFRACTED_X);
    }

    /** Writes the refracted part of the throughput, and adds the reflected part to the throughput. */
    static void findParts(Tile tile, int at) {
        float[] t = tile.values;
        FloatVector reflectance = Lanes.load(t, at + Tile.REFRACTED_Z);
        FloatVector transmission = Lanes.load(t, at + Tile.TRANSMISSION);
        VectorMask<Float> transmits = transmission.compare(VectorOperators.GT, 0f);
        FloatVector kept =
                Lanes.all(1f).sub(Lanes.load(t, at + Tile.REFLECTIVITY).mul(1f / Layout.MAX_REFLECTIVITY));
        FloatVector passing = kept.mul(transmission).mul(Lanes.load(t, at + Tile.WHOLE));
        FloatVector through = passing.mul(Lanes.all(1f).sub(reflectance));
        Lanes.all(0f).blend(through, transmits).intoArray(t, at + Tile.REFRACTED_PART);
        FloatVector throughput = Lanes.load(t, at + Tile.THROUGHPUT);
        throughput.blend(throughput.add(passing.mul(reflectance)), transmits).intoArray(t, at + Tile.THROUGHPUT);
    }

    /** Writes the refracted directions by Snell's law. */
    static void findDirections(Tile tile, int at) {
        float[] t = tile.values;
        FloatVector ratio = Lanes.load(t, at + Tile.REFRACTED_Y);
        FloatVector along = Lanes.load(t, at + Tile.REFRACTED_X);
        FloatVector x =
                Lanes.load(t, at + Tile.DIRECTION_X).mul(ratio).add(along.mul(Lanes.load(t, at + Tile.FACET_X)));
        FloatVector y =
                Lanes.load(t, at + Tile.DIRECTION_Y).mul(ratio).add(along.mul(Lanes.load(t, at + Tile.FACET_Y)));
        FloatVector z =
                Lanes.load(t, at + Tile.DIRECTION_Z).mul(ratio).add(along.mul(Lanes.load(t, at + Tile.FACET_Z)));
        FloatVector inverse = Lanes.inverseRoot(x.mul(x).add(y.mul(y)).add(z.mul(z)));
        x.mul(inverse).intoArray(t, at + Tile.REFRACTED_X);
        y.mul(inverse).intoArray(t, at + Tile.REFRACTED_Y);
        z.mul(inverse).intoArray(t, at + Tile.REFRACTED_Z);
    }

    /** For the plane, which is infinitely thin: its transmitted ray is the reflected one on the other side. */
    static void passSheet(Tile tile, int at) {
        float[] t = tile.values;
        VectorMask<Float> sheet = Lanes.load(t, at + Tile.HIT).compare(VectorOperators.EQ, Layout.PLANE);
        FloatVector directionX = Lanes.load(t, at + Tile.DIRECTION_X);
        FloatVector directionY = Lanes.load(t, at + Tile.DIRECTION_Y);
        FloatVector directionZ = Lanes.load(t, at + Tile.DIRECTION_Z);
        FloatVector facetX = Lanes.load(t, at + Tile.FACET_X);
        FloatVector facetY = Lanes.load(t, at + Tile.FACET_Y);
        FloatVector facetZ = Lanes.load(t, at + Tile.FACET_Z);
        FloatVector cosine = directionX
                .mul(facetX)
                .add(directionY.mul(facetY))
                .add(directionZ.mul(facetZ))
                .neg();
        cosine = Lanes.smaller(Lanes.larger(cosine, Lanes.all(0f)), Lanes.all(1f));
        FloatVector twice = cosine.add(cosine);
        FloatVector x = directionX.add(twice.mul(facetX));
        FloatVector y = directionY.add(twice.mul(facetY)).neg();
        FloatVector z = directionZ.add(twice.mul(facetZ));
        FloatVector inverse = Lanes.inverseRoot(x.mul(x).add(y.mul(y)).add(z.mul(z)));
        Lanes.load(t, at + Tile.REFRACTED_X).blend(x.mul(inverse), sheet).intoArray(t, at + Tile.REFRACTED_X);
        Lanes.load(t, at + Tile.REFRACTED_Y).blend(y.mul(inverse), sheet).intoArray(t, at + Tile.REFRACTED_Y);
        Lanes.load(t, at + Tile.REFRACTED_Z).blend(z.mul(inverse), sheet).intoArray(t, at + Tile.REFRACTED_Z);
    }

    /** Writes the cosines of the rays and of the refracted rays with the normals of rough surfaces. */
    static void findCosines(Tile tile) {
        float[] t = tile.values;
        for (int k = 0; k < tile.rough.count; k++) {
            int at = tile.rough.places[k];
            FloatVector normalX = Lanes.load(t, at + Tile.NORMAL_X);
            FloatVector normalY = Lanes.load(t, at + Tile.NORMAL_Y);
            FloatVector normalZ = Lanes.load(t, at + Tile.NORMAL_Z);
            FloatVector in = Lanes.load(t, at + Tile.DIRECTION_X)
                    .mul(normalX)
                    .add(Lanes.load(t, at + Tile.DIRECTION_Y).mul(normalY))
                    .add(Lanes.load(t, at + Tile.DIRECTION_Z).mul(normalZ));
            FloatVector out = Lanes.load(t, at + Tile.REFRACTED_X)
                    .mul(normalX)
                    .add(Lanes.load(t, at + Tile.REFRACTED_Y).mul(normalY))
                    .add(Lanes.load(t, at + Tile.REFRACTED_Z).mul(normalZ));
            out = out.neg().blend(out, in.compare(VectorOperators.GT, 0f));
            in.abs().intoArray(t, at + Tile.COSINE_IN);
            out.intoArray(t, at + Tile.COSINE_OUT);
        }
    }
}
