package dev.twister.engine.vector.step;

import dev.twister.engine.vector.lanes.FacetWeight;
import dev.twister.engine.vector.lanes.Lanes;
import dev.twister.engine.vector.lanes.Tile;
import dev.twister.kernel.Layout;
import jdk.incubator.vector.FloatVector;
import jdk.incubator.vector.VectorMask;
import jdk.incubator.vector.VectorOperators;

/** What passes a surface that transmits, and which way: {@link dev.twister.kernel.Refraction}. */
public final class RefractionLanes {
    private RefractionLanes() {}

    /**
     * Writes the refracted rays and their parts of the throughput, and adds what is reflected besides to the throughput, which is
     * what the mirror sends on. The facets are known, and the rays are still those that have met the surfaces.
     */
    public static void find(Tile tile) {
        float[] t = tile.values;
        for (int k = 0; k < tile.surfaces.count; k++) {
            int at = tile.surfaces.places[k];
            Lanes.all(0f).intoArray(t, at + Tile.REFRACTED_PART);
        }
        for (int k = 0; k < tile.transparent.count; k++) {
            int at = tile.transparent.places[k];
            findParts(tile, at);
            findDirections(tile, at);
        }
    }

    /** Fresnel's parts, and in the column of x the cosine of the refracted ray. */
    static void findParts(Tile tile, int at) {
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
        FloatVector mirror = Lanes.load(t, at + Tile.REFLECTIVITY).mul(1f / Layout.MAX_REFLECTIVITY);
        FloatVector transmission = Lanes.load(t, at + Tile.TRANSMISSION);
        FloatVector passing = Lanes.all(0f)
                .blend(
                        Lanes.all(1f).sub(mirror).mul(transmission).mul(Lanes.load(t, at + Tile.WHOLE)),
                        transmission.compare(VectorOperators.GT, 0f));
        FloatVector through = passing.mul(Lanes.all(1f).sub(reflectance));
        through.blend(0f, transmission.compare(VectorOperators.LE, 0f)).intoArray(t, at + Tile.REFRACTED_PART);
        FloatVector back = passing.mul(reflectance).blend(0f, transmission.compare(VectorOperators.LE, 0f));
        Lanes.load(t, at + Tile.THROUGHPUT).add(back).intoArray(t, at + Tile.THROUGHPUT);
        ratio.intoArray(t, at + Tile.REFRACTED_Y);
        before.sub(passed).intoArray(t, at + Tile.REFRACTED_X);
    }

    /** By Snell's law; what passes the plane, which is as thin as a sheet, is what it reflects, on its other side. */
    static void findDirections(Tile tile, int at) {
        float[] t = tile.values;
        FloatVector directionX = Lanes.load(t, at + Tile.DIRECTION_X);
        FloatVector directionY = Lanes.load(t, at + Tile.DIRECTION_Y);
        FloatVector directionZ = Lanes.load(t, at + Tile.DIRECTION_Z);
        FloatVector facetX = Lanes.load(t, at + Tile.FACET_X);
        FloatVector facetY = Lanes.load(t, at + Tile.FACET_Y);
        FloatVector facetZ = Lanes.load(t, at + Tile.FACET_Z);
        FloatVector normalX = Lanes.load(t, at + Tile.NORMAL_X);
        FloatVector normalY = Lanes.load(t, at + Tile.NORMAL_Y);
        FloatVector normalZ = Lanes.load(t, at + Tile.NORMAL_Z);
        FloatVector in = directionX.mul(normalX).add(directionY.mul(normalY)).add(directionZ.mul(normalZ));
        VectorMask<Float> behind = in.compare(VectorOperators.GT, 0f);
        VectorMask<Float> sheet = Lanes.load(t, at + Tile.HIT).compare(VectorOperators.EQ, Layout.PLANE);
        FloatVector ratio = Lanes.load(t, at + Tile.REFRACTED_Y).blend(1f, sheet);
        FloatVector cosine = directionX
                .mul(facetX)
                .add(directionY.mul(facetY))
                .add(directionZ.mul(facetZ))
                .neg();
        cosine = Lanes.smaller(Lanes.larger(cosine, Lanes.all(0f)), Lanes.all(1f));
        FloatVector along = Lanes.load(t, at + Tile.REFRACTED_X).blend(cosine.add(cosine), sheet);
        FloatVector x = directionX.mul(ratio).add(along.mul(facetX));
        FloatVector y = directionY.mul(ratio).add(along.mul(facetY));
        FloatVector z = directionZ.mul(ratio).add(along.mul(facetZ));
        FloatVector mirrored =
                x.mul(normalX).add(y.mul(normalY)).add(z.mul(normalZ)).mul(-2f);
        mirrored = Lanes.all(0f).blend(mirrored, sheet);
        x = x.add(mirrored.mul(normalX));
        y = y.add(mirrored.mul(normalY));
        z = z.add(mirrored.mul(normalZ));
        FloatVector out = x.mul(normalX).add(y.mul(normalY)).add(z.mul(normalZ));
        out = out.neg().blend(out, behind);
        Lanes.load(t, at + Tile.REFRACTED_PART)
                .mul(FacetWeight.of(Lanes.load(t, at + Tile.ROUGHNESS), in.abs(), out))
                .intoArray(t, at + Tile.REFRACTED_PART);
        FloatVector inverse = Lanes.inverseRoot(x.mul(x).add(y.mul(y)).add(z.mul(z)));
        x.mul(inverse).intoArray(t, at + Tile.REFRACTED_X);
        y.mul(inverse).intoArray(t, at + Tile.REFRACTED_Y);
        z.mul(inverse).intoArray(t, at + Tile.REFRACTED_Z);
    }
}
