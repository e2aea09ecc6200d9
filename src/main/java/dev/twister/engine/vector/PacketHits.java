package dev.twister.engine.vector;

import dev.twister.kernel.Intersection;
import dev.twister.kernel.Layout;
import jdk.incubator.vector.FloatVector;
import jdk.incubator.vector.VectorMask;
import jdk.incubator.vector.VectorOperators;

/**
 * Which sphere, or the light, each ray meets first, by way of the hierarchy: packets whose rays keep together walk it as
 * one, the rays of the others one by one.
 */
final class PacketHits {
    /** Rays within 0.2 radians of their mean keep together. */
    private static final float TOGETHER_COSINE = 0.98f;

    private PacketHits() {}

    /** Writes the bodies met and their distances. */
    static void find(Tile tile, Drawing drawing) {
        Hull hull = tile.packetHull;
        for (int k = 0; k < tile.live.count; k++) {
            int at = tile.live.places[k];
            tile.packet.clear();
            tile.packet.add(at);
            LaneSteps.run(LaneSteps.START_PACKET, tile, drawing, hull, at, 0);
            LaneSteps.run(LaneSteps.HOLD_RAYS, tile, drawing, hull, at, 0);
            if (hull.cosine > TOGETHER_COSINE) {
                LaneSteps.run(LaneSteps.HOLD_ORIGINS, tile, drawing, hull, at, 0);
                walkTogether(tile, drawing, at);
            } else {
                walkAlone(tile, drawing, at);
            }
        }
    }

    private static void walkTogether(Tile tile, Drawing drawing, int at) {
        Hull hull = tile.packetHull;
        Descent descent = tile.descent;
        WideHierarchy hierarchy = drawing.hierarchy;
        hull.prepareForBoxes();
        hull.end = limit(tile, drawing, at);
        descent.start(tile, drawing, hull);
        int leaf = descent.nextLeaf(tile, drawing, hull, hull.end);
        while (leaf >= 0) {
            int sphere = hierarchy.links[leaf];
            int end = sphere + hierarchy.spheres[leaf];
            boolean tested = false;
            while (sphere < end) {
                long near = LaneSteps.run(LaneSteps.TOUCH_SPHERES, tile, drawing, hull, at, sphere)
                        & (1L << Math.min(Lanes.COUNT, end - sphere)) - 1;
                tested |= near != 0L;
                while (near != 0L) {
                    int item = sphere + Long.numberOfTrailingZeros(near);
                    LaneSteps.run(LaneSteps.MEET_SPHERE, tile, drawing, hull, at, item);
                    near &= near - 1;
                }
                sphere += Lanes.COUNT;
            }
            if (tested) {
                hull.end = limit(tile, drawing, at);
            }
            leaf = descent.nextLeaf(tile, drawing, hull, hull.end);
        }
    }

    /** Metres along the hull's axis beyond which nothing matters to any ray. */
    private static float limit(Tile tile, Drawing drawing, int at) {
        Hull hull = tile.packetHull;
        return Float.intBitsToFloat((int) LaneSteps.run(LaneSteps.FARTHEST, tile, drawing, hull, at, 0)) + hull.radius;
    }

    private static void walkAlone(Tile tile, Drawing drawing, int at) {
        for (int pixel = at; pixel < at + Lanes.COUNT; pixel++) {
            if (tile.values[pixel + Tile.THROUGHPUT] > 0f) {
                walkRay(tile, drawing, pixel);
            }
        }
    }

    private static void walkRay(Tile tile, Drawing drawing, int pixel) {
        float[] t = tile.values;
        Hull hull = tile.packetHull;
        Descent descent = tile.descent;
        WideHierarchy hierarchy = drawing.hierarchy;
        hull.holdRay(t, pixel);
        hull.prepareForBoxes();
        hull.end = t[pixel + Tile.DISTANCE];
        descent.start(tile, drawing, hull);
        int leaf = descent.nextLeaf(tile, drawing, hull, hull.end);
        while (leaf >= 0) {
            int sphere = hierarchy.links[leaf];
            int end = sphere + hierarchy.spheres[leaf];
            while (sphere < end) {
                long near = LaneSteps.run(LaneSteps.MEET_SPHERES, tile, drawing, hull, pixel, sphere)
                        & (1L << Math.min(Lanes.COUNT, end - sphere)) - 1;
                while (near != 0L) {
                    int lane = Long.numberOfTrailingZeros(near);
                    near &= near - 1;
                    take(t, pixel, hierarchy.bodies[sphere + lane], descent.childEntries[lane]);
                }
                sphere += Lanes.COUNT;
            }
            hull.end = t[pixel + Tile.DISTANCE];
            leaf = descent.nextLeaf(tile, drawing, hull, hull.end);
        }
    }

    private static void take(float[] t, int pixel, int body, float distance) {
        float closest = t[pixel + Tile.DISTANCE];
        boolean closer = distance < closest || (distance == closest && body < t[pixel + Tile.HIT]);
        if (closer && body != t[pixel + Tile.LEAVING]) {
            t[pixel + Tile.DISTANCE] = distance;
            t[pixel + Tile.HIT] = body;
        }
    }

    /** The light where it is met; rays that have ended meet nothing any more. */
    static void start(float[] t, int at, BodyColumns bodies) {
        VectorMask<Float> goesOn = Lanes.load(t, at + Tile.THROUGHPUT).compare(VectorOperators.GT, 0f);
        FloatVector closest = Lanes.all(0f).blend(Intersection.MISS, goesOn);
        FloatVector near = NearestSphere.near(
                t,
                at,
                bodies.x[Layout.LIGHT],
                bodies.y[Layout.LIGHT],
                bodies.z[Layout.LIGHT],
                bodies.radius[Layout.LIGHT]);
        VectorMask<Float> met = near.compare(VectorOperators.GT, 0f).and(near.compare(VectorOperators.LT, closest));
        closest.blend(near, met).intoArray(t, at + Tile.DISTANCE);
        Lanes.all(Layout.NOTHING).blend(Layout.LIGHT, met).intoArray(t, at + Tile.HIT);
    }

    /** One sphere and all rays. */
    static void meet(float[] t, int at, WideHierarchy hierarchy, int sphere) {
        int body = hierarchy.bodies[sphere];
        FloatVector near = NearestSphere.near(
                t, at, hierarchy.x[sphere], hierarchy.y[sphere], hierarchy.z[sphere], hierarchy.radius[sphere]);
        FloatVector closest = Lanes.load(t, at + Tile.DISTANCE);
        FloatVector hit = Lanes.load(t, at + Tile.HIT);
        VectorMask<Float> closer = near.compare(VectorOperators.EQ, closest)
                .and(hit.compare(VectorOperators.GT, body))
                .or(near.compare(VectorOperators.LT, closest))
                .and(near.compare(VectorOperators.GT, 0f))
                .and(Lanes.load(t, at + Tile.LEAVING).compare(VectorOperators.NE, body));
        closest.blend(near, closer).intoArray(t, at + Tile.DISTANCE);
        hit.blend(body, closer).intoArray(t, at + Tile.HIT);
    }

    /** The bits, as a float, of the farthest of the packet's closest hits. */
    static long farthest(float[] t, int at) {
        return Float.floatToIntBits(Lanes.load(t, at + Tile.DISTANCE).reduceLanes(VectorOperators.MAX));
    }

    /** One ray and the spheres from {@code first} on: one bit each that is met, and writes the distances. */
    static long near(float[] t, int pixel, WideHierarchy hierarchy, int first, float[] distances) {
        float directionX = t[pixel + Tile.DIRECTION_X];
        float directionY = t[pixel + Tile.DIRECTION_Y];
        float directionZ = t[pixel + Tile.DIRECTION_Z];
        FloatVector x = Lanes.load(hierarchy.x, first).sub(t[pixel + Tile.ORIGIN_X]);
        FloatVector y = Lanes.load(hierarchy.y, first).sub(t[pixel + Tile.ORIGIN_Y]);
        FloatVector z = Lanes.load(hierarchy.z, first).sub(t[pixel + Tile.ORIGIN_Z]);
        FloatVector along = x.fma(Lanes.all(directionX), y.fma(Lanes.all(directionY), z.mul(directionZ)));
        FloatVector acrossX = x.sub(along.mul(directionX));
        FloatVector acrossY = y.sub(along.mul(directionY));
        FloatVector acrossZ = z.sub(along.mul(directionZ));
        FloatVector acrossSquared = acrossX.fma(acrossX, acrossY.fma(acrossY, acrossZ.mul(acrossZ)));
        FloatVector radius = Lanes.load(hierarchy.radius, first);
        FloatVector near = along.sub(radius.mul(radius).sub(acrossSquared).sqrt());
        near.intoArray(distances, 0);
        return near.compare(VectorOperators.GT, 0f)
                .and(near.compare(VectorOperators.LE, t[pixel + Tile.DISTANCE]))
                .toLong();
    }
}
