package dev.twister.engine.vector.mesh;

import dev.twister.engine.vector.frame.Drawing;
import dev.twister.engine.vector.lanes.Lanes;
import dev.twister.engine.vector.lanes.Tile;
import dev.twister.kernel.Coincidence;
import dev.twister.kernel.Instance;
import dev.twister.kernel.Layout;
import dev.twister.world.Bodies;
import jdk.incubator.vector.FloatVector;
import jdk.incubator.vector.VectorOperators;

/** Closest triangles of the rays, packet by packet: {@code MeshHit} of the kernel. */
public final class MeshHits {
    private MeshHits() {}

    /** Replaces hits and distances of the live rays where a mesh is closer, and writes instances and triangles. */
    public static void find(Drawing drawing, Tile tile, MeshMemory bench) {
        for (int k = 0; k < tile.live.count; k++) {
            find(drawing, tile, bench, tile.live.places[k]);
        }
    }

    private static void find(Drawing drawing, Tile tile, MeshMemory bench, int at) {
        Bodies bodies = drawing.input.bodies();
        float[] hierarchy = bodies.floats();
        PacketWalk world = bench.world;
        world.start(hierarchy, bodies.instances() + 1);
        int first = (int) start(tile, world, at);
        if (first >= 0) {
            world.follow(first);
            BoxLanes.aim(tile, world);
            InstanceLanes.shear(tile, world);
            int leaf = BoxLanes.nextLeaf(tile, world);
            while (leaf != Layout.NO_NODE) {
                if (hierarchy[leaf + Layout.NODE_SPHERES] == 0f) {
                    meetInstance(drawing, tile, bench, at, (int) hierarchy[leaf + Layout.NODE_LINK]);
                } else {
                    meetSmall(drawing, tile, bench, at, openSmall(tile, world, leaf));
                }
                leaf = BoxLanes.nextLeaf(tile, world);
            }
        }
    }

    /** Prepares the rays in the world for a leaf with a small mesh; returns the number of its instance. */
    static int openSmall(Tile tile, PacketWalk world, int leaf) {
        int small = world.openSmall(leaf);
        InstanceLanes.reach(tile, world, world.boxes[small + Layout.SMALL_REACH]);
        return (int) world.boxes[small + Layout.SMALL_INSTANCE];
    }

    /** Copies the packet's rays to a traversal; returns the first live lane, or a negative number if there is none. */
    public static long start(Tile tile, PacketWalk walk, int at) {
        float[] t = tile.values;
        float[] r = walk.rays;
        for (int axis = 0; axis < 3; axis++) {
            FloatVector.fromArray(Lanes.FLOATS, t, at + Tile.ORIGIN_X + axis * Tile.SIZE)
                    .intoArray(r, PacketWalk.ORIGIN + axis * Lanes.COUNT);
            FloatVector.fromArray(Lanes.FLOATS, t, at + Tile.DIRECTION_X + axis * Tile.SIZE)
                    .intoArray(r, PacketWalk.DIRECTION + axis * Lanes.COUNT);
        }
        var goesOn =
                FloatVector.fromArray(Lanes.FLOATS, t, at + Tile.THROUGHPUT).compare(VectorOperators.GT, 0f);
        FloatVector.broadcast(Lanes.FLOATS, -1f)
                .blend(FloatVector.fromArray(Lanes.FLOATS, t, at + Tile.DISTANCE), goesOn)
                .intoArray(r, PacketWalk.END);
        long lanes = goesOn.toLong();
        return lanes == 0L ? -1 : Long.numberOfTrailingZeros(lanes);
    }

    private static void meetSmall(Drawing drawing, Tile tile, MeshMemory bench, int at, int number) {
        Bodies bodies = drawing.input.bodies();
        int instance = Instance.at(number, bodies.instances(), bodies.floats());
        int body = (int) bodies.floats()[instance + Layout.INSTANCE_BODY];
        leave(drawing, tile, bench.world, at, body);
        meet(drawing, tile, bench, bench.world, at, number, body);
    }

    private static void meetInstance(Drawing drawing, Tile tile, MeshMemory bench, int at, int number) {
        PacketWalk mesh = bench.mesh;
        Bodies bodies = drawing.input.bodies();
        int instance = Instance.at(number, bodies.instances(), bodies.floats());
        int body = (int) bodies.floats()[instance + Layout.INSTANCE_BODY];
        enter(bodies, tile, bench, instance);
        leave(drawing, tile, mesh, at, body);
        int leaf = BoxLanes.nextLeaf(tile, mesh);
        while (leaf != Layout.NO_NODE) {
            mesh.open(leaf);
            meet(drawing, tile, bench, mesh, at, number, body);
            leaf = BoxLanes.nextLeaf(tile, mesh);
        }
        System.arraycopy(mesh.rays, PacketWalk.END, bench.world.rays, PacketWalk.END, Lanes.COUNT);
    }

    /** Writes what the rays ignore of a body, and what they touch. */
    private static void leave(Drawing drawing, Tile tile, PacketWalk walk, int at, int body) {
        InstanceLanes.ignore(tile, walk, at, Tile.LEAVING, Tile.LEAVING_TRIANGLE, body);
        if (drawing.looks.transparent) {
            InstanceLanes.touch(tile, walk, at, body);
        }
    }

    /** Tests the triangles of a walk's leaf, which are those of an instance. */
    private static void meet(
            Drawing drawing, Tile tile, MeshMemory bench, PacketWalk walk, int at, int number, int body) {
        int end = walk.end;
        for (int rest = walk.axes; rest != 0; rest &= rest - 1) {
            int axis = Integer.numberOfTrailingZeros(rest);
            int triangle = TriangleLanes.next(tile, walk, walk.triangles, walk.from, end, axis);
            while (triangle < end) {
                long close = TriangleLanes.keepNearest(tile, walk, at, axis, walk.triangles, triangle, number, body);
                if (close != 0L) {
                    CoincidentHits.decide(drawing, tile, bench, walk, at, close, triangle, number);
                }
                triangle = TriangleLanes.next(tile, walk, walk.triangles, triangle + 1, end, axis);
            }
        }
    }

    /** Starts the traversal of an instance's triangles. */
    static void enter(Bodies bodies, Tile tile, MeshMemory bench, int instance) {
        float[] hierarchy = bodies.floats();
        PacketWalk mesh = bench.mesh;
        mesh.start(bodies.meshes(), Instance.nodes(hierarchy, instance));
        InstanceLanes.transform(tile, bench.world, mesh, hierarchy, instance + Layout.INSTANCE_TO_MESH);
        mesh.triangles = Instance.triangles(hierarchy, instance);
        BoxLanes.aim(tile, mesh);
        InstanceLanes.shear(tile, mesh);
    }

    /** Decides lane by lane between hits that may be in one place: {@link Coincidence}. */
    private static final class CoincidentHits {
        private CoincidentHits() {}

        /**
         * Writes the triangle as the hit of those rays for which it replaces the closest one so far.
         *
         * @param close one bit per ray, with its distance to the triangle in {@link PacketWalk#MET}
         * @param number the triangle's instance
         */
        static void decide(
                Drawing drawing,
                Tile tile,
                MeshMemory bench,
                PacketWalk walk,
                int at,
                long close,
                int triangle,
                int number) {
            Bodies bodies = drawing.input.bodies();
            float[] frame = drawing.input.view().frame();
            float[] hierarchy = bodies.floats();
            float[] t = tile.values;
            float[] r = walk.rays;
            float[] path = bench.path;
            int instance = Instance.at(number, bodies.instances(), hierarchy);
            for (long rest = close; rest != 0L; rest &= rest - 1) {
                int lane = Long.numberOfTrailingZeros(rest);
                int pixel = at + lane;
                float met = r[PacketWalk.MET + lane];
                path[Layout.INSTANCE] = t[pixel + Tile.INSTANCE];
                path[Layout.TRIANGLE] = t[pixel + Tile.TRIANGLE];
                int hit = (int) t[pixel + Tile.HIT];
                float end = r[PacketWalk.END + lane];
                if (Coincidence.replaces(path, hit, end, met, number, triangle, frame, hierarchy, bodies.meshes())
                        != 0) {
                    r[PacketWalk.END + lane] = met;
                    t[pixel + Tile.DISTANCE] = met;
                    t[pixel + Tile.HIT] = hierarchy[instance + Layout.INSTANCE_BODY];
                    t[pixel + Tile.INSTANCE] = number;
                    t[pixel + Tile.TRIANGLE] = triangle;
                }
            }
        }
    }
}
