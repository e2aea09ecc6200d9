package dev.twister.engine.vector.mesh;

import dev.twister.engine.vector.frame.Drawing;
import dev.twister.engine.vector.lanes.Lanes;
import dev.twister.engine.vector.lanes.Tile;
import dev.twister.kernel.Instance;
import dev.twister.kernel.Layout;
import dev.twister.world.Bodies;
import jdk.incubator.vector.FloatVector;
import jdk.incubator.vector.VectorMask;
import jdk.incubator.vector.VectorOperators;

/** Surface data of mesh hits: {@code MeshSurface} of the kernel. */
public final class MeshSurfaceLanes {
    private MeshSurfaceLanes() {}

    /** Lists the packets with mesh hits, and writes hit points, normals and face normals. */
    public static void find(Drawing drawing, Tile tile, MeshMemory bench) {
        Bodies bodies = drawing.input.bodies();
        float[] hierarchy = bodies.floats();
        tile.meshes.clear();
        for (int k = 0; k < tile.spheres.count; k++) {
            int at = tile.spheres.places[k];
            long rest = met(tile, at, bodies.firstMesh());
            if (rest != 0L) {
                tile.meshes.add(at);
            }
            while (rest != 0L) {
                int number = (int) tile.values[at + Long.numberOfTrailingZeros(rest) + Tile.INSTANCE];
                long lanes = rest & ofInstance(tile, at, number);
                find(drawing, tile, bench, at, lanes, Instance.at(number, bodies.instances(), hierarchy));
                rest &= ~lanes;
            }
        }
    }

    /** One bit per lane with a mesh hit. */
    static long met(Tile tile, int at, int firstMesh) {
        return FloatVector.fromArray(Lanes.FLOATS, tile.values, at + Tile.HIT)
                .compare(VectorOperators.GE, firstMesh)
                .toLong();
    }

    /** One bit per lane whose last mesh hit was this instance. */
    static long ofInstance(Tile tile, int at, int number) {
        return FloatVector.fromArray(Lanes.FLOATS, tile.values, at + Tile.INSTANCE)
                .compare(VectorOperators.EQ, number)
                .toLong();
    }

    private static void find(Drawing drawing, Tile tile, MeshMemory bench, int at, long lanes, int instance) {
        Bodies bodies = drawing.input.bodies();
        float[] hierarchy = bodies.floats();
        PacketWalk world = bench.world;
        PacketWalk mesh = bench.mesh;
        MeshHits.start(tile, world, at);
        InstanceLanes.transform(tile, world, mesh, hierarchy, instance + Layout.INSTANCE_TO_MESH);
        InstanceLanes.shear(tile, mesh);
        boolean smooth = hierarchy[instance + Layout.INSTANCE_NORMALS] > 0f;
        fetch(tile.values, bodies.meshes(), bench.corners, at, lanes, Instance.triangles(hierarchy, instance));
        CornerLanes.weigh(tile, mesh, bench.corners);
        CornerLanes.findPoints(
                tile,
                at,
                bench.corners,
                lanes,
                hierarchy,
                instance + Layout.INSTANCE_TO_WORLD,
                bodies.center(Layout.PLANE, 1));
        CornerLanes.findFaces(tile, bench.corners);
        CornerLanes.turnNormals(tile, at, bench.corners, Tile.FACE_X, lanes, hierarchy, instance);
        if (smooth) {
            fetchNormals(bodies.meshes(), bench.corners, lanes, Instance.normals(hierarchy, instance));
            CornerLanes.mixNormals(tile, bench.corners);
        }
        CornerLanes.turnNormals(tile, at, bench.corners, Tile.NORMAL_X, lanes, hierarchy, instance);
        CornerLanes.face(tile, at, lanes);
        if (drawing.looks.textured && hierarchy[instance + Layout.INSTANCE_TEXTURE_PLACES] > 0f) {
            fetchTexturePlaces(bodies.meshes(), bench.corners, lanes, Instance.texturePlaces(hierarchy, instance));
            CornerLanes.findTexturePlaces(tile, at, bench.corners, lanes);
        }
    }

    /** Copies the corners of each lane's triangle and their vertex numbers. */
    private static void fetch(float[] t, float[] meshes, float[] corners, int at, long lanes, int triangles) {
        for (long rest = lanes; rest != 0L; rest &= rest - 1) {
            int lane = Long.numberOfTrailingZeros(rest);
            int from = triangles + Layout.TRIANGLE_STRIDE * (int) t[at + lane + Tile.TRIANGLE];
            for (int number = 0; number < Layout.TRIANGLE_STRIDE; number++) {
                corners[CornerLanes.CORNERS + number * Lanes.COUNT + lane] = meshes[from + number];
            }
        }
    }

    /** Copies the normals of those vertices. */
    private static void fetchNormals(float[] meshes, float[] corners, long lanes, int normals) {
        for (long rest = lanes; rest != 0L; rest &= rest - 1) {
            int lane = Long.numberOfTrailingZeros(rest);
            for (int corner = 0; corner < 3; corner++) {
                int from = normals + 3 * (int) corners[CornerLanes.VERTICES + corner * Lanes.COUNT + lane];
                int to = CornerLanes.CORNERS + 3 * corner * Lanes.COUNT + lane;
                corners[to] = meshes[from];
                corners[to + Lanes.COUNT] = meshes[from + 1];
                corners[to + 2 * Lanes.COUNT] = meshes[from + 2];
            }
        }
    }

    /** Copies the texture coordinates of those vertices. */
    private static void fetchTexturePlaces(float[] meshes, float[] corners, long lanes, int places) {
        for (long rest = lanes; rest != 0L; rest &= rest - 1) {
            int lane = Long.numberOfTrailingZeros(rest);
            for (int corner = 0; corner < 3; corner++) {
                int from = places + 2 * (int) corners[CornerLanes.VERTICES + corner * Lanes.COUNT + lane];
                int to = CornerLanes.CORNERS + 2 * corner * Lanes.COUNT + lane;
                corners[to] = meshes[from];
                corners[to + Lanes.COUNT] = meshes[from + 1];
            }
        }
    }

    /** Sets the visible part to 0 where the face looks away from the light, and closes those lanes. */
    public static void darken(Tile tile, int firstMesh) {
        float[] t = tile.values;
        for (int k = 0; k < tile.meshes.count; k++) {
            int at = tile.meshes.places[k];
            FloatVector faceX = FloatVector.fromArray(Lanes.FLOATS, t, at + Tile.FACE_X);
            FloatVector faceY = FloatVector.fromArray(Lanes.FLOATS, t, at + Tile.FACE_Y);
            FloatVector faceZ = FloatVector.fromArray(Lanes.FLOATS, t, at + Tile.FACE_Z);
            FloatVector toLight = faceX.mul(FloatVector.fromArray(Lanes.FLOATS, t, at + Tile.TO_LIGHT_X))
                    .add(faceY.mul(FloatVector.fromArray(Lanes.FLOATS, t, at + Tile.TO_LIGHT_Y)))
                    .add(faceZ.mul(FloatVector.fromArray(Lanes.FLOATS, t, at + Tile.TO_LIGHT_Z)));
            VectorMask<Float> fromBehind = faceX.mul(FloatVector.fromArray(Lanes.FLOATS, t, at + Tile.DIRECTION_X))
                    .add(faceY.mul(FloatVector.fromArray(Lanes.FLOATS, t, at + Tile.DIRECTION_Y)))
                    .add(faceZ.mul(FloatVector.fromArray(Lanes.FLOATS, t, at + Tile.DIRECTION_Z)))
                    .compare(VectorOperators.GT, 0f);
            VectorMask<Float> away = toLight.neg()
                    .blend(toLight, fromBehind)
                    .compare(VectorOperators.GE, 0f)
                    .and(FloatVector.fromArray(Lanes.FLOATS, t, at + Tile.HIT).compare(VectorOperators.GE, firstMesh));
            FloatVector.fromArray(Lanes.FLOATS, t, at + Tile.VISIBLE)
                    .blend(0f, away)
                    .intoArray(t, at + Tile.VISIBLE);
            FloatVector.fromArray(Lanes.FLOATS, t, at + Tile.SHADOW_OPEN)
                    .blend(0f, away)
                    .intoArray(t, at + Tile.SHADOW_OPEN);
        }
    }

    /** Sets the triangles that the secondary rays leave. */
    public static void leave(Tile tile) {
        float[] t = tile.values;
        for (int k = 0; k < tile.meshes.count; k++) {
            int at = tile.meshes.places[k];
            FloatVector.fromArray(Lanes.FLOATS, t, at + Tile.TRIANGLE).intoArray(t, at + Tile.LEAVING_TRIANGLE);
        }
    }
}
