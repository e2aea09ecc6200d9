package dev.twister.engine.vector.step;

import dev.twister.engine.vector.lanes.Lanes;
import dev.twister.engine.vector.lanes.PacketList;
import dev.twister.engine.vector.lanes.Tile;
import dev.twister.kernel.Illumination;
import dev.twister.kernel.KernelMath;
import dev.twister.kernel.Layout;
import jdk.incubator.vector.FloatVector;
import jdk.incubator.vector.IntVector;
import jdk.incubator.vector.VectorMask;
import jdk.incubator.vector.VectorOperators;

/** The specular term of Blinn-Phong: {@link Illumination#specular}. */
public final class Highlight {
    private Highlight() {}

    /** Writes the specular column. */
    public static void find(Tile tile) {
        findCosines(tile);
        sort(tile);
        raise(tile);
    }

    /**
     * Writes {@code max(0, N.H)}, at most 1, to the specular column. It is 0 for NaN, which lanes without a surface may
     * hold.
     */
    static void findCosines(Tile tile) {
        float[] t = tile.values;
        for (int k = 0; k < tile.surfaces.count; k++) {
            int at = tile.surfaces.places[k];
            FloatVector x = Lanes.load(t, at + Tile.TO_LIGHT_X).sub(Lanes.load(t, at + Tile.DIRECTION_X));
            FloatVector y = Lanes.load(t, at + Tile.TO_LIGHT_Y).sub(Lanes.load(t, at + Tile.DIRECTION_Y));
            FloatVector z = Lanes.load(t, at + Tile.TO_LIGHT_Z).sub(Lanes.load(t, at + Tile.DIRECTION_Z));
            FloatVector normalDotHalf = Lanes.fma(
                    x,
                    Lanes.load(t, at + Tile.NORMAL_X),
                    Lanes.fma(y, Lanes.load(t, at + Tile.NORMAL_Y), z.mul(Lanes.load(t, at + Tile.NORMAL_Z))));
            FloatVector cosine = normalDotHalf.mul(Lanes.inverseRoot(Lanes.fma(x, x, Lanes.fma(y, y, z.mul(z)))));
            Lanes.smaller(Lanes.larger(Lanes.all(0f), cosine), Lanes.all(1f)).intoArray(t, at + Tile.SPECULAR);
        }
    }

    /**
     * Writes the factors for the cosines' powers, 0 in lanes without a highlight. Lists the packets with highlights by
     * the kind of their exponents, and sets the specular column of the others to 0.
     */
    public static void sort(Tile tile) {
        tile.onePower.clear();
        tile.wholePowers.clear();
        tile.fractionPowers.clear();
        float[] t = tile.values;
        for (int k = 0; k < tile.surfaces.count; k++) {
            int at = tile.surfaces.places[k];
            FloatVector power = Lanes.load(t, at + Tile.REFLECTIVITY);
            FloatVector weight = power.add(8f)
                    .mul(Illumination.INVERSE_EIGHT_PI)
                    .mul(power)
                    .mul(1f / Layout.MAX_REFLECTIVITY)
                    .mul(Lanes.load(t, at + Tile.VISIBLE));
            weight = Lanes.all(0f)
                    .blend(weight, Lanes.load(t, at + Tile.NORMAL_DOT_LIGHT).compare(VectorOperators.GT, 0f));
            VectorMask<Float> shines = weight.compare(VectorOperators.GT, 0f);
            if (shines.anyTrue()) {
                weight.intoArray(t, at + Tile.SPECULAR_WEIGHT);
                boolean whole = !Lanes.toFloats(Lanes.truncated(power))
                        .compare(VectorOperators.NE, power)
                        .and(shines)
                        .anyTrue();
                float first = t[at + Tile.REFLECTIVITY + shines.firstTrue()];
                boolean one =
                        !power.compare(VectorOperators.NE, first).and(shines).anyTrue();
                if (!whole) {
                    tile.fractionPowers.add(at);
                } else if (one) {
                    tile.onePower.add(at);
                    tile.powers[at / Lanes.COUNT] = first;
                } else {
                    tile.wholePowers.add(at);
                }
            } else {
                Lanes.all(0f).intoArray(t, at + Tile.SPECULAR);
            }
        }
    }

    /** Raises the cosines to the reflectivities and applies the factors, in packets with highlights. */
    public static void raise(Tile tile) {
        if (tile.onePower.count > 0) {
            raiseAll(tile);
        }
        if (tile.wholePowers.count > 0) {
            raiseEach(tile, tile.wholePowers, Tile.SPECULAR_WEIGHT);
        }
        if (tile.fractionPowers.count > 0) {
            findFractions(tile);
            raiseEach(tile, tile.fractionPowers, Tile.FRACTION_POWER);
            weigh(tile, tile.fractionPowers);
        }
    }

    /** Raises all lanes to the packet's exponent by repeated squaring, and applies their factors. */
    static void raiseAll(Tile tile) {
        float[] t = tile.values;
        for (int k = 0; k < tile.onePower.count; k++) {
            int at = tile.onePower.places[k];
            FloatVector square = Lanes.load(t, at + Tile.SPECULAR);
            FloatVector result = Lanes.all(1f);
            for (int rest = (int) tile.powers[at / Lanes.COUNT]; rest > 0; rest = rest >> 1) {
                if ((rest & 1) != 0) {
                    result = result.mul(square);
                }
                square = square.mul(square);
            }
            result.mul(Lanes.load(t, at + Tile.SPECULAR_WEIGHT)).intoArray(t, at + Tile.SPECULAR);
        }
    }

    /** Raises each lane to the integer part of its exponent, and multiplies by the {@code factor} column. */
    static void raiseEach(Tile tile, PacketList packets, int factor) {
        float[] t = tile.values;
        for (int k = 0; k < packets.count; k++) {
            int at = packets.places[k];
            FloatVector square = Lanes.load(t, at + Tile.SPECULAR);
            IntVector rest = Lanes.truncated(Lanes.load(t, at + Tile.REFLECTIVITY));
            FloatVector result = Lanes.all(1f);
            while (rest.compare(VectorOperators.GT, 0).anyTrue()) {
                VectorMask<Float> taken =
                        rest.and(1).compare(VectorOperators.NE, 0).cast(Lanes.FLOATS);
                result = result.blend(result.mul(square), taken);
                square = square.mul(square);
                rest = rest.lanewise(VectorOperators.LSHR, 1);
            }
            result.mul(Lanes.load(t, at + factor)).intoArray(t, at + Tile.SPECULAR);
        }
    }

    /** Raises each lane to the fractional part of its exponent, with a square root per binary digit. */
    static void findFractions(Tile tile) {
        float[] t = tile.values;
        for (int k = 0; k < tile.fractionPowers.count; k++) {
            int at = tile.fractionPowers.places[k];
            FloatVector power = Lanes.load(t, at + Tile.REFLECTIVITY);
            FloatVector rest = power.sub(Lanes.toFloats(Lanes.truncated(power)));
            FloatVector root = Lanes.load(t, at + Tile.SPECULAR);
            FloatVector result = Lanes.all(1f);
            VectorMask<Float> whole = rest.compare(VectorOperators.LE, 0f);
            for (int digit = 0; digit < KernelMath.FRACTION_DIGITS; digit++) {
                root = root.sqrt();
                rest = rest.add(rest);
                VectorMask<Float> taken = rest.compare(VectorOperators.GE, 1f);
                result = result.blend(result.mul(root), taken);
                rest = rest.blend(rest.sub(1f), taken);
            }
            FloatVector last = Lanes.fma(rest, root.sub(1f), Lanes.all(1f));
            result.mul(last).blend(1f, whole).intoArray(t, at + Tile.FRACTION_POWER);
        }
    }

    static void weigh(Tile tile, PacketList packets) {
        float[] t = tile.values;
        for (int k = 0; k < packets.count; k++) {
            int at = packets.places[k];
            Lanes.load(t, at + Tile.SPECULAR)
                    .mul(Lanes.load(t, at + Tile.SPECULAR_WEIGHT))
                    .intoArray(t, at + Tile.SPECULAR);
        }
    }
}
