package dev.twister.engine.vector.mesh;

import dev.twister.engine.vector.frame.Drawing;
import dev.twister.engine.vector.frame.MeshColumns;
import dev.twister.engine.vector.lanes.Lanes;
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

    private MeshShadows() {}

    /**
     * Sets the visible part to 0 where meshes block all samples. Where they block some, or a part of some, writes the
     * sum of these parts and lists the packet. Packets without open lanes are removed from {@link Tile#shadows}.
     */
    public static void find(Drawing drawing, Tile tile, MeshBench bench) {
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
    private static long find(Drawing drawing, Tile tile, MeshBench bench, int at, long open) {
        long lit = open;
        float[] blocked = bench.blocked;
        Arrays.fill(blocked, 0f);
        ShadowLines.findAxes(tile, at, drawing, bench);
        for (int sample = 0; sample < drawing.shadowSamples; sample++) {
            int first = (int) ShadowLines.aim(tile, at, bench, open, drawing.discX[sample], drawing.discY[sample]);
            bench.world.follow(first);
            walk(drawing, tile, bench, at);
            lit &= ~ShadowLines.count(tile, bench);
        }
        long dark = open & ShadowLines.hidden(tile, bench, drawing.shadowSamples);
        long part = open & ~dark & ~lit;
        if (part != 0L) {
            tile.meshShadows.add(at);
        }
        ShadowLines.finish(tile, at, bench, dark, part);
        return open & ~dark;
    }

    /** Ends the lines that opaque bodies block, and dims those that pass others. */
    private static void walk(Drawing drawing, Tile tile, MeshBench bench, int at) {
        Bodies bodies = drawing.input.bodies();
        float[] hierarchy = bodies.floats();
        PacketWalk world = bench.world;
        world.start(hierarchy, bodies.instances() + 1);
        BoxLanes.aim(tile, world);
        int leaf = BoxLanes.nextLeaf(tile, world);
        while (leaf != Layout.NO_NODE) {
            int instance = Instance.at((int) hierarchy[leaf + Layout.NODE_LINK], bodies.instances(), hierarchy);
            int body = (int) hierarchy[instance + Layout.INSTANCE_BODY];
            long met = meet(bodies, tile, bench, at, instance, body);
            if (met != 0L && drawing.looks.transmits(body)) {
                ShadowLines.pass(tile, bench, met, drawing.looks.transmission(body));
            }
            leaf = BoxLanes.nextLeaf(tile, world);
        }
    }

    private static long meet(Bodies bodies, Tile tile, MeshBench bench, int at, int instance, int body) {
        float[] hierarchy = bodies.floats();
        PacketWalk mesh = bench.mesh;
        int axes = MeshHits.enter(bodies, tile, bench, instance);
        InstanceLanes.ignore(tile, mesh, at, Tile.HIT, Tile.TRIANGLE, body);
        int triangles = Instance.triangles(hierarchy, instance);
        long met = 0L;
        int leaf = BoxLanes.nextLeaf(tile, mesh);
        while (leaf != Layout.NO_NODE) {
            int from = (int) mesh.boxes[leaf + Layout.NODE_LINK];
            int end = from + (int) mesh.boxes[leaf + Layout.NODE_SPHERES];
            for (int rest = axes; rest != 0; rest &= rest - 1) {
                int axis = Integer.numberOfTrailingZeros(rest);
                int triangle = TriangleLanes.next(tile, mesh, triangles, from, end, axis);
                while (triangle < end) {
                    met |= TriangleLanes.block(tile, mesh, axis, triangles, triangle);
                    triangle = TriangleLanes.next(tile, mesh, triangles, triangle + 1, end, axis);
                }
            }
            leaf = BoxLanes.nextLeaf(tile, mesh);
        }
        System.arraycopy(mesh.rays, PacketWalk.END, bench.world.rays, PacketWalk.END, Lanes.COUNT);
        return met;
    }
}
