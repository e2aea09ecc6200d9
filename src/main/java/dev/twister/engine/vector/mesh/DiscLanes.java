package dev.twister.engine.vector.mesh;

import dev.twister.engine.vector.lanes.Lanes;
import dev.twister.engine.vector.lanes.ShadowColumns;
import dev.twister.engine.vector.lanes.Tile;
import dev.twister.kernel.Triangle;
import java.util.Arrays;
import jdk.incubator.vector.FloatVector;
import jdk.incubator.vector.VectorMask;
import jdk.incubator.vector.VectorOperators;

/**
 * Light samples behind a triangle, seen from the points of a packet: the triangle is projected onto the light's disc,
 * where its edges are linear functions of the sample's place. {@link Triangle#distance} does this ray by ray.
 */
final class DiscLanes {
    /** Growth of a triangle, so that rounding opens no gap between two of them. */
    private static final float GROWTH = 3.0e-7f;

    /** Rounding of the test of a triangle against the whole disc. */
    private static final float MARGIN = 1.0e-4f;

    private DiscLanes() {}

    /**
     * Writes the axes A, U and W in the coordinates of a mesh: what they are multiplied by for a place in the frame.
     */
    static void findRows(Tile tile, int at, ShadowColumns columns, DiscColumns disc, float[] hierarchy, int rows) {
        float[] t = tile.values;
        float[] d = disc.values;
        float[] frame = columns.frame;
        for (int axis = 0; axis < 3; axis++) {
            float x = hierarchy[rows + axis];
            float y = hierarchy[rows + 4 + axis];
            float z = hierarchy[rows + 8 + axis];
            int column = axis * Lanes.COUNT;
            FloatVector.fromArray(Lanes.FLOATS, t, at + Tile.TO_LIGHT_X)
                    .mul(x)
                    .add(FloatVector.fromArray(Lanes.FLOATS, t, at + Tile.TO_LIGHT_Y)
                            .mul(y))
                    .add(FloatVector.fromArray(Lanes.FLOATS, t, at + Tile.TO_LIGHT_Z)
                            .mul(z))
                    .intoArray(d, DiscColumns.ROW_A + column);
            FloatVector.fromArray(Lanes.FLOATS, frame, ShadowColumns.U_Y)
                    .mul(y)
                    .add(FloatVector.fromArray(Lanes.FLOATS, frame, ShadowColumns.U_Z)
                            .mul(z))
                    .intoArray(d, DiscColumns.ROW_U + column);
            FloatVector.fromArray(Lanes.FLOATS, frame, ShadowColumns.W_X)
                    .mul(x)
                    .add(FloatVector.fromArray(Lanes.FLOATS, frame, ShadowColumns.W_Y)
                            .mul(y))
                    .add(FloatVector.fromArray(Lanes.FLOATS, frame, ShadowColumns.W_Z)
                            .mul(z))
                    .intoArray(d, DiscColumns.ROW_W + column);
        }
    }

    /** Writes a triangle's corners in the frame, relative to the points. */
    static void place(Tile tile, PacketWalk mesh, DiscColumns disc, int triangle) {
        float[] r = mesh.rays;
        float[] d = disc.values;
        float[] corners = mesh.boxes;
        for (int corner = 0; corner < 3; corner++) {
            int from = triangle + 3 * corner;
            int to = corner * Lanes.COUNT;
            FloatVector x = FloatVector.broadcast(Lanes.FLOATS, corners[from])
                    .sub(FloatVector.fromArray(Lanes.FLOATS, r, PacketWalk.ORIGIN));
            FloatVector y = FloatVector.broadcast(Lanes.FLOATS, corners[from + 1])
                    .sub(FloatVector.fromArray(Lanes.FLOATS, r, PacketWalk.ORIGIN + Lanes.COUNT));
            FloatVector z = FloatVector.broadcast(Lanes.FLOATS, corners[from + 2])
                    .sub(FloatVector.fromArray(Lanes.FLOATS, r, PacketWalk.ORIGIN + 2 * Lanes.COUNT));
            x.mul(FloatVector.fromArray(Lanes.FLOATS, d, DiscColumns.ROW_A))
                    .add(y.mul(FloatVector.fromArray(Lanes.FLOATS, d, DiscColumns.ROW_A + Lanes.COUNT)))
                    .add(z.mul(FloatVector.fromArray(Lanes.FLOATS, d, DiscColumns.ROW_A + 2 * Lanes.COUNT)))
                    .intoArray(d, DiscColumns.A + to);
            x.mul(FloatVector.fromArray(Lanes.FLOATS, d, DiscColumns.ROW_U))
                    .add(y.mul(FloatVector.fromArray(Lanes.FLOATS, d, DiscColumns.ROW_U + Lanes.COUNT)))
                    .add(z.mul(FloatVector.fromArray(Lanes.FLOATS, d, DiscColumns.ROW_U + 2 * Lanes.COUNT)))
                    .intoArray(d, DiscColumns.U + to);
            x.mul(FloatVector.fromArray(Lanes.FLOATS, d, DiscColumns.ROW_W))
                    .add(y.mul(FloatVector.fromArray(Lanes.FLOATS, d, DiscColumns.ROW_W + Lanes.COUNT)))
                    .add(z.mul(FloatVector.fromArray(Lanes.FLOATS, d, DiscColumns.ROW_W + 2 * Lanes.COUNT)))
                    .intoArray(d, DiscColumns.W + to);
        }
    }

    /** Shears the frame so that A leads through the triangle's middle: that keeps the digits of small triangles. */
    static void shear(Tile tile, ShadowColumns columns, DiscColumns disc) {
        float[] d = disc.values;
        FloatVector a = FloatVector.fromArray(Lanes.FLOATS, d, DiscColumns.A);
        FloatVector b = FloatVector.fromArray(Lanes.FLOATS, d, DiscColumns.A + Lanes.COUNT);
        FloatVector c = FloatVector.fromArray(Lanes.FLOATS, d, DiscColumns.A + 2 * Lanes.COUNT);
        FloatVector rim = FloatVector.fromArray(Lanes.FLOATS, columns.frame, ShadowColumns.SCALE);
        FloatVector depth = a.add(b).add(c);
        FloatVector inverse = FloatVector.broadcast(Lanes.FLOATS, 1f).div(depth);
        VectorMask<Float> behind = depth.compare(VectorOperators.LE, 0f);
        for (int column = DiscColumns.U; column <= DiscColumns.W; column += 3 * Lanes.COUNT) {
            FloatVector p = FloatVector.fromArray(Lanes.FLOATS, d, column);
            FloatVector q = FloatVector.fromArray(Lanes.FLOATS, d, column + Lanes.COUNT);
            FloatVector s = FloatVector.fromArray(Lanes.FLOATS, d, column + 2 * Lanes.COUNT);
            FloatVector middle = p.add(q).add(s).mul(inverse);
            middle = Lanes.smaller(Lanes.larger(middle, rim.neg()), rim).blend(0f, behind);
            p.sub(a.mul(middle)).intoArray(d, column);
            q.sub(b.mul(middle)).intoArray(d, column + Lanes.COUNT);
            s.sub(c.mul(middle)).intoArray(d, column + 2 * Lanes.COUNT);
            int to = column == DiscColumns.U ? DiscColumns.MIDDLE_U : DiscColumns.MIDDLE_W;
            middle.intoArray(d, to);
        }
    }

    /** Writes the functions of the three edges, and the volume between point and triangle. */
    static void findEdges(Tile tile, DiscColumns disc) {
        float[] d = disc.values;
        FloatVector volume = FloatVector.zero(Lanes.FLOATS);
        for (int corner = 0; corner < 3; corner++) {
            int one = (corner + 1) % 3 * Lanes.COUNT;
            int other = (corner + 2) % 3 * Lanes.COUNT;
            int to = corner * Lanes.COUNT;
            FloatVector depth = FloatVector.fromArray(Lanes.FLOATS, d, DiscColumns.A + one);
            FloatVector u = FloatVector.fromArray(Lanes.FLOATS, d, DiscColumns.U + one);
            FloatVector w = FloatVector.fromArray(Lanes.FLOATS, d, DiscColumns.W + one);
            FloatVector otherDepth = FloatVector.fromArray(Lanes.FLOATS, d, DiscColumns.A + other);
            FloatVector otherU = FloatVector.fromArray(Lanes.FLOATS, d, DiscColumns.U + other);
            FloatVector otherW = FloatVector.fromArray(Lanes.FLOATS, d, DiscColumns.W + other);
            FloatVector left = u.mul(otherW);
            FloatVector right = otherU.mul(w);
            FloatVector constant = left.sub(right);
            constant.intoArray(d, DiscColumns.CONSTANT + to);
            left.abs().add(right.abs()).mul(GROWTH).intoArray(d, DiscColumns.GROWTH + to);
            otherDepth.mul(w).sub(depth.mul(otherW)).intoArray(d, DiscColumns.X + to);
            depth.mul(otherU).sub(otherDepth.mul(u)).intoArray(d, DiscColumns.Y + to);
            volume = volume.add(constant.mul(FloatVector.fromArray(Lanes.FLOATS, d, DiscColumns.A + to)));
        }
        volume.intoArray(d, DiscColumns.VOLUME);
    }

    /**
     * Gives the edge functions the sign that is positive within the triangle, and closes lanes whose point lies in the
     * triangle's plane; returns one bit per lane whose disc the triangle may cover in part.
     *
     * @param size factor from the mesh's volumes to the frame's
     */
    static long turn(Tile tile, ShadowColumns columns, PacketWalk mesh, DiscColumns disc, int triangle, float size) {
        float[] d = disc.values;
        int number = disc.number;
        FloatVector volume = FloatVector.fromArray(Lanes.FLOATS, d, DiscColumns.VOLUME);
        VectorMask<Float> negative = volume.compare(VectorOperators.LT, 0f);
        FloatVector slack = FloatVector.fromArray(Lanes.FLOATS, mesh.rays, PacketWalk.REACH)
                .add(Triangle.largest(triangle, mesh.boxes))
                .mul(Triangle.slack(triangle, mesh.boxes) * size);
        VectorMask<Float> may = volume.abs()
                .compare(VectorOperators.GT, slack)
                .and(FloatVector.fromArray(Lanes.FLOATS, mesh.rays, PacketWalk.IGNORED)
                        .compare(VectorOperators.NE, number));
        FloatVector rim = FloatVector.fromArray(Lanes.FLOATS, columns.frame, ShadowColumns.SCALE);
        FloatVector middleU = FloatVector.fromArray(Lanes.FLOATS, d, DiscColumns.MIDDLE_U);
        FloatVector middleW = FloatVector.fromArray(Lanes.FLOATS, d, DiscColumns.MIDDLE_W);
        for (int edge = 0; edge < 3 * Lanes.COUNT; edge += Lanes.COUNT) {
            FloatVector constant = FloatVector.fromArray(Lanes.FLOATS, d, DiscColumns.CONSTANT + edge);
            FloatVector x = FloatVector.fromArray(Lanes.FLOATS, d, DiscColumns.X + edge);
            FloatVector y = FloatVector.fromArray(Lanes.FLOATS, d, DiscColumns.Y + edge);
            constant = constant.blend(constant.neg(), negative)
                    .add(FloatVector.fromArray(Lanes.FLOATS, d, DiscColumns.GROWTH + edge));
            x = x.blend(x.neg(), negative);
            y = y.blend(y.neg(), negative);
            constant.intoArray(d, DiscColumns.CONSTANT + edge);
            x.intoArray(d, DiscColumns.X + edge);
            y.intoArray(d, DiscColumns.Y + edge);
            FloatVector toMiddle = x.mul(middleU);
            FloatVector toSide = y.mul(middleW);
            FloatVector most = constant.sub(toMiddle)
                    .sub(toSide)
                    .add(x.mul(x).add(y.mul(y)).sqrt().mul(rim))
                    .add(constant.abs().add(toMiddle.abs()).add(toSide.abs()).mul(MARGIN));
            may = may.and(most.compare(VectorOperators.GE, 0f));
        }
        volume.abs()
                .div(FloatVector.fromArray(Lanes.FLOATS, d, DiscColumns.DISTANCE))
                .blend(Float.MAX_VALUE, may.not())
                .intoArray(d, DiscColumns.VOLUME);
        return may.toLong();
    }

    /** Marks the samples that the triangle blocks. */
    static void mark(Tile tile, ShadowColumns columns, DiscColumns disc, float[] discX, float[] discY, int samples) {
        float[] d = disc.values;
        float[] hits = disc.hits;
        FloatVector scale = FloatVector.fromArray(Lanes.FLOATS, columns.frame, ShadowColumns.SCALE);
        FloatVector middleU = FloatVector.fromArray(Lanes.FLOATS, d, DiscColumns.MIDDLE_U);
        FloatVector middleW = FloatVector.fromArray(Lanes.FLOATS, d, DiscColumns.MIDDLE_W);
        FloatVector x1 = FloatVector.fromArray(Lanes.FLOATS, d, DiscColumns.X);
        FloatVector y1 = FloatVector.fromArray(Lanes.FLOATS, d, DiscColumns.Y);
        FloatVector c1 = FloatVector.fromArray(Lanes.FLOATS, d, DiscColumns.CONSTANT);
        FloatVector x2 = FloatVector.fromArray(Lanes.FLOATS, d, DiscColumns.X + Lanes.COUNT);
        FloatVector y2 = FloatVector.fromArray(Lanes.FLOATS, d, DiscColumns.Y + Lanes.COUNT);
        FloatVector c2 = FloatVector.fromArray(Lanes.FLOATS, d, DiscColumns.CONSTANT + Lanes.COUNT);
        FloatVector x3 = FloatVector.fromArray(Lanes.FLOATS, d, DiscColumns.X + 2 * Lanes.COUNT);
        FloatVector y3 = FloatVector.fromArray(Lanes.FLOATS, d, DiscColumns.Y + 2 * Lanes.COUNT);
        FloatVector c3 = FloatVector.fromArray(Lanes.FLOATS, d, DiscColumns.CONSTANT + 2 * Lanes.COUNT);
        FloatVector volume = FloatVector.fromArray(Lanes.FLOATS, d, DiscColumns.VOLUME);
        for (int sample = 0; sample < samples; sample++) {
            FloatVector x = scale.mul(discX[sample]).sub(middleU);
            FloatVector y = scale.mul(discY[sample]).sub(middleW);
            FloatVector first = Lanes.fma(x, x1, Lanes.fma(y, y1, c1));
            FloatVector second = Lanes.fma(x, x2, Lanes.fma(y, y2, c2));
            FloatVector third = Lanes.fma(x, x3, Lanes.fma(y, y3, c3));
            VectorMask<Float> blocks = first.compare(VectorOperators.GE, 0f)
                    .and(second.compare(VectorOperators.GE, 0f))
                    .and(third.compare(VectorOperators.GE, 0f))
                    .and(first.add(second).add(third).compare(VectorOperators.GT, volume));
            int to = Lanes.BORDER + sample * Lanes.COUNT;
            FloatVector.fromArray(Lanes.FLOATS, hits, to).blend(1f, blocks).intoArray(hits, to);
        }
    }

    /** Dims the marked samples by a body's transmission, and removes the marks. */
    static void dim(Tile tile, DiscColumns disc, float transmission, int samples) {
        float[] hits = disc.hits;
        float[] light = disc.light;
        for (int sample = 0; sample < samples; sample++) {
            int at = Lanes.BORDER + sample * Lanes.COUNT;
            FloatVector lit = FloatVector.fromArray(Lanes.FLOATS, light, at);
            VectorMask<Float> hit =
                    FloatVector.fromArray(Lanes.FLOATS, hits, at).compare(VectorOperators.GT, 0f);
            lit.blend(lit.mul(transmission), hit).intoArray(light, at);
        }
        Arrays.fill(hits, Lanes.BORDER, Lanes.BORDER + samples * Lanes.COUNT, 0f);
    }

    /** Writes the sum of the blocked parts; returns one bit per lane with any. */
    static long count(Tile tile, DiscColumns disc, float[] blocked, int samples) {
        float[] light = disc.light;
        FloatVector sum = FloatVector.zero(Lanes.FLOATS);
        for (int sample = 0; sample < samples; sample++) {
            sum = sum.add(FloatVector.broadcast(Lanes.FLOATS, 1f)
                    .sub(FloatVector.fromArray(Lanes.FLOATS, light, Lanes.BORDER + sample * Lanes.COUNT)));
        }
        sum.intoArray(blocked, Lanes.BORDER);
        return sum.compare(VectorOperators.GT, 0f).toLong();
    }
}
