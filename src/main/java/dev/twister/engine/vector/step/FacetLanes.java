package dev.twister.engine.vector.step;

import dev.twister.engine.vector.frame.Drawing;
import dev.twister.engine.vector.lanes.FacetWeight;
import dev.twister.engine.vector.lanes.Lanes;
import dev.twister.engine.vector.lanes.PacketList;
import dev.twister.engine.vector.lanes.Sine;
import dev.twister.engine.vector.lanes.Tile;
import dev.twister.kernel.Noise;
import jdk.incubator.vector.FloatVector;
import jdk.incubator.vector.VectorMask;
import jdk.incubator.vector.VectorOperators;

/** Microfacets of surfaces and reflection at them: {@link dev.twister.kernel.Facet}. */
public final class FacetLanes {
    /** Offset in turns that makes a sine a cosine. */
    private static final float COSINE = 0.25f;

    private FacetLanes() {}

    /** Writes the facets of some packets; a smooth surface has its normal as the facet. */
    public static void find(Drawing drawing, Tile tile, PacketList packets, int bounce) {
        face(tile, packets);
        if (tile.rough.count > 0) {
            int place = Noise.surface(bounce);
            NumberLanes.find(tile, drawing, tile.rough, place, Tile.FIRST_NUMBER);
            NumberLanes.find(tile, drawing, tile.rough, place + 1, Tile.SECOND_NUMBER);
            findViews(tile);
            findHeights(tile);
            addAround(tile, COSINE, Tile.LOCAL_X);
            addAround(tile, 0f, Tile.LOCAL_Y);
            unstretch(tile);
            tilt(tile);
        }
    }

    /** Turns the normals toward the rays' origins. */
    public static void face(Tile tile, PacketList packets) {
        float[] t = tile.values;
        for (int k = 0; k < packets.count; k++) {
            int at = packets.places[k];
            FloatVector x = Lanes.load(t, at + Tile.NORMAL_X);
            FloatVector y = Lanes.load(t, at + Tile.NORMAL_Y);
            FloatVector z = Lanes.load(t, at + Tile.NORMAL_Z);
            VectorMask<Float> behind = Lanes.load(t, at + Tile.DIRECTION_X)
                    .mul(x)
                    .add(Lanes.load(t, at + Tile.DIRECTION_Y).mul(y))
                    .add(Lanes.load(t, at + Tile.DIRECTION_Z).mul(z))
                    .compare(VectorOperators.GT, 0f);
            x.blend(x.neg(), behind).intoArray(t, at + Tile.FACET_X);
            y.blend(y.neg(), behind).intoArray(t, at + Tile.FACET_Y);
            z.blend(z.neg(), behind).intoArray(t, at + Tile.FACET_Z);
        }
    }

    /** Writes the view directions in the stretched tangent frames. The facet columns still hold the normals. */
    static void findViews(Tile tile) {
        float[] t = tile.values;
        for (int k = 0; k < tile.rough.count; k++) {
            int at = tile.rough.places[k];
            FloatVector normalX = Lanes.load(t, at + Tile.FACET_X);
            FloatVector normalY = Lanes.load(t, at + Tile.FACET_Y);
            FloatVector normalZ = Lanes.load(t, at + Tile.FACET_Z);
            FloatVector sign = Lanes.all(1f).blend(-1f, normalZ.compare(VectorOperators.LT, 0f));
            FloatVector a = Lanes.all(-1f).div(sign.add(normalZ));
            FloatVector b = normalX.mul(normalY).mul(a);
            FloatVector tangentX = sign.mul(normalX).mul(normalX).mul(a).add(1f);
            FloatVector tangentY = sign.mul(b);
            FloatVector tangentZ = sign.mul(normalX).neg();
            FloatVector crossY = normalY.mul(normalY).mul(a).add(sign);
            FloatVector viewX = Lanes.load(t, at + Tile.DIRECTION_X).neg();
            FloatVector viewY = Lanes.load(t, at + Tile.DIRECTION_Y).neg();
            FloatVector viewZ = Lanes.load(t, at + Tile.DIRECTION_Z).neg();
            FloatVector roughness = Lanes.load(t, at + Tile.ROUGHNESS);
            FloatVector alpha = roughness.mul(roughness);
            viewX.mul(tangentX)
                    .add(viewY.mul(tangentY))
                    .add(viewZ.mul(tangentZ))
                    .mul(alpha)
                    .intoArray(t, at + Tile.LOCAL_X);
            viewX.mul(b)
                    .add(viewY.mul(crossY))
                    .sub(viewZ.mul(normalY))
                    .mul(alpha)
                    .intoArray(t, at + Tile.LOCAL_Y);
            viewX.mul(normalX).add(viewY.mul(normalY)).add(viewZ.mul(normalZ)).intoArray(t, at + Tile.LOCAL_Z);
        }
    }

    /**
     * Normalizes the view directions, and replaces the second random numbers by heights on the cap of visible
     * directions.
     */
    static void findHeights(Tile tile) {
        float[] t = tile.values;
        for (int k = 0; k < tile.rough.count; k++) {
            int at = tile.rough.places[k];
            FloatVector x = Lanes.load(t, at + Tile.LOCAL_X);
            FloatVector y = Lanes.load(t, at + Tile.LOCAL_Y);
            FloatVector z = Lanes.larger(Lanes.load(t, at + Tile.LOCAL_Z), Lanes.all(0f));
            FloatVector inverse = Lanes.inverseRoot(x.mul(x).add(y.mul(y)).add(z.mul(z)));
            z = z.mul(inverse);
            x.mul(inverse).intoArray(t, at + Tile.LOCAL_X);
            y.mul(inverse).intoArray(t, at + Tile.LOCAL_Y);
            z.intoArray(t, at + Tile.LOCAL_Z);
            Lanes.all(1f)
                    .sub(Lanes.load(t, at + Tile.SECOND_NUMBER))
                    .mul(z.add(1f))
                    .sub(z)
                    .intoArray(t, at + Tile.SECOND_NUMBER);
        }
    }

    /** Adds one component of the cap's points at those heights. */
    static void addAround(Tile tile, float turn, int axis) {
        float[] t = tile.values;
        for (int k = 0; k < tile.rough.count; k++) {
            int at = tile.rough.places[k];
            FloatVector height = Lanes.load(t, at + Tile.SECOND_NUMBER);
            FloatVector radius = Lanes.larger(Lanes.all(1f).sub(height.mul(height)), Lanes.all(0f))
                    .sqrt();
            FloatVector turns = Lanes.load(t, at + Tile.FIRST_NUMBER).add(turn);
            FloatVector sine = Sine.ofTurns(turns.blend(turns.sub(1f), turns.compare(VectorOperators.GE, 1f)));
            Lanes.load(t, at + axis).add(radius.mul(sine)).intoArray(t, at + axis);
        }
    }

    /** Unstretches the sums into facet normals in the tangent frame. */
    static void unstretch(Tile tile) {
        float[] t = tile.values;
        for (int k = 0; k < tile.rough.count; k++) {
            int at = tile.rough.places[k];
            FloatVector roughness = Lanes.load(t, at + Tile.ROUGHNESS);
            FloatVector alpha = roughness.mul(roughness);
            FloatVector x = alpha.mul(Lanes.load(t, at + Tile.LOCAL_X));
            FloatVector y = alpha.mul(Lanes.load(t, at + Tile.LOCAL_Y));
            FloatVector z = Lanes.load(t, at + Tile.LOCAL_Z).add(Lanes.load(t, at + Tile.SECOND_NUMBER));
            FloatVector inverse = Lanes.inverseRoot(x.mul(x).add(y.mul(y)).add(z.mul(z)));
            x.mul(inverse).intoArray(t, at + Tile.LOCAL_X);
            y.mul(inverse).intoArray(t, at + Tile.LOCAL_Y);
            z.mul(inverse).intoArray(t, at + Tile.LOCAL_Z);
        }
    }

    /** Transforms the facet normals from the tangent frames to world space. */
    static void tilt(Tile tile) {
        float[] t = tile.values;
        for (int k = 0; k < tile.rough.count; k++) {
            int at = tile.rough.places[k];
            FloatVector normalX = Lanes.load(t, at + Tile.FACET_X);
            FloatVector normalY = Lanes.load(t, at + Tile.FACET_Y);
            FloatVector normalZ = Lanes.load(t, at + Tile.FACET_Z);
            FloatVector sign = Lanes.all(1f).blend(-1f, normalZ.compare(VectorOperators.LT, 0f));
            FloatVector a = Lanes.all(-1f).div(sign.add(normalZ));
            FloatVector b = normalX.mul(normalY).mul(a);
            FloatVector tangentX = sign.mul(normalX).mul(normalX).mul(a).add(1f);
            FloatVector tangentY = sign.mul(b);
            FloatVector tangentZ = sign.mul(normalX).neg();
            FloatVector crossY = normalY.mul(normalY).mul(a).add(sign);
            FloatVector x = Lanes.load(t, at + Tile.LOCAL_X);
            FloatVector y = Lanes.load(t, at + Tile.LOCAL_Y);
            FloatVector z = Lanes.load(t, at + Tile.LOCAL_Z);
            VectorMask<Float> rough = Lanes.load(t, at + Tile.ROUGHNESS).compare(VectorOperators.GT, 0f);
            normalX.blend(x.mul(tangentX).add(y.mul(b)).add(z.mul(normalX)), rough)
                    .intoArray(t, at + Tile.FACET_X);
            normalY.blend(x.mul(tangentY).add(y.mul(crossY)).add(z.mul(normalY)), rough)
                    .intoArray(t, at + Tile.FACET_Y);
            normalZ.blend(x.mul(tangentZ).sub(y.mul(normalY)).add(z.mul(normalZ)), rough)
                    .intoArray(t, at + Tile.FACET_Z);
        }
    }

    /** Reflects some packets' rays at their facets; rough surfaces reduce the throughput. */
    public static void reflect(Tile tile, PacketList packets) {
        if (tile.rough.count > 0) {
            findCosines(tile);
            weigh(tile, Tile.THROUGHPUT);
        }
        turn(tile, packets);
    }

    /** Writes the cosines of the rays and of their reflections with the normals of rough surfaces. */
    static void findCosines(Tile tile) {
        float[] t = tile.values;
        for (int k = 0; k < tile.rough.count; k++) {
            int at = tile.rough.places[k];
            FloatVector directionX = Lanes.load(t, at + Tile.DIRECTION_X);
            FloatVector directionY = Lanes.load(t, at + Tile.DIRECTION_Y);
            FloatVector directionZ = Lanes.load(t, at + Tile.DIRECTION_Z);
            FloatVector facetX = Lanes.load(t, at + Tile.FACET_X);
            FloatVector facetY = Lanes.load(t, at + Tile.FACET_Y);
            FloatVector facetZ = Lanes.load(t, at + Tile.FACET_Z);
            FloatVector normalX = Lanes.load(t, at + Tile.NORMAL_X);
            FloatVector normalY = Lanes.load(t, at + Tile.NORMAL_Y);
            FloatVector normalZ = Lanes.load(t, at + Tile.NORMAL_Z);
            FloatVector cosine = directionX
                    .mul(facetX)
                    .add(directionY.mul(facetY))
                    .add(directionZ.mul(facetZ))
                    .neg();
            cosine = Lanes.smaller(Lanes.larger(cosine, Lanes.all(0f)), Lanes.all(1f));
            FloatVector in =
                    directionX.mul(normalX).add(directionY.mul(normalY)).add(directionZ.mul(normalZ));
            FloatVector tilted = facetX.mul(normalX).add(facetY.mul(normalY)).add(facetZ.mul(normalZ));
            FloatVector out = in.add(cosine.add(cosine).mul(tilted));
            out = out.blend(out.neg(), in.compare(VectorOperators.GT, 0f));
            in.abs().intoArray(t, at + Tile.COSINE_IN);
            out.intoArray(t, at + Tile.COSINE_OUT);
        }
    }

    /**
     * Multiplies parts of the light by the weight of the facet sample on rough surfaces.
     *
     * @param column the tile's column of the parts
     */
    static void weigh(Tile tile, int column) {
        float[] t = tile.values;
        for (int k = 0; k < tile.rough.count; k++) {
            int at = tile.rough.places[k];
            FloatVector weight = FacetWeight.of(
                    Lanes.load(t, at + Tile.ROUGHNESS),
                    Lanes.load(t, at + Tile.COSINE_IN),
                    Lanes.load(t, at + Tile.COSINE_OUT));
            FloatVector part = Lanes.load(t, at + column);
            part.blend(part.mul(weight), part.compare(VectorOperators.GT, 0f)).intoArray(t, at + column);
        }
    }

    static void turn(Tile tile, PacketList packets) {
        float[] t = tile.values;
        for (int k = 0; k < packets.count; k++) {
            int at = packets.places[k];
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
            FloatVector y = directionY.add(twice.mul(facetY));
            FloatVector z = directionZ.add(twice.mul(facetZ));
            FloatVector inverse = Lanes.inverseRoot(x.mul(x).add(y.mul(y)).add(z.mul(z)));
            x.mul(inverse).intoArray(t, at + Tile.DIRECTION_X);
            y.mul(inverse).intoArray(t, at + Tile.DIRECTION_Y);
            z.mul(inverse).intoArray(t, at + Tile.DIRECTION_Z);
        }
    }
}
