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
 * Closest sphere or light per ray, through the hierarchies over spheres and over lights. A packet's coherent rays
 * traverse it as one beam. The other rays have one beam each; as many as there are lanes are traversed level by level.
 */
public final class PacketHits {
    /** Smallest cosine between the directions of coherent rays. */
    private static final float TOGETHER_COSINE = 0.98f;

    /** Fewer coherent rays than this are faster as single rays. */
    private static final int FEWEST_TOGETHER = 4;

    /** With more leaves per ray on average, single rays that start with the nearest leaf are faster. */
    private static final int MOST_LEAVES = 24;

    private PacketHits() {}

    /** Writes the bodies hit and their distances. */
    public static void find(Tile tile, Drawing drawing, TraversalMemory walks) {
        tile.lonely.clear();
        tile.together.clear();
        for (int k = 0; k < tile.live.count; k++) {
            int at = tile.live.places[k];
            int goesOn = (int) start(tile, at);
            meet(tile, at, drawing.firstLight.values, SphereColumns.FIRST, 1);
            list(tile, at, goesOn);
        }
        walk(drawing.hierarchy, tile, walks);
    }

    /** Replaces hits and distances where a light after the first is closer. */
    public static void findLights(Tile tile, Drawing drawing, TraversalMemory walks) {
        WideHierarchy lights = drawing.lightHierarchy;
        if (lights.isOneBlock()) {
            long all = Lanes.first(Math.min(Lanes.COUNT, drawing.lightCount - 1));
            for (int k = 0; k < tile.live.count; k++) {
                meet(tile, tile.live.places[k], lights.spheres.values, SphereColumns.FIRST, all);
            }
        } else {
            tile.lonely.clear();
            tile.together.clear();
            float[] t = tile.values;
            for (int k = 0; k < tile.live.count; k++) {
                int at = tile.live.places[k];
                list(tile, at, (int) Lanes.load(t, at + Tile.THROUGHPUT)
                        .compare(VectorOperators.GT, 0f)
                        .toLong());
            }
            walk(lights, tile, walks);
        }
    }

    /** Lists a packet's coherent rays and its others. */
    private static void list(Tile tile, int at, int goesOn) {
        int together = (int) gather(tile, at, goesOn);
        if (together != 0) {
            tile.together.add(at);
        }
        tile.lonely.add(at, goesOn & ~together);
    }

    private static void walk(WideHierarchy hierarchy, Tile tile, TraversalMemory walks) {
        if (tile.together.count > 0) {
            walkTogether(hierarchy, tile, walks);
        }
        for (int from = 0; from < tile.lonely.count; from += Lanes.COUNT) {
            walkAlone(hierarchy, tile, walks, from, Math.min(Lanes.COUNT, tile.lonely.count - from));
        }
    }

    private static void walkTogether(WideHierarchy hierarchy, Tile tile, TraversalMemory walks) {
        walks.beam.holdRays(tile, 0, tile.together.count);
        walks.beam.endAt(Beam.EVERYWHERE);
        if (walks.entrance.find(hierarchy, walks.beam)) {
            for (int k = 0; k < tile.together.count; k++) {
                walkTogether(hierarchy, tile, walks, k);
            }
        }
    }

    /** Traverses one packet from the tile's entrance. */
    private static void walkTogether(WideHierarchy hierarchy, Tile tile, TraversalMemory walks, int number) {
        int at = tile.together.places[number];
        Beam beam = walks.beam;
        BeamStack descent = walks.descent;
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
                    meet(tile, at, hierarchy.spheres.values, first, near);
                }
                first += hierarchy.spheres.step;
            }
            if (tested) {
                beam.endAt(farthest(tile, at));
            }
            leaf = descent.nextLeaf(hierarchy, beam);
        }
    }

    /** The distance in meters beyond which no hit matters to any coherent ray. */
    private static float farthest(Tile tile, int at) {
        return Float.intBitsToFloat((int) farthestBits(tile, at));
    }

    /** Traverses {@code count} single rays, beginning with index {@code first}. */
    private static void walkAlone(WideHierarchy hierarchy, Tile tile, TraversalMemory walks, int first, int count) {
        PacketLeaves leaves = walks.packetLeaves;
        walks.packetBeams.holdRays(tile.values, tile.lonely.pixels, first);
        boolean found = leaves.find(hierarchy, walks.packetBeams, count);
        if (found && leaves.end - leaves.first <= count * MOST_LEAVES) {
            walks.raySpheres.meet(tile, walks.packetBeams, hierarchy, first, leaves.links, leaves.first, leaves.end);
        } else {
            for (int beam = 0; beam < count; beam++) {
                descend(hierarchy, tile, walks, first, beam);
            }
        }
    }

    /** Tests one ray against the spheres of the leaves that it meets before its closest hit, nearest leaf first. */
    private static void descend(WideHierarchy hierarchy, Tile tile, TraversalMemory walks, int first, int number) {
        float[] t = tile.values;
        int pixel = tile.lonely.pixels[first + number];
        Beam beam = walks.beam;
        BeamStack descent = walks.descent;
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

    /** Resets the hits; rays that have ended get distance 0. Returns one bit per ray that continues. */
    public static long start(Tile tile, int at) {
        float[] t = tile.values;
        VectorMask<Float> goesOn =
                FloatVector.fromArray(Lanes.FLOATS, t, at + Tile.THROUGHPUT).compare(VectorOperators.GT, 0f);
        FloatVector.broadcast(Lanes.FLOATS, 0f).blend(Intersection.MISS, goesOn).intoArray(t, at + Tile.DISTANCE);
        FloatVector.broadcast(Lanes.FLOATS, Layout.NOTHING).intoArray(t, at + Tile.HIT);
        return goesOn.toLong();
    }

    /**
     * Tests some spheres of a block against all rays. It calls no helpers; see {@code ShadowConics}.
     *
     * @param wanted one bit per sphere to test
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
     * The largest closest-hit distance of the coherent rays, as float bits. No value is negative, so the bits compare
     * like the floats.
     */
    static long farthestBits(Tile tile, int at) {
        float[] t = tile.values;
        return FloatVector.fromArray(Lanes.FLOATS, t, at + Tile.DISTANCE)
                .mul(FloatVector.fromArray(Lanes.FLOATS, t, at + Tile.TOGETHER))
                .reinterpretAsInts()
                .reduceLanes(VectorOperators.MAX);
    }

    /**
     * Selects the coherent rays ({@link Tile#TOGETHER}): rays with nearly the direction of the first one. Only rays
     * that leave the ground are considered, if there are any.
     *
     * @param goesOn one bit per ray that continues
     * @return one bit per coherent ray; 0 if there are too few
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
