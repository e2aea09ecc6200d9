package dev.twister.world.table;

import dev.twister.kernel.Layout;
import dev.twister.mesh.Affine;
import dev.twister.scene.Material;
import dev.twister.scene.Vector3;
import dev.twister.scene.material.Alpha;
import dev.twister.world.SceneMeshes;
import dev.twister.world.hierarchy.BoxTree;
import java.util.ArrayList;
import java.util.List;

/** The meshes' part of the hierarchy, see {@link Layout}: the nodes and the instances. */
public final class InstanceTable {
    /** With more meshes, places of small ones may be above 2^24, beyond which floats do not hold all ints. */
    private static final int MOST_WITH_SMALL = 1 << 17;

    private final float[] meshes;
    private final List<Integer> bodies = new ArrayList<>();
    private final List<MeshBody> shown = new ArrayList<>();
    private final List<Affine> inverses = new ArrayList<>();

    /** @param meshes the array of {@link SceneMeshes#floats} */
    private InstanceTable(float[] meshes) {
        this.meshes = meshes;
    }

    /**
     * The table of the visible bodies; empty if there are none. A mesh that its placement flattens has no inverse
     * transform and is invisible.
     *
     * @param firstMesh body number of the first mesh
     */
    static float[] of(List<MeshBody> bodies, float[] meshes, int firstMesh) {
        InstanceTable table = new InstanceTable(meshes);
        for (int i = 0; i < bodies.size(); i++) {
            table.add(bodies.get(i), firstMesh + i);
        }
        return table.shown.isEmpty() ? new float[0] : table.floats();
    }

    private void add(MeshBody body, int number) {
        Affine inverse = Inverse.of(body.placement());
        if (!body.place().isEmpty() && Inverse.isFinite(inverse)) {
            bodies.add(number);
            shown.add(body);
            inverses.add(inverse);
        }
    }

    private float[] floats() {
        boolean few = shown.size() <= MOST_WITH_SMALL;
        List<Leaf> leaves =
                shown.stream().map(body -> Leaf.of(body, meshes, few)).toList();
        float[] boxes = new float[6 * leaves.size()];
        int length = 0;
        for (int i = 0; i < leaves.size(); i++) {
            leaves.get(i).box().write(boxes, 6 * i);
            length += leaves.get(i).floats().length;
        }
        int[] order = new int[leaves.size()];
        float[] nodes = BoxTree.nodes(boxes, order, 1, instance -> instance);
        int before = (nodes.length + length + Layout.NODE_STRIDE - 1) / Layout.NODE_STRIDE;
        int instances = 1 + Layout.NODE_STRIDE * before;
        float[] floats = new float[instances + Layout.INSTANCE_STRIDE * order.length];
        floats[0] = before;
        int end = nodes.length;
        for (int node = 0; node < nodes.length; node += Layout.NODE_STRIDE) {
            if (nodes[node + Layout.NODE_SPHERES] > 0) {
                int number = (int) nodes[node + Layout.NODE_LINK];
                Leaf leaf = leaves.get(order[number]);
                write(floats, instances + Layout.INSTANCE_STRIDE * number, order[number]);
                nodes[node + Layout.NODE_SPHERES] = leaf.triangles();
                if (leaf.triangles() > 0) {
                    nodes[node + Layout.NODE_LINK] = end;
                    System.arraycopy(leaf.floats(), 0, floats, 1 + end, leaf.floats().length);
                    floats[1 + end + Layout.SMALL_INSTANCE] = number;
                    end += leaf.floats().length;
                }
            }
        }
        System.arraycopy(nodes, 0, floats, 1, nodes.length);
        return floats;
    }

    private void write(float[] floats, int at, int instance) {
        write(floats, at + Layout.INSTANCE_TO_MESH, inverses.get(instance));
        write(floats, at + Layout.INSTANCE_TO_WORLD, shown.get(instance).placement());
        MeshPlace place = shown.get(instance).place();
        floats[at + Layout.INSTANCE_BODY] = bodies.get(instance);
        int start = place.start() / Layout.ALIGNMENT;
        floats[at + Layout.INSTANCE_MESH] = start;
        MeshCounts counts = place.counts();
        floats[at + Layout.INSTANCE_NODES] = counts.nodes();
        floats[at + Layout.INSTANCE_TRIANGLES] = counts.triangles();
        floats[at + Layout.INSTANCE_NORMALS] = counts.normals();
        floats[at + Layout.INSTANCE_TEXTURE_PLACES] = counts.texturePlaces();
        floats[at + Layout.INSTANCE_VERTICES] = counts.vertices();
        floats[at + Layout.INSTANCE_COLORS] = counts.colors();
        floats[at + Layout.INSTANCE_TANGENTS] = counts.tangents();
    }

    private static void write(float[] floats, int at, Affine affine) {
        Vector3[] columns = {affine.axisX(), affine.axisY(), affine.axisZ(), affine.origin()};
        for (int column = 0; column < columns.length; column++) {
            floats[at + column] = (float) columns[column].x();
            floats[at + 4 + column] = (float) columns[column].y();
            floats[at + 8 + column] = (float) columns[column].z();
        }
    }

    /** The inverse of a placement. */
    private static final class Inverse {
        private Inverse() {}

        /** The inverse; not finite if there is none. */
        static Affine of(Affine placement) {
            Vector3 x = placement.axisX();
            Vector3 y = placement.axisY();
            Vector3 z = placement.axisZ();
            Vector3 first = y.cross(z);
            double scale = 1 / x.dot(first);
            Vector3 second = z.cross(x);
            Vector3 third = x.cross(y);
            Affine turned = new Affine(
                    new Vector3(first.x(), second.x(), third.x()).times(scale),
                    new Vector3(first.y(), second.y(), third.y()).times(scale),
                    new Vector3(first.z(), second.z(), third.z()).times(scale),
                    Vector3.ZERO);
            Vector3 back = turned.direction(placement.origin());
            return new Affine(turned.axisX(), turned.axisY(), turned.axisZ(), back.times(-1));
        }

        /** Whether all components are finite as floats. */
        static boolean isFinite(Affine affine) {
            return isFinite(affine.axisX())
                    && isFinite(affine.axisY())
                    && isFinite(affine.axisZ())
                    && isFinite(affine.origin());
        }

        private static boolean isFinite(Vector3 vector) {
            return Float.isFinite((float) vector.x())
                    && Float.isFinite((float) vector.y())
                    && Float.isFinite((float) vector.z());
        }
    }

    /**
     * What a leaf of the hierarchy over the meshes has: an instance, or, of a mesh whose own hierarchy is one leaf, its
     * triangles in the world's coordinates, see {@link Layout#SMALL_INSTANCE}. For these, rays need not be transformed.
     *
     * @param triangles number of triangles; 0 for an instance
     * @param floats the triangles' data, without the instance's number; none for an instance
     */
    @SuppressWarnings("ArrayRecordComponent") // never compared
    private record Leaf(MeshBox box, int triangles, float[] floats) {
        /** @param mayBeSmall whether the leaf may have triangles */
        static Leaf of(MeshBody body, float[] meshes, boolean mayBeSmall) {
            return mayBeSmall && body.place().counts().nodes() == 1 && isOpaque(body.material())
                    ? inWorld(body, meshes)
                    : new Leaf(MeshBox.of(body, meshes), 0, new float[0]);
        }

        /** Of other materials, rays need places in the mesh's coordinates, or meet the body once. */
        private static boolean isOpaque(Material material) {
            return material.transmission() == 0 && material.alpha().mode() == Alpha.Mode.OPAQUE;
        }

        private static Leaf inWorld(MeshBody body, float[] meshes) {
            int leaf = body.place().start();
            int first = leaf + Layout.NODE_STRIDE;
            int count = (int) meshes[leaf + Layout.NODE_SPHERES];
            float[] floats = new float[Layout.SMALL_TRIANGLES + Layout.TRIANGLE_STRIDE * count];
            Vector3 low = new Vector3(Double.MAX_VALUE, Double.MAX_VALUE, Double.MAX_VALUE);
            Vector3 high = low.times(-1);
            for (int corner = 0; corner < 3 * count; corner++) {
                int offset = Layout.TRIANGLE_STRIDE * (corner / 3) + 3 * (corner % 3);
                int at = first + offset;
                Vector3 inMesh = new Vector3(meshes[at], meshes[at + 1], meshes[at + 2]);
                Vector3 point = body.placement().point(inMesh);
                int place = Layout.SMALL_TRIANGLES + offset;
                floats[place] = (float) point.x();
                floats[place + 1] = (float) point.y();
                floats[place + 2] = (float) point.z();
                floats[Layout.SMALL_REACH] = Math.max(floats[Layout.SMALL_REACH], reach(body.placement(), inMesh));
                low = low.map(point, Math::min);
                high = high.map(point, Math::max);
            }
            return new Leaf(new MeshBox(low, high), count, floats);
        }

        /** The largest sum of magnitudes that the coordinates of a transformed point are sums of. */
        private static float reach(Affine placement, Vector3 point) {
            Vector3 sum = magnitude(placement.axisX().times(point.x()))
                    .plus(magnitude(placement.axisY().times(point.y())))
                    .plus(magnitude(placement.axisZ().times(point.z())))
                    .plus(magnitude(placement.origin()));
            return (float) Math.max(Math.max(sum.x(), sum.y()), sum.z());
        }

        private static Vector3 magnitude(Vector3 vector) {
            return new Vector3(Math.abs(vector.x()), Math.abs(vector.y()), Math.abs(vector.z()));
        }
    }
}
