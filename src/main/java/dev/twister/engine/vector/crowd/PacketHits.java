package dev.twister.engine.vector.crowd;

import dev.twister.engine.vector.frame.Drawing;
import dev.twister.engine.vector.frame.WideHierarchy;
import dev.twister.engine.vector.lanes.Lanes;
import dev.twister.engine.vector.lanes.SphereColumns;
import dev.twister.engine.vector.lanes.Tile;
import dev.twister.kernel.Intersection;
import dev.twister.kernel.Layout;
import jdk.incubator.vector.FloatVector;
import jdk.incubator.vector.VectorMask;
import jdk.incubator.vector.VectorOperators;

/**
 * Which sphere, or the light, each ray meets first, by way of the hierarchy: a packet's rays that keep together walk it
 * as one; each of the others has a way of its own, as many as there are lanes of them level by level.
 */
public final class PacketHits {
    /** Where the directions' cosines about one of them are less, rays do not keep together. */
    private static final float TOGETHER_COSINE = 0.98f;

    /** Fewer rays than these are better off alone. */
    private static final int FEWEST_TOGETHER = 4;

    /** Where rays meet more leaves at the mean, they are better off with those in front alone. */
    private static final int MOST_LEAVES = 24;

    private PacketHits() {}

    /** Writes the bodies met and their distances. */
    public static void find(Tile tile, Drawing drawing, Walks walks) {
        tile.lonely.clear();
        tile.together.clear();
        for (int k = 0; k < tile.live.count; k++) {
            int at = tile.live.places[k];
            int goesOn = (int) start(tile, at);
            meet(tile, at, drawing.light.values, SphereColumns.FIRST, 1);
            int together = (int) gather(tile, at, goesOn);
            if (together != 0) {
                tile.together.add(at);
            }
            tile.lonely.add(at, goesOn & ~together);
        }
        if (tile.together.count > 0) {
            walkTogether(drawing, tile, walks);
        }
        for (int from = 0; from < tile.lonely.count; from += Lanes.COUNT) {
            walkAlone(drawing, tile, walks, from, Math.min(Lanes.COUNT, tile.lonely.count - from));
        }
    }

    private static void walkTogether(Drawing drawing, Tile tile, Walks walks) {
        walks.beam.holdRays(tile, 0, tile.together.count);
        walks.beam.endAt(Beam.EVERYWHERE);
        if (walks.entrance.find(drawing.hierarchy, walks.beam)) {
            for (int k = 0; k < tile.together.count; k++) {
                walkTogether(drawing, tile, walks, k);
            }
        }
    }

    /** One packet, from where all begin. */
    private static void walkTogether(Drawing drawing, Tile tile, Walks walks, int number) {
        int at = tile.together.places[number];
        Beam beam = walks.beam;
        Descent descent = walks.descent;
        WideHierarchy hierarchy = drawing.hierarchy;
        beam.holdRays(tile, number, number + 1);
        beam.endAt(farthest(tile, at));
        descent.start(walks.entrance, beam);
        int leaf = descent.nextLeaf(hierarchy, beam);
        while (leaf >= 0) {
            boolean tested = false;
            int first = WideHierarchy.firstBlock(leaf);
            for (int left = WideHierarchy.blocks(leaf); left > 0; left--) {
                long near = beam.meeting(hierarchy.spheres, first);
                tested |= near != 0L;
                if (near != 0L) {
                    meet(tile, at, drawing.hierarchy.spheres.values, first, near);
                }
                first += hierarchy.spheres.step;
            }
            if (tested) {
                beam.endAt(farthest(tile, at));
            }
            leaf = descent.nextLeaf(hierarchy, beam);
        }
    }

    /** Meters along the rays beyond which nothing matters to any of them. */
    private static float farthest(Tile tile, int at) {
        return Float.intBitsToFloat((int) farthestBits(tile, at));
    }

    /** So many of the rays on their own, from that one of them on. */
    private static void walkAlone(Drawing drawing, Tile tile, Walks walks, int first, int count) {
        PacketLeaves leaves = walks.packetLeaves;
        walks.packetBeams.holdRays(tile.values, tile.lonely.pixels, first);
        boolean found = leaves.find(drawing.hierarchy, walks.packetBeams, count);
        if (found && leaves.end - leaves.first <= count * MOST_LEAVES) {
            walks.raySpheres.meet(
                    tile, walks.packetBeams, drawing.hierarchy, first, leaves.links, leaves.first, leaves.end);
        } else {
            for (int beam = 0; beam < count; beam++) {
                descend(drawing, tile, walks, first, beam);
            }
        }
    }

    /** One ray and the spheres of the leaves that it meets before a hit, the nearest first. */
    private static void descend(Drawing drawing, Tile tile, Walks walks, int first, int number) {
        float[] t = tile.values;
        int pixel = tile.lonely.pixels[first + number];
        Beam beam = walks.beam;
        Descent descent = walks.descent;
        WideHierarchy hierarchy = drawing.hierarchy;
        beam.holdRay(t, pixel);
        beam.endAt(t[pixel + Tile.DISTANCE]);
        descent.start(hierarchy, beam);
        int leaf = descent.nextLeaf(hierarchy, beam);
        while (leaf >= 0) {
            walks.leafMet[0] = number << WideHierarchy.BEAM_SHIFT | leaf;
            walks.raySpheres.meet(tile, walks.packetBeams, hierarchy, first, walks.leafMet, 0, 1);
            beam.endAt(t[pixel + Tile.DISTANCE]);
            leaf = descent.nextLeaf(hierarchy, beam);
        }
    }

    /** No hit yet; rays that have ended meet nothing any more. Returns one bit a ray that goes on. */
    static long start(Tile tile, int at) {
        float[] t = tile.values;
        VectorMask<Float> goesOn =
                FloatVector.fromArray(Lanes.FLOATS, t, at + Tile.THROUGHPUT).compare(VectorOperators.GT, 0f);
        FloatVector.broadcast(Lanes.FLOATS, 0f).blend(Intersection.MISS, goesOn).intoArray(t, at + Tile.DISTANCE);
        FloatVector.broadcast(Lanes.FLOATS, Layout.NOTHING).intoArray(t, at + Tile.HIT);
        return goesOn.toLong();
    }

    /**
     * Some spheres of a block and all rays. It calls no helper, for the reason that {@code ShadowConics} has.
     *
     * @param wanted one bit a sphere
     */
    static void meet(Tile tile, int at, float[] spheres, int first, long wanted) {
        float[] t = tile.values;
        FloatVector directionX = FloatVector.fromArray(Lanes.FLOATS, t, at + Tile.DIRECTION_X);
        FloatVector directionY = FloatVector.fromArray(Lanes.FLOATS, t, at + Tile.DIRECTION_Y);
        FloatVector directionZ = FloatVector.fromArray(Lanes.FLOATS, t, at + Tile.DIRECTION_Z);
        FloatVector originX = FloatVector.fromArray(Lanes.FLOATS, t, at + Tile.ORIGIN_X);
        FloatVector originY = FloatVector.fromArray(Lanes.FLOATS, t, at + Tile.ORIGIN_Y);
        FloatVector originZ = FloatVector.fromArray(Lanes.FLOATS, t, at + Tile.ORIGIN_Z);
        FloatVector leaving = FloatVector.fromArray(Lanes.FLOATS, t, at + Tile.LEAVING);
        FloatVector closest = FloatVector.fromArray(Lanes.FLOATS, t, at + Tile.DISTANCE);
        FloatVector hit = FloatVector.fromArray(Lanes.FLOATS, t, at + Tile.HIT);
        for (long rest = wanted; rest != 0L; rest &= rest - 1) {
            int sphere = first + Long.numberOfTrailingZeros(rest);
            float radius = spheres[sphere + SphereColumns.RADIUS * Lanes.COUNT];
            float body = spheres[sphere + SphereColumns.BODY * Lanes.COUNT];
            FloatVector x = FloatVector.broadcast(Lanes.FLOATS, spheres[sphere]).sub(originX);
            FloatVector y = FloatVector.broadcast(Lanes.FLOATS, spheres[sphere + SphereColumns.Y * Lanes.COUNT])
                    .sub(originY);
            FloatVector z = FloatVector.broadcast(Lanes.FLOATS, spheres[sphere + SphereColumns.Z * Lanes.COUNT])
                    .sub(originZ);
            FloatVector along = x.mul(directionX).add(y.mul(directionY)).add(z.mul(directionZ));
            FloatVector acrossX = x.sub(along.mul(directionX));
            FloatVector acrossY = y.sub(along.mul(directionY));
            FloatVector acrossZ = z.sub(along.mul(directionZ));
            FloatVector across = acrossX.mul(acrossX).add(acrossY.mul(acrossY)).add(acrossZ.mul(acrossZ));
            FloatVector near = along.sub(FloatVector.broadcast(Lanes.FLOATS, radius * radius)
                    .sub(across)
                    .sqrt());
            VectorMask<Float> closer = near.compare(VectorOperators.EQ, closest)
                    .and(hit.compare(VectorOperators.GT, body))
                    .or(near.compare(VectorOperators.LT, closest))
                    .and(near.compare(VectorOperators.GT, 0f))
                    .and(leaving.compare(VectorOperators.NE, body));
            closest = closest.blend(near, closer);
            hit = hit.blend(body, closer);
        }
        closest.intoArray(t, at + Tile.DISTANCE);
        hit.intoArray(t, at + Tile.HIT);
    }

    /**
     * The bits, as a float, of the farthest of the closest hits of those that keep together; none is below 0, so that
     * they are in the floats' order.
     */
    static long farthestBits(Tile tile, int at) {
        float[] t = tile.values;
        return FloatVector.fromArray(Lanes.FLOATS, t, at + Tile.DISTANCE)
                .mul(FloatVector.fromArray(Lanes.FLOATS, t, at + Tile.TOGETHER))
                .reinterpretAsInts()
                .reduceLanes(VectorOperators.MAX);
    }

    /**
     * Chooses the rays that keep {@link Tile#TOGETHER}: of those that leave the ground, or if none does of all, those
     * with nearly the direction of the first, where they are many enough.
     *
     * @param goesOn one bit a ray that goes on
     * @return one bit a ray that keeps together
     */
    static long gather(Tile tile, int at, long goesOn) {
        float[] t = tile.values;
        long ground = goesOn
                & FloatVector.fromArray(Lanes.FLOATS, t, at + Tile.LEAVING)
                        .compare(VectorOperators.EQ, Layout.PLANE)
                        .toLong();
        long kind = ground != 0L ? ground : goesOn;
        int first = at + Long.numberOfTrailingZeros(kind);
        long together = kind
                & FloatVector.fromArray(Lanes.FLOATS, t, at + Tile.DIRECTION_X)
                        .mul(t[first + Tile.DIRECTION_X])
                        .add(FloatVector.fromArray(Lanes.FLOATS, t, at + Tile.DIRECTION_Y)
                                .mul(t[first + Tile.DIRECTION_Y]))
                        .add(FloatVector.fromArray(Lanes.FLOATS, t, at + Tile.DIRECTION_Z)
                                .mul(t[first + Tile.DIRECTION_Z]))
                        .compare(VectorOperators.GT, TOGETHER_COSINE)
                        .toLong();
        if (together != goesOn && Long.bitCount(together) < FEWEST_TOGETHER) {
            together = 0L;
        }
        FloatVector.broadcast(Lanes.FLOATS, 0f)
                .blend(1f, VectorMask.fromLong(Lanes.FLOATS, together))
                .intoArray(t, at + Tile.TOGETHER);
        return together;
    }
}
