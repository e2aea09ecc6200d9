package dev.twister.engine.vector.crowd;

import dev.twister.engine.vector.frame.WideHierarchy;
import dev.twister.engine.vector.lanes.Lanes;
import dev.twister.engine.vector.lanes.SphereColumns;
import dev.twister.engine.vector.lanes.Tile;
import jdk.incubator.vector.FloatVector;
import jdk.incubator.vector.VectorMask;
import jdk.incubator.vector.VectorOperators;

/**
 * The spheres that rays meet in the leaves that {@link PacketLeaves} has found for them: first which they are, with no
 * branch on what is found where lanes can be packed, then the nearest of each ray.
 */
public final class RaySpheres {
    private static final int ROOM = 1024;

    /** What one leaf may add behind. */
    private static final int MOST_A_LEAF = (WideHierarchy.MORE_BLOCKS + 2) * Lanes.COUNT;

    /**
     * Numbers of spheres met, counted along the blocks, with the numbers of their beams above
     * {@link WideHierarchy#BEAM_SHIFT}.
     */
    private final int[] met = new int[ROOM + MOST_A_LEAF];

    /**
     * How far along the ray their centers are, and by how much the squared radius is more than the squared distance
     * from it.
     */
    private final float[] along = new float[ROOM + MOST_A_LEAF];

    private final float[] within = new float[ROOM + MOST_A_LEAF];
    private int count;

    /**
     * Writes the nearest of those met, and of equals the one with the lowest number.
     *
     * @param first the place of the beams' first pixel in {@link Tile#lonely}
     * @param links to leaves, with the numbers of their beams above
     * @param from the place of the first that is looked at
     * @param end the place behind the last
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
     * Reads a number of each cache line of the leaves' first blocks: memory is waited for once, not leaf by leaf. Of
     * lines with fewer lanes some are read twice.
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

    /** Lists those met in leaves from that one on, as many as there is room for; returns the place of the next leaf. */
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

    /** Packs those lanes of what has been written from that place on; returns the place behind the last. */
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
