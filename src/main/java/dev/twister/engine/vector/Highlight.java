package dev.twister.engine.vector;

import dev.twister.kernel.Layout;
import jdk.incubator.vector.FloatVector;
import jdk.incubator.vector.IntVector;
import jdk.incubator.vector.VectorMask;
import jdk.incubator.vector.VectorOperators;

/** The specular part of Blinn-Phong: {@link dev.twister.kernel.Shading#specular}. */
final class Highlight {
    private static final float INVERSE_EIGHT_PI = 0.039788734f;
    private static final int FRACTION_DIGITS = 12;

    // Called by way of arrays, so that each keeps its own inlining budget: see Stage.
    private static final PacketStage[] FRACTIONS = {
        (tile, drawing, at) -> findFraction(tile.values, at),
        (tile, drawing, at) -> raiseEach(tile.values, at),
        (tile, drawing, at) -> multiply(tile.values, at),
    };

    private static final PacketStage[] WHOLE = {(tile, drawing, at) -> raiseEach(tile.values, at)};
    private static final PacketStage[] SAME = {(tile, drawing, at) -> raiseAll(tile.values, at)};

    private Highlight() {}

    /** Writes {@code max(0, N.H)}, at most 1, and 0 where the light is behind, to the specular column. */
    static void findCosines(Tile tile) {
        float[] t = tile.values;
        for (int k = 0; k < tile.surfaces.count; k++) {
            int at = tile.surfaces.places[k];
            FloatVector x = half(t, at, Tile.TO_LIGHT_X, Tile.DIRECTION_X);
            FloatVector y = half(t, at, Tile.TO_LIGHT_Y, Tile.DIRECTION_Y);
            FloatVector z = half(t, at, Tile.TO_LIGHT_Z, Tile.DIRECTION_Z);
            FloatVector normalDotHalf = x.fma(
                    Lanes.load(t, at + Tile.NORMAL_X),
                    y.fma(Lanes.load(t, at + Tile.NORMAL_Y), z.mul(Lanes.load(t, at + Tile.NORMAL_Z))));
            FloatVector cosine = normalDotHalf.mul(Lanes.inverseRoot(x.fma(x, y.fma(y, z.mul(z)))));
            Lanes.smaller(Lanes.larger(cosine, Lanes.all(0f)), Lanes.all(1f)).intoArray(t, at + Tile.SPECULAR);
        }
    }

    private static FloatVector half(float[] t, int at, int toLight, int direction) {
        return Lanes.load(t, at + toLight).sub(Lanes.load(t, at + direction));
    }

    /** Writes what the cosines' powers are to be multiplied by: 0 where nothing shines. */
    static void findWeights(Tile tile) {
        float[] t = tile.values;
        for (int k = 0; k < tile.surfaces.count; k++) {
            int at = tile.surfaces.places[k];
            FloatVector reflectivity = Lanes.load(t, at + Tile.REFLECTIVITY);
            FloatVector weight = reflectivity
                    .add(8f)
                    .mul(INVERSE_EIGHT_PI)
                    .mul(reflectivity)
                    .mul(1f / Layout.MAX_REFLECTIVITY)
                    .mul(Lanes.load(t, at + Tile.VISIBLE));
            Lanes.all(0f)
                    .blend(weight, Lanes.load(t, at + Tile.NORMAL_DOT_LIGHT).compare(VectorOperators.GT, 0f))
                    .intoArray(t, at + Tile.SPECULAR_WEIGHT);
        }
    }

    /** Raises the cosines to the reflectivities' powers where anything shines. */
    static void raise(Tile tile, Drawing drawing) {
        float[] t = tile.values;
        for (int k = 0; k < tile.surfaces.count; k++) {
            int at = tile.surfaces.places[k];
            if (Lanes.load(t, at + Tile.SPECULAR_WEIGHT)
                    .compare(VectorOperators.GT, 0f)
                    .anyTrue()) {
                for (PacketStage power : powers(t, at)) {
                    power.run(tile, drawing, at);
                }
            }
        }
    }

    /** Scales the powers. */
    static void scale(Tile tile) {
        float[] t = tile.values;
        for (int k = 0; k < tile.surfaces.count; k++) {
            int at = tile.surfaces.places[k];
            Lanes.load(t, at + Tile.SPECULAR)
                    .mul(Lanes.load(t, at + Tile.SPECULAR_WEIGHT))
                    .intoArray(t, at + Tile.SPECULAR);
        }
    }

    /** What replaces one packet's cosines by their powers. */
    private static PacketStage[] powers(float[] t, int at) {
        FloatVector exponent = Lanes.load(t, at + Tile.REFLECTIVITY);
        boolean same =
                !exponent.compare(VectorOperators.NE, t[at + Tile.REFLECTIVITY]).anyTrue();
        boolean whole = !Lanes.toFloats(Lanes.truncated(exponent))
                .compare(VectorOperators.NE, exponent)
                .anyTrue();
        PacketStage[] ofWhole = same ? SAME : WHOLE;
        return whole ? ofWhole : FRACTIONS;
    }

    /** All lanes to one whole power, by repeated squaring. */
    private static void raiseAll(float[] t, int at) {
        FloatVector square = Lanes.load(t, at + Tile.SPECULAR);
        FloatVector result = Lanes.all(1f);
        for (int rest = (int) t[at + Tile.REFLECTIVITY]; rest > 0; rest = rest >> 1) {
            if ((rest & 1) != 0) {
                result = result.mul(square);
            }
            square = square.mul(square);
        }
        result.intoArray(t, at + Tile.SPECULAR);
    }

    /** Each lane to its own power's whole part. */
    private static void raiseEach(float[] t, int at) {
        FloatVector square = Lanes.load(t, at + Tile.SPECULAR);
        IntVector rest = Lanes.truncated(Lanes.load(t, at + Tile.REFLECTIVITY));
        FloatVector result = Lanes.all(1f);
        while (rest.compare(VectorOperators.GT, 0).anyTrue()) {
            VectorMask<Float> taken = rest.and(1).compare(VectorOperators.NE, 0).cast(Lanes.FLOATS);
            result = result.blend(result.mul(square), taken);
            square = square.mul(square);
            rest = rest.lanewise(VectorOperators.LSHR, 1);
        }
        result.intoArray(t, at + Tile.SPECULAR);
    }

    /** Each lane to its own power's fraction, to a column of its own: a square root for each of its binary digits. */
    private static void findFraction(float[] t, int at) {
        FloatVector exponent = Lanes.load(t, at + Tile.REFLECTIVITY);
        FloatVector rest = exponent.sub(Lanes.toFloats(Lanes.truncated(exponent)));
        FloatVector root = Lanes.load(t, at + Tile.SPECULAR);
        FloatVector result = Lanes.all(1f);
        VectorMask<Float> whole = rest.compare(VectorOperators.LE, 0f);
        for (int digit = 0; digit < FRACTION_DIGITS; digit++) {
            root = root.sqrt();
            rest = rest.add(rest);
            VectorMask<Float> taken = rest.compare(VectorOperators.GE, 1f);
            result = result.blend(result.mul(root), taken);
            rest = rest.blend(rest.sub(1f), taken);
        }
        FloatVector last = rest.fma(root.sub(1f), Lanes.all(1f));
        result.mul(last).blend(1f, whole).intoArray(t, at + Tile.FRACTION_POWER);
    }

    private static void multiply(float[] t, int at) {
        Lanes.load(t, at + Tile.SPECULAR)
                .mul(Lanes.load(t, at + Tile.FRACTION_POWER))
                .intoArray(t, at + Tile.SPECULAR);
    }
}
