package dev.twister.engine.vector.mesh;

import dev.twister.engine.vector.lanes.Lanes;
import dev.twister.engine.vector.lanes.Tile;
import dev.twister.kernel.Layout;
import dev.twister.kernel.MeshSurface;
import dev.twister.kernel.Triangle;
import jdk.incubator.vector.FloatVector;
import jdk.incubator.vector.VectorMask;
import jdk.incubator.vector.VectorOperators;

/** Interpolation over the triangle that each lane has hit: {@link MeshSurface}. */
final class CornerLanes {
    /** Corners A, B and C with x, y and z each; later the normals there. */
    static final int CORNERS = Lanes.BORDER;

    /** The corners' vertex numbers. */
    static final int VERTICES = CORNERS + Layout.TRIANGLE_VERTICES * Lanes.COUNT;

    /** Barycentric weights of B and C at the hit point. */
    private static final int PART_B = CORNERS + Layout.TRIANGLE_STRIDE * Lanes.COUNT;

    private static final int PART_C = PART_B + Lanes.COUNT;

    /** A point or normal in the mesh's coordinates; normals have any length. */
    private static final int NORMAL = PART_B + 2 * Lanes.COUNT;

    static final int LENGTH = NORMAL + 3 * Lanes.COUNT;

    private CornerLanes() {}

    /** Writes the barycentric weights, like {@code Triangle.part}. */
    static void weigh(Tile tile, PacketWalk walk, float[] corners) {
        float[] r = walk.rays;
        FloatVector axis = FloatVector.fromArray(Lanes.FLOATS, r, PacketWalk.AXIS);
        VectorMask<Float> alongX = axis.compare(VectorOperators.EQ, 0f);
        VectorMask<Float> alongZ = axis.compare(VectorOperators.EQ, 2f);
        for (int corner = 0; corner < 3; corner++) {
            int at = CORNERS + 3 * corner * Lanes.COUNT;
            FloatVector x = FloatVector.fromArray(Lanes.FLOATS, corners, at);
            FloatVector y = FloatVector.fromArray(Lanes.FLOATS, corners, at + Lanes.COUNT);
            FloatVector z = FloatVector.fromArray(Lanes.FLOATS, corners, at + 2 * Lanes.COUNT);
            FloatVector depth =
                    y.blend(x, alongX).blend(z, alongZ).sub(FloatVector.fromArray(Lanes.FLOATS, r, PacketWalk.THIRD));
            z.blend(y, alongX)
                    .blend(x, alongZ)
                    .sub(FloatVector.fromArray(Lanes.FLOATS, r, PacketWalk.FIRST))
                    .sub(FloatVector.fromArray(Lanes.FLOATS, r, PacketWalk.SHEAR_FIRST)
                            .mul(depth))
                    .intoArray(r, PacketWalk.AREA_A + corner * Lanes.COUNT);
            x.blend(z, alongX)
                    .blend(y, alongZ)
                    .sub(FloatVector.fromArray(Lanes.FLOATS, r, PacketWalk.SECOND))
                    .sub(FloatVector.fromArray(Lanes.FLOATS, r, PacketWalk.SHEAR_SECOND)
                            .mul(depth))
                    .intoArray(r, PacketWalk.DEPTH_A + corner * Lanes.COUNT);
        }
        FloatVector firstA = FloatVector.fromArray(Lanes.FLOATS, r, PacketWalk.AREA_A);
        FloatVector firstB = FloatVector.fromArray(Lanes.FLOATS, r, PacketWalk.AREA_B);
        FloatVector firstC = FloatVector.fromArray(Lanes.FLOATS, r, PacketWalk.AREA_C);
        FloatVector secondA = FloatVector.fromArray(Lanes.FLOATS, r, PacketWalk.DEPTH_A);
        FloatVector secondB = FloatVector.fromArray(Lanes.FLOATS, r, PacketWalk.DEPTH_B);
        FloatVector secondC = FloatVector.fromArray(Lanes.FLOATS, r, PacketWalk.DEPTH_C);
        FloatVector a = firstC.mul(secondB).sub(secondC.mul(firstB));
        FloatVector b = firstA.mul(secondC).sub(secondA.mul(firstC));
        FloatVector c = firstB.mul(secondA).sub(secondB.mul(firstA));
        FloatVector sum = a.add(b).add(c);
        b.div(sum).intoArray(corners, PART_B);
        c.div(sum).intoArray(corners, PART_C);
    }

    /**
     * Writes the hit points.
     *
     * @param rows start of the rows of the mesh-to-world transform in the hierarchy
     */
    static void findPoints(
            Tile tile, int at, float[] corners, long lanes, float[] hierarchy, int rows, float planeHeight) {
        FloatVector b = FloatVector.fromArray(Lanes.FLOATS, corners, PART_B);
        FloatVector c = FloatVector.fromArray(Lanes.FLOATS, corners, PART_C);
        for (int axis = 0; axis < 3; axis++) {
            int from = CORNERS + axis * Lanes.COUNT;
            FloatVector a = FloatVector.fromArray(Lanes.FLOATS, corners, from);
            a.add(b.mul(FloatVector.fromArray(Lanes.FLOATS, corners, from + 3 * Lanes.COUNT)
                            .sub(a)))
                    .add(c.mul(FloatVector.fromArray(Lanes.FLOATS, corners, from + 6 * Lanes.COUNT)
                            .sub(a)))
                    .intoArray(corners, NORMAL + axis * Lanes.COUNT);
        }
        float[] t = tile.values;
        VectorMask<Float> here = VectorMask.fromLong(Lanes.FLOATS, lanes);
        for (int axis = 0; axis < 3; axis++) {
            int row = rows + 4 * axis;
            int to = at + Tile.POINT_X + axis * Tile.SIZE;
            FloatVector coordinate = FloatVector.fromArray(Lanes.FLOATS, corners, NORMAL)
                    .mul(hierarchy[row])
                    .add(FloatVector.fromArray(Lanes.FLOATS, corners, NORMAL + Lanes.COUNT)
                            .mul(hierarchy[row + 1]))
                    .add(FloatVector.fromArray(Lanes.FLOATS, corners, NORMAL + 2 * Lanes.COUNT)
                            .mul(hierarchy[row + 2]))
                    .add(hierarchy[row + 3]);
            FloatVector.fromArray(Lanes.FLOATS, t, to).blend(coordinate, here).intoArray(t, to);
        }
        ontoPlane(t, at + Tile.POINT_X + Tile.SIZE, corners, lanes, hierarchy, rows + 4, planeHeight);
    }

    /** Moves heights that rounding cannot tell from the plane's to that, as {@code MeshSurface} does. */
    private static void ontoPlane(
            float[] t, int to, float[] corners, long lanes, float[] hierarchy, int row, float height) {
        FloatVector y = FloatVector.fromArray(Lanes.FLOATS, t, to);
        FloatVector slack = FloatVector.fromArray(Lanes.FLOATS, corners, NORMAL)
                .mul(hierarchy[row])
                .abs()
                .add(FloatVector.fromArray(Lanes.FLOATS, corners, NORMAL + Lanes.COUNT)
                        .mul(hierarchy[row + 1])
                        .abs())
                .add(FloatVector.fromArray(Lanes.FLOATS, corners, NORMAL + 2 * Lanes.COUNT)
                        .mul(hierarchy[row + 2])
                        .abs())
                .add(Math.abs(hierarchy[row + 3]) + Math.abs(height))
                .mul(Triangle.ROUNDING);
        VectorMask<Float> on =
                y.sub(height).abs().compare(VectorOperators.LE, slack).and(VectorMask.fromLong(Lanes.FLOATS, lanes));
        y.blend(height, on).intoArray(t, to);
    }

    /** Interpolates the texture coordinates u and v of the three corners, one corner after the other. */
    static void findTexturePlaces(Tile tile, int at, float[] corners, long lanes) {
        float[] t = tile.values;
        FloatVector b = FloatVector.fromArray(Lanes.FLOATS, corners, PART_B);
        FloatVector c = FloatVector.fromArray(Lanes.FLOATS, corners, PART_C);
        VectorMask<Float> here = VectorMask.fromLong(Lanes.FLOATS, lanes);
        for (int axis = 0; axis < 2; axis++) {
            int from = CORNERS + axis * Lanes.COUNT;
            int to = at + Tile.TEXTURE_U + axis * Tile.SIZE;
            FloatVector a = FloatVector.fromArray(Lanes.FLOATS, corners, from);
            FloatVector place = a.add(b.mul(FloatVector.fromArray(Lanes.FLOATS, corners, from + 2 * Lanes.COUNT)
                            .sub(a)))
                    .add(c.mul(FloatVector.fromArray(Lanes.FLOATS, corners, from + 4 * Lanes.COUNT)
                            .sub(a)));
            FloatVector.fromArray(Lanes.FLOATS, t, to).blend(place, here).intoArray(t, to);
        }
    }

    /** Writes the face normals in the mesh's coordinates, scaled so that the largest component is 1. */
    static void findFaces(Tile tile, float[] corners) {
        FloatVector x = FloatVector.fromArray(Lanes.FLOATS, corners, CORNERS);
        FloatVector y = FloatVector.fromArray(Lanes.FLOATS, corners, CORNERS + Lanes.COUNT);
        FloatVector z = FloatVector.fromArray(Lanes.FLOATS, corners, CORNERS + 2 * Lanes.COUNT);
        FloatVector firstX = FloatVector.fromArray(Lanes.FLOATS, corners, CORNERS + 3 * Lanes.COUNT)
                .sub(x);
        FloatVector firstY = FloatVector.fromArray(Lanes.FLOATS, corners, CORNERS + 4 * Lanes.COUNT)
                .sub(y);
        FloatVector firstZ = FloatVector.fromArray(Lanes.FLOATS, corners, CORNERS + 5 * Lanes.COUNT)
                .sub(z);
        FloatVector secondX = FloatVector.fromArray(Lanes.FLOATS, corners, CORNERS + 6 * Lanes.COUNT)
                .sub(x);
        FloatVector secondY = FloatVector.fromArray(Lanes.FLOATS, corners, CORNERS + 7 * Lanes.COUNT)
                .sub(y);
        FloatVector secondZ = FloatVector.fromArray(Lanes.FLOATS, corners, CORNERS + 8 * Lanes.COUNT)
                .sub(z);
        x = firstY.mul(secondZ).sub(firstZ.mul(secondY));
        y = firstZ.mul(secondX).sub(firstX.mul(secondZ));
        z = firstX.mul(secondY).sub(firstY.mul(secondX));
        FloatVector largest = Lanes.larger(Lanes.larger(x.abs(), y.abs()), z.abs());
        FloatVector scale = Lanes.all(1f).div(largest).blend(0f, largest.compare(VectorOperators.LE, 0f));
        x.mul(scale).intoArray(corners, NORMAL);
        y.mul(scale).intoArray(corners, NORMAL + Lanes.COUNT);
        z.mul(scale).intoArray(corners, NORMAL + 2 * Lanes.COUNT);
    }

    /** Interpolates the corners' normals; keeps the face normal where they cancel out. */
    static void mixNormals(Tile tile, float[] corners) {
        FloatVector b = FloatVector.fromArray(Lanes.FLOATS, corners, PART_B);
        FloatVector c = FloatVector.fromArray(Lanes.FLOATS, corners, PART_C);
        FloatVector a = Lanes.all(1f).sub(b).sub(c);
        FloatVector x = a.mul(FloatVector.fromArray(Lanes.FLOATS, corners, CORNERS))
                .add(b.mul(FloatVector.fromArray(Lanes.FLOATS, corners, CORNERS + 3 * Lanes.COUNT)))
                .add(c.mul(FloatVector.fromArray(Lanes.FLOATS, corners, CORNERS + 6 * Lanes.COUNT)));
        FloatVector y = a.mul(FloatVector.fromArray(Lanes.FLOATS, corners, CORNERS + Lanes.COUNT))
                .add(b.mul(FloatVector.fromArray(Lanes.FLOATS, corners, CORNERS + 4 * Lanes.COUNT)))
                .add(c.mul(FloatVector.fromArray(Lanes.FLOATS, corners, CORNERS + 7 * Lanes.COUNT)));
        FloatVector z = a.mul(FloatVector.fromArray(Lanes.FLOATS, corners, CORNERS + 2 * Lanes.COUNT))
                .add(b.mul(FloatVector.fromArray(Lanes.FLOATS, corners, CORNERS + 5 * Lanes.COUNT)))
                .add(c.mul(FloatVector.fromArray(Lanes.FLOATS, corners, CORNERS + 8 * Lanes.COUNT)));
        VectorMask<Float> clear =
                x.mul(x).add(y.mul(y)).add(z.mul(z)).compare(VectorOperators.GT, MeshSurface.LEAST_SQUARE);
        FloatVector.fromArray(Lanes.FLOATS, corners, NORMAL).blend(x, clear).intoArray(corners, NORMAL);
        FloatVector.fromArray(Lanes.FLOATS, corners, NORMAL + Lanes.COUNT)
                .blend(y, clear)
                .intoArray(corners, NORMAL + Lanes.COUNT);
        FloatVector.fromArray(Lanes.FLOATS, corners, NORMAL + 2 * Lanes.COUNT)
                .blend(z, clear)
                .intoArray(corners, NORMAL + 2 * Lanes.COUNT);
    }

    /** Writes the normals as unit vectors in world space to the tile's columns from {@code column} on. */
    static void turnNormals(
            Tile tile, int at, float[] corners, int column, long lanes, float[] hierarchy, int instance) {
        float[] t = tile.values;
        int row = instance + Layout.INSTANCE_TO_MESH;
        FloatVector meshX = FloatVector.fromArray(Lanes.FLOATS, corners, NORMAL);
        FloatVector meshY = FloatVector.fromArray(Lanes.FLOATS, corners, NORMAL + Lanes.COUNT);
        FloatVector meshZ = FloatVector.fromArray(Lanes.FLOATS, corners, NORMAL + 2 * Lanes.COUNT);
        FloatVector x =
                meshX.mul(hierarchy[row]).add(meshY.mul(hierarchy[row + 4])).add(meshZ.mul(hierarchy[row + 8]));
        FloatVector y =
                meshX.mul(hierarchy[row + 1]).add(meshY.mul(hierarchy[row + 5])).add(meshZ.mul(hierarchy[row + 9]));
        FloatVector z =
                meshX.mul(hierarchy[row + 2]).add(meshY.mul(hierarchy[row + 6])).add(meshZ.mul(hierarchy[row + 10]));
        FloatVector inverse = Lanes.inverseRoot(x.mul(x).add(y.mul(y)).add(z.mul(z)));
        VectorMask<Float> here = VectorMask.fromLong(Lanes.FLOATS, lanes);
        FloatVector.fromArray(Lanes.FLOATS, t, at + column)
                .blend(x.mul(inverse), here)
                .intoArray(t, at + column);
        FloatVector.fromArray(Lanes.FLOATS, t, at + column + Tile.SIZE)
                .blend(y.mul(inverse), here)
                .intoArray(t, at + column + Tile.SIZE);
        FloatVector.fromArray(Lanes.FLOATS, t, at + column + 2 * Tile.SIZE)
                .blend(z.mul(inverse), here)
                .intoArray(t, at + column + 2 * Tile.SIZE);
    }

    /** Turns the normals to the side of the face that the ray comes from. */
    static void face(Tile tile, int at, long lanes) {
        float[] t = tile.values;
        FloatVector faceX = FloatVector.fromArray(Lanes.FLOATS, t, at + Tile.FACE_X);
        FloatVector faceY = FloatVector.fromArray(Lanes.FLOATS, t, at + Tile.FACE_Y);
        FloatVector faceZ = FloatVector.fromArray(Lanes.FLOATS, t, at + Tile.FACE_Z);
        FloatVector x = FloatVector.fromArray(Lanes.FLOATS, t, at + Tile.NORMAL_X);
        FloatVector y = FloatVector.fromArray(Lanes.FLOATS, t, at + Tile.NORMAL_Y);
        FloatVector z = FloatVector.fromArray(Lanes.FLOATS, t, at + Tile.NORMAL_Z);
        long fromBehind = faceX.mul(FloatVector.fromArray(Lanes.FLOATS, t, at + Tile.DIRECTION_X))
                .add(faceY.mul(FloatVector.fromArray(Lanes.FLOATS, t, at + Tile.DIRECTION_Y)))
                .add(faceZ.mul(FloatVector.fromArray(Lanes.FLOATS, t, at + Tile.DIRECTION_Z)))
                .compare(VectorOperators.GT, 0f)
                .toLong();
        long apart = x.mul(faceX)
                .add(y.mul(faceY))
                .add(z.mul(faceZ))
                .compare(VectorOperators.LT, 0f)
                .toLong();
        VectorMask<Float> turned = VectorMask.fromLong(Lanes.FLOATS, (fromBehind ^ apart) & lanes);
        x.blend(x.neg(), turned).intoArray(t, at + Tile.NORMAL_X);
        y.blend(y.neg(), turned).intoArray(t, at + Tile.NORMAL_Y);
        z.blend(z.neg(), turned).intoArray(t, at + Tile.NORMAL_Z);
    }
}
