package dev.twister.engine.vector.mesh;

import dev.twister.engine.vector.lanes.Lanes;
import dev.twister.engine.vector.lanes.Tile;
import dev.twister.kernel.Coincidence;
import dev.twister.kernel.Layout;
import dev.twister.kernel.Triangle;
import jdk.incubator.vector.FloatVector;
import jdk.incubator.vector.VectorMask;
import jdk.incubator.vector.VectorOperators;

/**
 * Triangle tests of a packet's rays: {@link Triangle#distance}, with the same rounding. They call no helpers; see
 * {@code ShadowConics}.
 */
final class TriangleLanes {
    private TriangleLanes() {}

    /**
     * Finds the next triangle around any ray with the given dominant axis, and writes its areas and depths.
     *
     * @param triangles place of the mesh's first triangle
     * @param from first triangle to test
     * @param end index after the last one
     * @return the triangle, or {@code end}
     */
    static int next(Tile tile, PacketWalk walk, int triangles, int from, int end, int axis) {
        float[] meshes = walk.boxes;
        float[] r = walk.rays;
        int axisFirst = Triangle.after(axis);
        int axisSecond = Triangle.after(axisFirst);
        VectorMask<Float> wanted = FloatVector.fromArray(Lanes.FLOATS, r, PacketWalk.END)
                .compare(VectorOperators.GE, 0f)
                .and(FloatVector.fromArray(Lanes.FLOATS, r, PacketWalk.AXIS).compare(VectorOperators.EQ, axis));
        FloatVector first = FloatVector.fromArray(Lanes.FLOATS, r, PacketWalk.FIRST);
        FloatVector second = FloatVector.fromArray(Lanes.FLOATS, r, PacketWalk.SECOND);
        FloatVector third = FloatVector.fromArray(Lanes.FLOATS, r, PacketWalk.THIRD);
        FloatVector shearFirst = FloatVector.fromArray(Lanes.FLOATS, r, PacketWalk.SHEAR_FIRST);
        FloatVector shearSecond = FloatVector.fromArray(Lanes.FLOATS, r, PacketWalk.SHEAR_SECOND);
        int triangle = from;
        boolean met = false;
        while (triangle < end && !met) {
            int at = triangles + Layout.TRIANGLE_STRIDE * triangle;
            FloatVector depthA =
                    FloatVector.broadcast(Lanes.FLOATS, meshes[at + axis]).sub(third);
            FloatVector depthB =
                    FloatVector.broadcast(Lanes.FLOATS, meshes[at + 3 + axis]).sub(third);
            FloatVector depthC =
                    FloatVector.broadcast(Lanes.FLOATS, meshes[at + 6 + axis]).sub(third);
            FloatVector firstA = FloatVector.broadcast(Lanes.FLOATS, meshes[at + axisFirst])
                    .sub(first)
                    .sub(shearFirst.mul(depthA));
            FloatVector firstB = FloatVector.broadcast(Lanes.FLOATS, meshes[at + 3 + axisFirst])
                    .sub(first)
                    .sub(shearFirst.mul(depthB));
            FloatVector firstC = FloatVector.broadcast(Lanes.FLOATS, meshes[at + 6 + axisFirst])
                    .sub(first)
                    .sub(shearFirst.mul(depthC));
            FloatVector secondA = FloatVector.broadcast(Lanes.FLOATS, meshes[at + axisSecond])
                    .sub(second)
                    .sub(shearSecond.mul(depthA));
            FloatVector secondB = FloatVector.broadcast(Lanes.FLOATS, meshes[at + 3 + axisSecond])
                    .sub(second)
                    .sub(shearSecond.mul(depthB));
            FloatVector secondC = FloatVector.broadcast(Lanes.FLOATS, meshes[at + 6 + axisSecond])
                    .sub(second)
                    .sub(shearSecond.mul(depthC));
            FloatVector a = firstC.mul(secondB).sub(secondC.mul(firstB));
            FloatVector b = firstA.mul(secondC).sub(secondA.mul(firstC));
            FloatVector c = firstB.mul(secondA).sub(secondB.mul(firstA));
            VectorMask<Float> below = a.compare(VectorOperators.LT, 0f)
                    .or(b.compare(VectorOperators.LT, 0f))
                    .or(c.compare(VectorOperators.LT, 0f));
            VectorMask<Float> above = a.compare(VectorOperators.GT, 0f)
                    .or(b.compare(VectorOperators.GT, 0f))
                    .or(c.compare(VectorOperators.GT, 0f));
            met = wanted.andNot(below.and(above)).anyTrue();
            if (met) {
                a.intoArray(r, PacketWalk.AREA_A);
                b.intoArray(r, PacketWalk.AREA_B);
                c.intoArray(r, PacketWalk.AREA_C);
                depthA.intoArray(r, PacketWalk.DEPTH_A);
                depthB.intoArray(r, PacketWalk.DEPTH_B);
                depthC.intoArray(r, PacketWalk.DEPTH_C);
            } else {
                triangle++;
            }
        }
        return triangle;
    }

    /**
     * Shortens the rays of the given axis that hit the current triangle before their ends, and writes it as their hit.
     *
     * @param triangles place of the mesh's first triangle
     * @return one bit per ray that the triangle meets at its end, as closely as {@link Coincidence#TOLERANCE}; those
     *     are unchanged, with the distance in {@link PacketWalk#MET}
     */
    static long keepNearest(
            Tile tile, PacketWalk walk, int at, int axis, int triangles, int triangle, int instance, int body) {
        float[] t = tile.values;
        float[] r = walk.rays;
        FloatVector a = FloatVector.fromArray(Lanes.FLOATS, r, PacketWalk.AREA_A);
        FloatVector b = FloatVector.fromArray(Lanes.FLOATS, r, PacketWalk.AREA_B);
        FloatVector c = FloatVector.fromArray(Lanes.FLOATS, r, PacketWalk.AREA_C);
        VectorMask<Float> below = a.compare(VectorOperators.LT, 0f)
                .or(b.compare(VectorOperators.LT, 0f))
                .or(c.compare(VectorOperators.LT, 0f));
        VectorMask<Float> above = a.compare(VectorOperators.GT, 0f)
                .or(b.compare(VectorOperators.GT, 0f))
                .or(c.compare(VectorOperators.GT, 0f));
        FloatVector sum = a.add(b).add(c);
        FloatVector volume = a.mul(FloatVector.fromArray(Lanes.FLOATS, r, PacketWalk.DEPTH_A))
                .add(b.mul(FloatVector.fromArray(Lanes.FLOATS, r, PacketWalk.DEPTH_B)))
                .add(c.mul(FloatVector.fromArray(Lanes.FLOATS, r, PacketWalk.DEPTH_C)));
        FloatVector distance = volume.div(sum).mul(FloatVector.fromArray(Lanes.FLOATS, r, PacketWalk.LONGEST_INVERSE));
        int place = triangles + Layout.TRIANGLE_STRIDE * triangle;
        FloatVector reach = FloatVector.fromArray(Lanes.FLOATS, r, PacketWalk.REACH);
        FloatVector slack = reach.abs().add(Triangle.largest(place, walk.boxes)).mul(Triangle.slack(place, walk.boxes));
        VectorMask<Float> apart = volume.abs().compare(VectorOperators.GT, slack);
        VectorMask<Float> touches = reach.compare(VectorOperators.LT, 0f).andNot(apart);
        distance = distance.blend(
                Triangle.TOUCHING,
                distance.compare(VectorOperators.LT, Triangle.TOUCHING).and(touches));
        FloatVector end = FloatVector.fromArray(Lanes.FLOATS, r, PacketWalk.END);
        VectorMask<Float> met = distance.compare(VectorOperators.LE, end.mul(1f + Coincidence.TOLERANCE))
                .and(distance.compare(VectorOperators.GT, 0f))
                .and(apart.or(touches))
                .and(sum.compare(VectorOperators.NE, 0f))
                .and(FloatVector.fromArray(Lanes.FLOATS, r, PacketWalk.AXIS).compare(VectorOperators.EQ, axis))
                .and(FloatVector.fromArray(Lanes.FLOATS, r, PacketWalk.IGNORED).compare(VectorOperators.NE, triangle))
                .andNot(below.and(above));
        FloatVector hit = FloatVector.fromArray(Lanes.FLOATS, t, at + Tile.HIT);
        VectorMask<Float> close = met.and(distance.compare(VectorOperators.GE, end.mul(1f - Coincidence.TOLERANCE)));
        VectorMask<Float> taken = met.andNot(close);
        if (close.anyTrue()) {
            distance.intoArray(r, PacketWalk.MET);
        }
        end.blend(distance, taken).intoArray(r, PacketWalk.END);
        FloatVector.fromArray(Lanes.FLOATS, t, at + Tile.DISTANCE)
                .blend(distance, taken)
                .intoArray(t, at + Tile.DISTANCE);
        hit.blend(body, taken).intoArray(t, at + Tile.HIT);
        FloatVector.fromArray(Lanes.FLOATS, t, at + Tile.INSTANCE)
                .blend(instance, taken)
                .intoArray(t, at + Tile.INSTANCE);
        FloatVector.fromArray(Lanes.FLOATS, t, at + Tile.TRIANGLE)
                .blend(triangle, taken)
                .intoArray(t, at + Tile.TRIANGLE);
        return close.toLong();
    }

    /**
     * Ends the rays of the given axis that hit the current triangle; returns one bit per ended ray.
     *
     * @param triangles place of the mesh's first triangle
     */
    static long block(Tile tile, PacketWalk walk, int axis, int triangles, int triangle) {
        float[] r = walk.rays;
        FloatVector a = FloatVector.fromArray(Lanes.FLOATS, r, PacketWalk.AREA_A);
        FloatVector b = FloatVector.fromArray(Lanes.FLOATS, r, PacketWalk.AREA_B);
        FloatVector c = FloatVector.fromArray(Lanes.FLOATS, r, PacketWalk.AREA_C);
        VectorMask<Float> below = a.compare(VectorOperators.LT, 0f)
                .or(b.compare(VectorOperators.LT, 0f))
                .or(c.compare(VectorOperators.LT, 0f));
        VectorMask<Float> above = a.compare(VectorOperators.GT, 0f)
                .or(b.compare(VectorOperators.GT, 0f))
                .or(c.compare(VectorOperators.GT, 0f));
        FloatVector sum = a.add(b).add(c);
        FloatVector volume = a.mul(FloatVector.fromArray(Lanes.FLOATS, r, PacketWalk.DEPTH_A))
                .add(b.mul(FloatVector.fromArray(Lanes.FLOATS, r, PacketWalk.DEPTH_B)))
                .add(c.mul(FloatVector.fromArray(Lanes.FLOATS, r, PacketWalk.DEPTH_C)));
        FloatVector distance = volume.div(sum).mul(FloatVector.fromArray(Lanes.FLOATS, r, PacketWalk.LONGEST_INVERSE));
        int place = triangles + Layout.TRIANGLE_STRIDE * triangle;
        FloatVector slack = FloatVector.fromArray(Lanes.FLOATS, r, PacketWalk.REACH)
                .add(Triangle.largest(place, walk.boxes))
                .mul(Triangle.slack(place, walk.boxes));
        FloatVector end = FloatVector.fromArray(Lanes.FLOATS, r, PacketWalk.END);
        VectorMask<Float> met = distance.compare(VectorOperators.LT, end)
                .and(distance.compare(VectorOperators.GT, 0f))
                .and(volume.abs().compare(VectorOperators.GT, slack))
                .and(sum.compare(VectorOperators.NE, 0f))
                .and(FloatVector.fromArray(Lanes.FLOATS, r, PacketWalk.AXIS).compare(VectorOperators.EQ, axis))
                .and(FloatVector.fromArray(Lanes.FLOATS, r, PacketWalk.IGNORED).compare(VectorOperators.NE, triangle))
                .andNot(below.and(above));
        end.blend(-1f, met).intoArray(r, PacketWalk.END);
        return met.toLong();
    }
}
