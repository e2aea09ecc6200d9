package dev.twister.engine.vector.step;

import dev.twister.engine.vector.frame.Drawing;
import dev.twister.engine.vector.lanes.Hash;
import dev.twister.engine.vector.lanes.Lanes;
import dev.twister.engine.vector.lanes.PacketList;
import dev.twister.engine.vector.lanes.Tile;
import dev.twister.kernel.Layout;
import dev.twister.kernel.Noise;
import jdk.incubator.vector.FloatVector;
import jdk.incubator.vector.IntVector;
import jdk.incubator.vector.VectorOperators;

/**
 * The random numbers of a sample for rough surfaces and for the lens: {@link Noise#number}. Each method hashes once:
 * with more, C2 boxes the vectors.
 */
final class NumberLanes {
    private NumberLanes() {}

    /** Writes one of the sample's numbers in some packets. */
    static void find(Tile tile, Drawing drawing, PacketList packets, int place, int column) {
        int left = tile.left;
        int top = drawing.input.firstRow() + tile.top;
        mix(tile, packets, Tile.PLACE_X, left, Noise.columnKey(place), Tile.UPPER_LEFT);
        mix(tile, packets, Tile.PLACE_Y, top, Noise.rowKey(place), Tile.UPPER_RIGHT);
        join(tile, packets, Tile.UPPER_LEFT, Tile.UPPER_RIGHT);
        if (place < Layout.SAMPLE_STRIDE) {
            shift(tile, packets, drawing.input.view().sample(tile.sample, place), column);
        } else {
            int sample = (int) drawing.input.view().frame()[Layout.FIRST_SAMPLE] + tile.sample;
            mixAgain(tile, packets, sample & Noise.BITS);
            mixAgain(tile, packets, Noise.mixed((sample >> 16) ^ Noise.mixed(place)));
            mix(tile, packets, Tile.PLACE_Y, top, Noise.columnKey(place + 1), Tile.UPPER_RIGHT);
            mix(tile, packets, Tile.PLACE_X, left, Noise.rowKey(place + 1), Tile.LOWER_LEFT);
            join(tile, packets, Tile.UPPER_RIGHT, Tile.LOWER_LEFT);
            join(tile, packets, Tile.UPPER_RIGHT, Tile.UPPER_LEFT);
            write(tile, packets, column);
        }
    }

    /** Writes hashes of the pixels' columns or rows to a column of {@link Tile#corners}. */
    static void mix(Tile tile, PacketList packets, int from, int offset, int key, int to) {
        float[] t = tile.values;
        int[] hashes = tile.corners;
        for (int k = 0; k < packets.count; k++) {
            int at = packets.places[k];
            IntVector pixel = Lanes.truncated(Lanes.load(t, at + from)).add(offset);
            Hash.mixed(pixel.lanewise(VectorOperators.XOR, key)).intoArray(hashes, at + to);
        }
    }

    /** Replaces the hashes of one column by those of both. */
    static void join(Tile tile, PacketList packets, int column, int other) {
        int[] hashes = tile.corners;
        for (int k = 0; k < packets.count; k++) {
            int at = packets.places[k];
            IntVector first = IntVector.fromArray(Lanes.INTS, hashes, at + column);
            IntVector second = IntVector.fromArray(Lanes.INTS, hashes, at + other);
            Hash.mixed(first.lanewise(VectorOperators.XOR, second)).intoArray(hashes, at + column);
        }
    }

    /** Hashes the first column again with a number. */
    static void mixAgain(Tile tile, PacketList packets, int number) {
        int[] hashes = tile.corners;
        for (int k = 0; k < packets.count; k++) {
            int at = packets.places[k] + Tile.UPPER_LEFT;
            IntVector hash = IntVector.fromArray(Lanes.INTS, hashes, at);
            Hash.mixed(hash.lanewise(VectorOperators.XOR, number)).intoArray(hashes, at);
        }
    }

    /** Writes a number of the frame, shifted by each pixel's hash. */
    static void shift(Tile tile, PacketList packets, float shared, int column) {
        float[] t = tile.values;
        for (int k = 0; k < packets.count; k++) {
            int at = packets.places[k];
            FloatVector number = Lanes.toFloats(IntVector.fromArray(Lanes.INTS, tile.corners, at + Tile.UPPER_LEFT))
                    .mul(Noise.STEP)
                    .add(shared);
            number.blend(number.sub(1f), number.compare(VectorOperators.GE, 1f)).intoArray(t, at + column);
        }
    }

    /** Writes the numbers of 24 bits whose upper 16 are the first column's hashes. */
    static void write(Tile tile, PacketList packets, int column) {
        float[] t = tile.values;
        for (int k = 0; k < packets.count; k++) {
            int at = packets.places[k];
            IntVector high = IntVector.fromArray(Lanes.INTS, tile.corners, at + Tile.UPPER_LEFT);
            IntVector low = IntVector.fromArray(Lanes.INTS, tile.corners, at + Tile.UPPER_RIGHT)
                    .and(255);
            Lanes.toFloats(high)
                    .mul(Noise.STEP)
                    .add(Lanes.toFloats(low).mul(Noise.STEP * Noise.STEP * 256f))
                    .intoArray(t, at + column);
        }
    }
}
