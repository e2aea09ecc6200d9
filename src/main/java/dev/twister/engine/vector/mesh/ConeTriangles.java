package dev.twister.engine.vector.mesh;

import dev.twister.engine.vector.frame.Drawing;
import dev.twister.engine.vector.lanes.Tile;
import dev.twister.kernel.Instance;
import dev.twister.kernel.Layout;
import dev.twister.world.Bodies;

/** The triangles whose boxes a packet's cones meet, by instance. */
final class ConeTriangles {
    /** With more triangles, lines to each sample walk the hierarchies on their own. */
    private static final int MOST = 256;

    /** The transform of world coordinates to themselves. */
    private static final float[] SAME = {1f, 0f, 0f, 0f, 0f, 1f, 0f, 0f, 0f, 0f, 1f, 0f};

    private final PacketCones world = new PacketCones();
    private final PacketCones mesh = new PacketCones();

    final int[] triangles = new int[MOST + 1];

    /** The instances of which there are triangles, and for each the index after its last triangle. */
    final int[] instances = new int[MOST + 1];

    final int[] ends = new int[MOST + 1];

    int instanceCount;

    private int count;

    /**
     * Lists the triangles that may block light samples from some lanes of a packet, whose disc axes are known; returns
     * whether the list had room for all.
     *
     * @param lanes one bit per lane, at least one
     */
    boolean find(Drawing drawing, Tile tile, int at, MeshMemory bench, long lanes) {
        Bodies bodies = drawing.input.bodies();
        float[] hierarchy = bodies.floats();
        count = 0;
        instanceCount = 0;
        world.start(hierarchy, bodies.instances() + 1);
        ConeLanes.aim(tile, at, bench.shadows.columns, world, SAME, 0, lanes);
        int leaf = ConeLanes.nextLeaf(tile, world);
        while (leaf != Layout.NO_NODE && count <= MOST) {
            int inLeaf = (int) hierarchy[leaf + Layout.NODE_SPHERES];
            int link = (int) hierarchy[leaf + Layout.NODE_LINK];
            int before = count;
            if (inLeaf == 0) {
                int instance = Instance.at(link, bodies.instances(), hierarchy);
                mesh.start(bodies.meshes(), Instance.nodes(hierarchy, instance));
                ConeLanes.aim(
                        tile, at, bench.shadows.columns, mesh, hierarchy, instance + Layout.INSTANCE_TO_MESH, lanes);
                addMesh(tile, Instance.triangles(hierarchy, instance));
                end(before, instance);
            } else {
                int small = world.nodes + link;
                add(tile, world, small + Layout.SMALL_TRIANGLES, 0, inLeaf);
                end(before, Instance.at((int) hierarchy[small + Layout.SMALL_INSTANCE], bodies.instances(), hierarchy));
            }
            leaf = ConeLanes.nextLeaf(tile, world);
        }
        return count <= MOST;
    }

    private void addMesh(Tile tile, int triangles) {
        int leaf = ConeLanes.nextLeaf(tile, mesh);
        while (leaf != Layout.NO_NODE && count <= MOST) {
            int from = (int) mesh.boxes[leaf + Layout.NODE_LINK];
            add(tile, mesh, triangles, from, from + (int) mesh.boxes[leaf + Layout.NODE_SPHERES]);
            leaf = ConeLanes.nextLeaf(tile, mesh);
        }
    }

    /**
     * Adds those of some triangles that any cone meets.
     *
     * @param triangles place of triangle number 0
     */
    private void add(Tile tile, PacketCones cones, int triangles, int from, int end) {
        for (int triangle = from; triangle < end && count <= MOST; triangle++) {
            if (ConeLanes.meetTriangle(tile, cones, triangles + Layout.TRIANGLE_STRIDE * triangle)) {
                this.triangles[count] = triangle;
                count++;
            }
        }
    }

    /** Ends the triangles of an instance. */
    private void end(int before, int instance) {
        if (count > before) {
            instances[instanceCount] = instance;
            ends[instanceCount] = count;
            instanceCount++;
        }
    }
}
