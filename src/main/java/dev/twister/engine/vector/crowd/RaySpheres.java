package dev.twister.engine.vector.crowd;

import dev.twister.engine.vector.frame.WideHierarchy;
import dev.twister.engine.vector.lanes.Lanes;
import dev.twister.engine.vector.lanes.SphereColumns;
import dev.twister.engine.vector.lanes.Tile;
import jdk.incubator.vector.FloatVector;
import jdk.incubator.vector.VectorMask;
import jdk.incubator.vector.VectorOperators;

/**
 * The closest sphere of each ray among the leaves that {@link PacketLeaves} has found: first a list of all spheres hit,
 * without branches where the CPU can pack lanes, then the closest per ray.
 */
public final class RaySpheres {
    private static final int ROOM = 1024;

    /** Largest number of entries that one leaf may add. */
    private static final int MOST_A_LEAF = (WideHierarchy.MORE_BLOCKS + 2) * Lanes.COUNT;

    /**
     * Numbers of the spheres hit, counted along the blocks, with the beam's number above
     * {@link WideHierarchy#BEAM_SHIFT}.
     */
    private final int[] met = new int[ROOM + MOST_A_LEAF];

    /**
     * Per sphere hit: the distance of its center along the ray, and its squared radius less the center's squared
     * distance from the ray.
     */
    private final float[] along = new float[ROOM + MOST_A_LEAF];

    private final float[] within = new float[ROOM + MOST_A_LEAF];
    private int count;

    /**
     * Writes the closest hits; on a tie the lowest body number wins.
     *
     * @param first index of the beams' first pixel in {@link Tile#lonely}
     * @param links links to leaves, with the beams' numbers
     * @param from first index in {@code links}
     * @param end index after the last one
     */
    void meet(Tile tile, PacketBeams beams, WideHierarchy hierarchy, int first, int[] links, int from, int end) {
        tile.readAhead = read(hierarchy.spheres.values, links, from, end);
        int next = from;
        while (next < end) {
            next = list(hierarchy, beams, links, next, end);
            findDistances();
            keepNearest(tile, hierarchy.spheres.values, first);
        }
    }

    /**
     * Reads each cache line of the leaves' first blocks ahead, so that their cache misses overlap. With fewer lanes
     * some lines are read twice.
     */
    private static float read(float[] spheres, int[] links, int from, int end) {
        float even = 0f;
        float odd = 0f;
        for (int k = from; k < end; k++) {
            int at = WideHierarchy.firstBlock(links[k]);
            even += spheres[at] + spheres[at + SphereColumns.Z * Lanes.COUNT];
            odd += spheres[at + SphereColumns.Y * Lanes.COUNT] + spheres[at + SphereColumns.RADIUS * Lanes.COUNT];
        }
        return even + odd;
    }

    /** Lists the spheres hit in the leaves from {@code from} on while there is room; returns the next leaf's index. */
    private int list(WideHierarchy hierarchy, PacketBeams beams, int[] links, int from, int end) {
        float[] spheres = hierarchy.spheres.values;
        float[] f = beams.facts;
        int next = from;
        int tail = 0;
        while (next < end && tail <= ROOM) {
            int link = links[next];
            int beam = link >>> WideHierarchy.BEAM_SHIFT;
            int at = WideHierarchy.firstBlock(link);
            int number = beam << WideHierarchy.BEAM_SHIFT | WideHierarchy.block(link) * Lanes.COUNT;
            next++;
            for (int left = WideHierarchy.blocks(link); left > 0; left--) {
                float directionX = f[PacketBeams.DIRECTION + beam];
                float directionY = f[PacketBeams.DIRECTION + Lanes.COUNT + beam];
                float directionZ = f[PacketBeams.DIRECTION + 2 * Lanes.COUNT + beam];
                FloatVector x = FloatVector.fromArray(Lanes.FLOATS, spheres, at).sub(f[PacketBeams.ORIGIN + beam]);
                FloatVector y = FloatVector.fromArray(Lanes.FLOATS, spheres, at + SphereColumns.Y * Lanes.COUNT)
                        .sub(f[PacketBeams.ORIGIN + Lanes.COUNT + beam]);
                FloatVector z = FloatVector.fromArray(Lanes.FLOATS, spheres, at + SphereColumns.Z * Lanes.COUNT)
                        .sub(f[PacketBeams.ORIGIN + 2 * Lanes.COUNT + beam]);
                FloatVector radius =
                        FloatVector.fromArray(Lanes.FLOATS, spheres, at + SphereColumns.RADIUS * Lanes.COUNT);
                FloatVector toFoot = x.mul(directionX).add(y.mul(directionY)).add(z.mul(directionZ));
                FloatVector acrossX = x.sub(toFoot.mul(directionX));
                FloatVector acrossY = y.sub(toFoot.mul(directionY));
                FloatVector acrossZ = z.sub(toFoot.mul(directionZ));
                FloatVector inside = radius.mul(radius)
                        .sub(acrossX.mul(acrossX).add(acrossY.mul(acrossY)).add(acrossZ.mul(acrossZ)));
                VectorMask<Float> hit =
                        toFoot.compare(VectorOperators.GT, 0f).and(inside.compare(VectorOperators.GE, 0f));
                if (Lanes.PACK) {
                    Lanes.numbers().or(number).compress(hit.cast(Lanes.INTS)).intoArray(met, tail);
                    toFoot.compress(hit).intoArray(along, tail);
                    inside.compress(hit).intoArray(within, tail);
                    tail += hit.trueCount();
                } else {
                    long lanes = hit.toLong();
                    if (lanes != 0L) {
                        toFoot.intoArray(along, tail);
                        inside.intoArray(within, tail);
                        tail = keep(lanes, number, tail);
                    }
                }
                at += SphereColumns.COLUMNS * Lanes.COUNT;
                number += Lanes.COUNT;
            }
        }
        count = tail;
        return next;
    }

    /** Packs the given lanes of the values written at {@code at}; returns the place after the last. */
    private int keep(long lanes, int number, int at) {
        int to = at;
        for (long rest = lanes; rest != 0L; rest &= rest - 1) {
            int lane = Long.numberOfTrailingZeros(rest);
            met[to] = number | lane;
            along[to] = along[at + lane];
            within[to] = within[at + lane];
            to++;
        }
        return to;
    }

    private void findDistances() {
        for (int k = 0; k < count; k += Lanes.COUNT) {
            FloatVector.fromArray(Lanes.FLOATS, along, k)
                    .sub(FloatVector.fromArray(Lanes.FLOATS, within, k).sqrt())
                    .intoArray(along, k);
        }
    }

    private void keepNearest(Tile tile, float[] spheres, int first) {
        float[] t = tile.values;
        int[] pixels = tile.lonely.pixels;
        for (int k = 0; k < count; k++) {
            int pixel = pixels[first + (met[k] >>> WideHierarchy.BEAM_SHIFT)];
            float distance = along[k];
            float body = spheres[SphereColumns.bodyPlace(met[k] & WideHierarchy.SPHERE)];
            float closest = t[pixel + Tile.DISTANCE];
            boolean closer = distance < closest || (distance == closest && body < t[pixel + Tile.HIT]);
            if (closer && distance > 0f && body != t[pixel + Tile.LEAVING]) {
                t[pixel + Tile.DISTANCE] = distance;
                t[pixel + Tile.HIT] = body;
            }
        }
    }
}
