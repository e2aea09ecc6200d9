package dev.twister.engine.vector.step;

import dev.twister.engine.vector.frame.Drawing;
import dev.twister.engine.vector.lanes.FacetWeight;
import dev.twister.engine.vector.lanes.Hash;
import dev.twister.engine.vector.lanes.Lanes;
import dev.twister.engine.vector.lanes.PacketList;
import dev.twister.engine.vector.lanes.Sine;
import dev.twister.engine.vector.lanes.Tile;
import dev.twister.kernel.Layout;
import dev.twister.kernel.Noise;
import jdk.incubator.vector.FloatVector;
import jdk.incubator.vector.IntVector;
import jdk.incubator.vector.VectorMask;
import jdk.incubator.vector.VectorOperators;

/** Facets of surfaces, and the rays that they reflect: {@link dev.twister.kernel.Facet}. */
public final class FacetLanes {
    private FacetLanes() {}

    /** Writes the facets of some packets; a smooth surface is its own. */
    public static void find(Drawing drawing, Tile tile, PacketList packets, int bounce) {
        face(tile, packets);
        if (tile.rough.count > 0) {
            int place = Noise.surface(bounce);
            findNumbers(tile, drawing, place, Tile.FIRST_NUMBER);
            findNumbers(tile, drawing, place + 1, Tile.SECOND_NUMBER);
            tilt(tile);
        }
    }

    /** Turns the normals against the rays. */
    static void face(Tile tile, PacketList packets) {
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

    /** Writes a number of the sample, shifted by a hash of each pixel. */
    static void findNumbers(Tile tile, Drawing drawing, int place, int column) {
        float[] t = tile.values;
        float shared = drawing.input.view().pixelSamples()[Layout.SAMPLE_STRIDE * tile.sample + place];
        int columns = Noise.mixed(2 * place);
        int rows = Noise.mixed(2 * place + 1);
        int left = tile.left;
        int top = drawing.input.firstRow() + tile.top;
        for (int k = 0; k < tile.rough.count; k++) {
            int at = tile.rough.places[k];
            IntVector x = Lanes.truncated(Lanes.load(t, at + Tile.PLACE_X)).add(left);
            IntVector y = Lanes.truncated(Lanes.load(t, at + Tile.PLACE_Y)).add(top);
            IntVector hash = Hash.mixed(Hash.mixed(x.lanewise(VectorOperators.XOR, columns))
                    .lanewise(VectorOperators.XOR, Hash.mixed(y.lanewise(VectorOperators.XOR, rows))));
            FloatVector number = Lanes.toFloats(hash).mul(Noise.STEP).add(shared);
            number.blend(number.sub(1f), number.compare(VectorOperators.GE, 1f)).intoArray(t, at + column);
        }
    }

    /** Tilts the facets of rough surfaces, which are the surfaces' normals so far. */
    static void tilt(Tile tile) {
        float[] t = tile.values;
        for (int k = 0; k < tile.rough.count; k++) {
            int at = tile.rough.places[k];
            FloatVector roughness = Lanes.load(t, at + Tile.ROUGHNESS);
            FloatVector alpha = roughness.mul(roughness);
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
            FloatVector crossZ = normalY.neg();
            FloatVector viewX = Lanes.load(t, at + Tile.DIRECTION_X).neg();
            FloatVector viewY = Lanes.load(t, at + Tile.DIRECTION_Y).neg();
            FloatVector viewZ = Lanes.load(t, at + Tile.DIRECTION_Z).neg();
            FloatVector x =
                    alpha.mul(viewX.mul(tangentX).add(viewY.mul(tangentY)).add(viewZ.mul(tangentZ)));
            FloatVector y = alpha.mul(viewX.mul(b).add(viewY.mul(crossY)).add(viewZ.mul(crossZ)));
            FloatVector z =
                    Lanes.larger(viewX.mul(normalX).add(viewY.mul(normalY)).add(viewZ.mul(normalZ)), Lanes.all(0f));
            FloatVector inverse = Lanes.inverseRoot(x.mul(x).add(y.mul(y)).add(z.mul(z)));
            x = x.mul(inverse);
            y = y.mul(inverse);
            z = z.mul(inverse);
            FloatVector first = Lanes.load(t, at + Tile.FIRST_NUMBER);
            FloatVector height = Lanes.all(1f)
                    .sub(Lanes.load(t, at + Tile.SECOND_NUMBER))
                    .mul(z.add(1f))
                    .sub(z);
            FloatVector radius = Lanes.larger(Lanes.all(1f).sub(height.mul(height)), Lanes.all(0f))
                    .sqrt();
            x = alpha.mul(x.add(radius.mul(Sine.cosineOfTurns(first))));
            y = alpha.mul(y.add(radius.mul(Sine.ofTurns(first))));
            z = z.add(height);
            inverse = Lanes.inverseRoot(x.mul(x).add(y.mul(y)).add(z.mul(z)));
            VectorMask<Float> rough = roughness.compare(VectorOperators.GT, 0f);
            normalX.blend(x.mul(tangentX).add(y.mul(b)).add(z.mul(normalX)).mul(inverse), rough)
                    .intoArray(t, at + Tile.FACET_X);
            normalY.blend(x.mul(tangentY).add(y.mul(crossY)).add(z.mul(normalY)).mul(inverse), rough)
                    .intoArray(t, at + Tile.FACET_Y);
            normalZ.blend(x.mul(tangentZ).add(y.mul(crossZ)).add(z.mul(normalZ)).mul(inverse), rough)
                    .intoArray(t, at + Tile.FACET_Z);
        }
    }

    /** Mirrors some packets' rays at the facets; a rough surface passes on a part of their throughput. */
    public static void reflect(Tile tile, PacketList packets) {
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
            FloatVector normalX = Lanes.load(t, at + Tile.NORMAL_X);
            FloatVector normalY = Lanes.load(t, at + Tile.NORMAL_Y);
            FloatVector normalZ = Lanes.load(t, at + Tile.NORMAL_Z);
            FloatVector in =
                    directionX.mul(normalX).add(directionY.mul(normalY)).add(directionZ.mul(normalZ));
            FloatVector out = x.mul(normalX).add(y.mul(normalY)).add(z.mul(normalZ));
            out = out.blend(out.neg(), in.compare(VectorOperators.GT, 0f));
            Lanes.load(t, at + Tile.THROUGHPUT)
                    .mul(FacetWeight.of(Lanes.load(t, at + Tile.ROUGHNESS), in.abs(), out))
                    .intoArray(t, at + Tile.THROUGHPUT);
            FloatVector inverse = Lanes.inverseRoot(x.mul(x).add(y.mul(y)).add(z.mul(z)));
            x.mul(inverse).intoArray(t, at + Tile.DIRECTION_X);
            y.mul(inverse).intoArray(t, at + Tile.DIRECTION_Y);
            z.mul(inverse).intoArray(t, at + Tile.DIRECTION_Z);
        }
    }
}
