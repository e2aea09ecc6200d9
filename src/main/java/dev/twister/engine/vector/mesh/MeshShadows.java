package dev.twister.engine.vector.mesh;

import dev.twister.engine.vector.frame.Drawing;
import dev.twister.engine.vector.frame.MeshColumns;
import dev.twister.engine.vector.lanes.Lanes;
import dev.twister.engine.vector.lanes.ShadowColumns;
import dev.twister.engine.vector.lanes.Tile;
import dev.twister.engine.vector.shadow.ShadowCandidates;
import dev.twister.kernel.Instance;
import dev.twister.kernel.Layout;
import dev.twister.world.Bodies;
import java.util.Arrays;

/** Light samples that meshes block from the points of a tile, packet by packet: {@code MeshShadow} of the kernel. */
public final class MeshShadows {
    /** With more meshes, the test of all bounding spheres is skipped. */
    private static final int MOST_MESHES = 256;

    /** With fewer samples, each walks the hierarchies on its own. */
    private static final int FEWEST_IN_CONES = 3;

    private MeshShadows() {}

    /**
     * Sets the visible part to 0 where meshes block all samples. Where they block some, or a part of some, writes the
     * sum of these parts and lists the packet. Packets without open lanes are removed from {@link Tile#shadows}.
     */
    public static void find(Drawing drawing, Tile tile, MeshMemory bench) {
        tile.meshShadows.clear();
        ShadowCandidates.findDiscs(tile, drawing);
        int kept = 0;
        for (int k = 0; k < tile.shadows.count; k++) {
            int at = tile.shadows.places[k];
            long open = ShadowCandidates.open(tile, at);
            if (open != 0L && mayBlock(drawing, tile, at, open)) {
                open = find(drawing, tile, bench, at, open);
            }
            if (open != 0L) {
                tile.shadows.places[kept] = at;
                kept++;
            }
        }
        tile.shadows.count = kept;
    }

    /** Whether any mesh's bounding sphere lies between the packet's open points and the light's disc. */
    private static boolean mayBlock(Drawing drawing, Tile tile, int at, long open) {
        MeshColumns meshes = drawing.bodies.meshes;
        boolean may = meshes.count > MOST_MESHES;
        for (int mesh = 0; mesh < meshes.count && !may; mesh++) {
            may = (open & ShadowCandidates.between(tile.values, at, drawing.bodies, meshes.firstBody + mesh)) != 0L;
        }
        return may;
    }

    /** Tests the samples of one packet; returns one bit per lane that is still open. */
    private static long find(Drawing drawing, Tile tile, MeshMemory bench, int at, long open) {
        int samples = drawing.shadowSamples;
        ShadowLines.findAxes(tile, at, drawing, bench);
        boolean listed = samples >= FEWEST_IN_CONES && bench.listed.find(drawing, tile, at, bench, open);
        long dark = 0L;
        if (!listed || bench.listed.instanceCount > 0) {
            long dimmed = open & (listed ? project(drawing, tile, bench, at) : walk(drawing, tile, bench, at, open));
            dark = dimmed & ShadowLines.hidden(tile, bench, samples);
            long part = dimmed & ~dark;
            if (part != 0L) {
                tile.meshShadows.add(at);
            }
            ShadowLines.finish(tile, at, bench, dark, part);
        }
        return open & ~dark;
    }

    /** Sums up what the listed triangles block; returns one bit per lane with any. */
    private static long project(Drawing drawing, Tile tile, MeshMemory bench, int at) {
        Bodies bodies = drawing.input.bodies();
        ConeTriangles listed = bench.listed;
        int samples = drawing.shadowSamples;
        bench.disc.start(samples);
        int first = 0;
        for (int k = 0; k < listed.instanceCount; k++) {
            int instance = listed.instances[k];
            int body = (int) bodies.floats()[instance + Layout.INSTANCE_BODY];
            if (project(drawing, tile, bench, at, instance, first, listed.ends[k])) {
                float transmission = drawing.looks.transmits(body) ? drawing.looks.transmission(body) : 0f;
                DiscLanes.dim(tile, bench.disc, transmission, samples);
            }
            first = listed.ends[k];
        }
        return DiscLanes.count(tile, bench.disc, bench.blocked, samples);
    }

    /** Marks the samples that triangles of an instance block; returns whether there may be any. */
    private static boolean project(
            Drawing drawing, Tile tile, MeshMemory bench, int at, int instance, int first, int end) {
        Bodies bodies = drawing.input.bodies();
        float[] hierarchy = bodies.floats();
        PacketWalk mesh = bench.mesh;
        DiscColumns disc = bench.disc;
        ShadowColumns columns = bench.shadows.columns;
        mesh.start(bodies.meshes(), Instance.nodes(hierarchy, instance));
        InstanceLanes.transform(tile, bench.world, mesh, hierarchy, instance + Layout.INSTANCE_TO_MESH);
        InstanceLanes.ignore(tile, mesh, at, Tile.HIT, Tile.TRIANGLE, (int) hierarchy[instance + Layout.INSTANCE_BODY]);
        System.arraycopy(tile.values, at + Tile.LIGHT_DISTANCE, disc.values, DiscColumns.DISTANCE, Lanes.COUNT);
        DiscLanes.findRows(tile, at, columns, disc, hierarchy, instance + Layout.INSTANCE_TO_WORLD);
        float size = size(hierarchy, instance + Layout.INSTANCE_TO_WORLD);
        int triangles = Instance.triangles(hierarchy, instance);
        boolean any = false;
        for (int k = first; k < end; k++) {
            disc.number = bench.listed.triangles[k];
            int triangle = triangles + Layout.TRIANGLE_STRIDE * disc.number;
            DiscLanes.place(tile, mesh, disc, triangle);
            DiscLanes.shear(tile, columns, disc);
            DiscLanes.findEdges(tile, disc);
            if (DiscLanes.turn(tile, columns, mesh, disc, triangle, size) != 0L) {
                DiscLanes.mark(tile, columns, disc, drawing.discX, drawing.discY, drawing.shadowSamples);
                any = true;
            }
        }
        return any;
    }

    /** What the transform multiplies volumes by. */
    private static float size(float[] hierarchy, int rows) {
        float x = hierarchy[rows + 5] * hierarchy[rows + 10] - hierarchy[rows + 6] * hierarchy[rows + 9];
        float y = hierarchy[rows + 6] * hierarchy[rows + 8] - hierarchy[rows + 4] * hierarchy[rows + 10];
        float z = hierarchy[rows + 4] * hierarchy[rows + 9] - hierarchy[rows + 5] * hierarchy[rows + 8];
        return Math.abs(hierarchy[rows] * x + hierarchy[rows + 1] * y + hierarchy[rows + 2] * z);
    }

    /** As {@link #project}, sample by sample past all triangles. */
    private static long walk(Drawing drawing, Tile tile, MeshMemory bench, int at, long open) {
        Arrays.fill(bench.blocked, 0f);
        long dimmed = 0L;
        for (int sample = 0; sample < drawing.shadowSamples; sample++) {
            int first = (int) ShadowLines.aim(tile, at, bench, open, drawing.discX[sample], drawing.discY[sample]);
            bench.world.follow(first);
            walk(drawing, tile, bench, at);
            dimmed |= ShadowLines.count(tile, bench);
        }
        return dimmed;
    }

    /** Ends the lines that opaque bodies block, and dims those that pass others. */
    private static void walk(Drawing drawing, Tile tile, MeshMemory bench, int at) {
        Bodies bodies = drawing.input.bodies();
        float[] hierarchy = bodies.floats();
        PacketWalk world = bench.world;
        world.start(hierarchy, bodies.instances() + 1);
        BoxLanes.aim(tile, world);
        InstanceLanes.shear(tile, world);
        int leaf = BoxLanes.nextLeaf(tile, world);
        while (leaf != Layout.NO_NODE) {
            if (hierarchy[leaf + Layout.NODE_SPHERES] == 0f) {
                int instance = Instance.at((int) hierarchy[leaf + Layout.NODE_LINK], bodies.instances(), hierarchy);
                int body = (int) hierarchy[instance + Layout.INSTANCE_BODY];
                long met = meetInstance(bodies, tile, bench, at, instance, body);
                if (met != 0L && drawing.looks.transmits(body)) {
                    ShadowLines.pass(tile, bench, met, drawing.looks.transmission(body));
                }
            } else {
                int instance = Instance.at(MeshHits.openSmall(tile, world, leaf), bodies.instances(), hierarchy);
                InstanceLanes.ignore(
                        tile, world, at, Tile.HIT, Tile.TRIANGLE, (int) hierarchy[instance + Layout.INSTANCE_BODY]);
                block(tile, world);
            }
            leaf = BoxLanes.nextLeaf(tile, world);
        }
    }

    private static long meetInstance(Bodies bodies, Tile tile, MeshMemory bench, int at, int instance, int body) {
        PacketWalk mesh = bench.mesh;
        MeshHits.enter(bodies, tile, bench, instance);
        InstanceLanes.ignore(tile, mesh, at, Tile.HIT, Tile.TRIANGLE, body);
        long met = 0L;
        int leaf = BoxLanes.nextLeaf(tile, mesh);
        while (leaf != Layout.NO_NODE) {
            mesh.open(leaf);
            met |= block(tile, mesh);
            leaf = BoxLanes.nextLeaf(tile, mesh);
        }
        System.arraycopy(mesh.rays, PacketWalk.END, bench.world.rays, PacketWalk.END, Lanes.COUNT);
        return met;
    }

    /** Ends the lines that triangles of a walk's leaf block; returns one bit per ended line. */
    private static long block(Tile tile, PacketWalk walk) {
        int end = walk.end;
        long met = 0L;
        for (int rest = walk.axes; rest != 0; rest &= rest - 1) {
            int axis = Integer.numberOfTrailingZeros(rest);
            int triangle = TriangleLanes.next(tile, walk, walk.triangles, walk.from, end, axis);
            while (triangle < end) {
                met |= TriangleLanes.block(tile, walk, axis, walk.triangles, triangle);
                triangle = TriangleLanes.next(tile, walk, walk.triangles, triangle + 1, end, axis);
            }
        }
        return met;
    }
}
