package dev.twister.engine.vector.shortcut;

import dev.twister.engine.vector.frame.BodyColumns;
import dev.twister.engine.vector.frame.Drawing;
import dev.twister.engine.vector.frame.MeshColumns;
import dev.twister.engine.vector.frame.ShadingLight;
import dev.twister.engine.vector.frame.Shortcut;
import dev.twister.engine.vector.lanes.BodyList;
import dev.twister.engine.vector.lanes.Lanes;
import dev.twister.engine.vector.lanes.PacketList;
import dev.twister.engine.vector.lanes.ShadowColumns;
import dev.twister.engine.vector.lanes.Tile;
import dev.twister.engine.vector.step.CameraLanes;
import dev.twister.kernel.Layout;
import dev.twister.kernel.Shadow;
import jdk.incubator.vector.FloatVector;
import jdk.incubator.vector.VectorMask;
import jdk.incubator.vector.VectorOperators;

/**
 * A region that contains all rays of a tile: every point within {@code radius} of a cone, up to the end of the rays.
 * The cone's half angle is negative where the region narrows along its axis, as between surfaces and a small light.
 *
 * <p>With a center's distances a along the axis and c across it, {@code c * cos - a * sin - radius} is a lower bound of
 * its distance from the region.
 */
public final class BoundingCone {
    /** Keeps culling conservative: this part of all distances is added to the kernel's margins. */
    private static final float ABSOLUTE_MARGIN = 1e-4f;

    /** Margin for a cosine. */
    private static final float ROUNDING = 1e-6f;

    /** With a smaller cosine the region counts as unbounded. */
    private static final float LEAST_COSINE = 0.02f;

    private static final float BIGGEST = 1e30f;

    /** With more meshes, testing all of them per tile costs more than it saves. */
    private static final int MOST_MESHES = 256;

    /** Half diagonal of a square relative to its half side. */
    private static final float SQUARE_DIAGONAL = 1.4142135f;

    float baseX;
    float baseY;
    float baseZ;
    float axisX;
    float axisY;
    float axisZ;
    float radius;
    float cosine;
    float sine;

    /** Distance along the axis to the end of the region, in meters. */
    public float end;

    /** Whether the region is unbounded. */
    boolean everything;

    private final float[] lanes = new float[Lanes.COUNT];

    /** Holds a tile's view rays: a cone from the camera around the tile's center that contains the tile's corners. */
    void holdViewRays(Tile tile, Drawing drawing) {
        float[] camera = drawing.input.view().frame();
        float half = 0.5f * Tile.SIDE;
        float middleX = tile.left + half - drawing.width * 0.5f;
        float middleY = drawing.input.height() * 0.5f - (drawing.input.firstRow() + tile.top + half);
        float step = drawing.viewportStep;
        startAt(camera[Layout.CAMERA_POSITION], camera[Layout.CAMERA_POSITION + 1], camera[Layout.CAMERA_POSITION + 2]);
        float u = middleX * step;
        float v = middleY * step;
        float length = setAxis(
                CameraLanes.turned(u, v, camera, 0),
                CameraLanes.turned(u, v, camera, 1),
                CameraLanes.turned(u, v, camera, 2));
        // Distance from the center to any corner; its sine bounds the angle.
        float sine = SQUARE_DIAGONAL * half * step / length;
        holdCone((float) Math.sqrt(Math.max(0f, 1f - sine * sine)));
    }

    /** Holds the live rays of some packets: a cone around their mean direction, from a ball around their origins. */
    void holdRays(Tile tile, PacketList packets) {
        float[] t = tile.values;
        FloatVector sumX = Lanes.all(0f);
        FloatVector sumY = Lanes.all(0f);
        FloatVector sumZ = Lanes.all(0f);
        for (int k = 0; k < packets.count; k++) {
            int at = packets.places[k];
            VectorMask<Float> goesOn = Lanes.load(t, at + Tile.THROUGHPUT).compare(VectorOperators.GT, 0f);
            sumX = sumX.blend(sumX.add(Lanes.load(t, at + Tile.DIRECTION_X)), goesOn);
            sumY = sumY.blend(sumY.add(Lanes.load(t, at + Tile.DIRECTION_Y)), goesOn);
            sumZ = sumZ.blend(sumZ.add(Lanes.load(t, at + Tile.DIRECTION_Z)), goesOn);
        }
        sumX.intoArray(lanes, 0);
        float x = sumOfLanes();
        sumY.intoArray(lanes, 0);
        float y = sumOfLanes();
        sumZ.intoArray(lanes, 0);
        float length = setAxis(x, y, sumOfLanes());
        holdCone(length > 0f ? leastCosine(tile, packets) : 0f);
    }

    /** Sums in unspecified order, but faster than {@code reduceLanes}, which sums in order. */
    private float sumOfLanes() {
        float sum = 0f;
        for (float lane : lanes) {
            sum += lane;
        }
        return sum;
    }

    /** Sets the axis; returns the vector's length. */
    float setAxis(float x, float y, float z) {
        axisX = x;
        axisY = y;
        axisZ = z;
        return normalizeAxis();
    }

    /** Sets an endless cone around the axis for rays with at least the given cosine, with a margin for rounding. */
    void holdCone(float leastCosine) {
        cosine = leastCosine - ROUNDING;
        everything = cosine < LEAST_COSINE;
        sine = (float) Math.sqrt(Math.max(0f, 1f - cosine * cosine));
        end = BIGGEST;
    }

    private float normalizeAxis() {
        float length = (float) Math.sqrt(axisX * axisX + axisY * axisY + axisZ * axisZ);
        float inverse = length > 0f ? 1f / length : 0f;
        axisX = axisX * inverse;
        axisY = axisY * inverse;
        axisZ = axisZ * inverse;
        return length;
    }

    /** Smallest cosine between the axis and a live ray. */
    private float leastCosine(Tile tile, PacketList packets) {
        float[] t = tile.values;
        FloatVector least = Lanes.all(1f);
        for (int k = 0; k < packets.count; k++) {
            int at = packets.places[k];
            FloatVector along = Lanes.load(t, at + Tile.DIRECTION_X)
                    .mul(axisX)
                    .add(Lanes.load(t, at + Tile.DIRECTION_Y).mul(axisY))
                    .add(Lanes.load(t, at + Tile.DIRECTION_Z).mul(axisZ));
            VectorMask<Float> wider = along.compare(VectorOperators.LT, least)
                    .and(Lanes.load(t, at + Tile.THROUGHPUT).compare(VectorOperators.GT, 0f));
            least = least.blend(along, wider);
        }
        return Lanes.least(least);
    }

    /** Starts at a point, such as the camera. */
    void startAt(float x, float y, float z) {
        baseX = x;
        baseY = y;
        baseZ = z;
        radius = 0f;
    }

    /** Starts in the ball around a level rectangle. */
    void startIn(float leastX, float mostX, float y, float leastZ, float mostZ) {
        startAt(0.5f * (leastX + mostX), y, 0.5f * (leastZ + mostZ));
        float halfX = 0.5f * (mostX - leastX);
        float halfZ = 0.5f * (mostZ - leastZ);
        radius = (float) Math.sqrt(halfX * halfX + halfZ * halfZ);
    }

    /** Whether the region's start is within the given distance, in meters, of the origin in x and in z. */
    boolean isWithin(float meters) {
        return Math.max(Math.abs(baseX), Math.abs(baseZ)) + radius <= meters;
    }

    /** Copies another region. */
    void hold(BoundingCone other) {
        baseX = other.baseX;
        baseY = other.baseY;
        baseZ = other.baseZ;
        axisX = other.axisX;
        axisY = other.axisY;
        axisZ = other.axisZ;
        radius = other.radius;
        cosine = other.cosine;
        sine = other.sine;
        end = other.end;
        everything = other.everything;
    }

    /** Mirrors the region in the level plane of the given height. */
    void mirror(float height) {
        baseY = 2f * height - baseY;
        axisY = -axisY;
    }

    /** Whether all rays start above the given height and rise. */
    boolean rises(float height) {
        float level = (float) Math.sqrt(Math.max(0f, 1f - axisY * axisY));
        return !everything && baseY - radius > height && axisY * cosine > level * sine;
    }

    /**
     * Starts in a ball around the points in the {@code column} of those lanes whose {@code lanes} column is positive:
     * origins of live rays, or surface points.
     */
    public void startAround(Tile tile, PacketList packets, int column, int lanes) {
        float halfX = spread(tile, packets, column, lanes);
        baseX = middle;
        float halfY = spread(tile, packets, column + Tile.SIZE, lanes);
        baseY = middle;
        float halfZ = spread(tile, packets, column + 2 * Tile.SIZE, lanes);
        baseZ = middle;
        radius = (float) Math.sqrt(halfX * halfX + halfY * halfY + halfZ * halfZ);
    }

    /** Second result of {@link #spread}. */
    private float middle;

    /** Half the extent of the lanes along one axis; sets {@link #middle} to its center. */
    float spread(Tile tile, PacketList packets, int column, int lanes) {
        float[] t = tile.values;
        FloatVector least = Lanes.all(BIGGEST);
        FloatVector most = Lanes.all(-BIGGEST);
        for (int k = 0; k < packets.count; k++) {
            int at = packets.places[k];
            FloatVector value = Lanes.load(t, at + column);
            VectorMask<Float> counts = Lanes.load(t, at + lanes).compare(VectorOperators.GT, 0f);
            least = least.blend(value, value.compare(VectorOperators.LT, least).and(counts));
            most = most.blend(value, value.compare(VectorOperators.GT, most).and(counts));
        }
        float low = Lanes.least(least);
        float high = Lanes.greatest(most);
        middle = 0.5f * (low + high);
        return 0.5f * (high - low);
    }

    /** Ends in a ball: after {@link #startAround}, the region is the convex hull of both balls. */
    void endIn(float x, float y, float z, float endRadius) {
        axisX = x - baseX;
        axisY = y - baseY;
        axisZ = z - baseZ;
        float length = normalizeAxis();
        sine = length > 0f ? (endRadius - radius) / length : 1f;
        float cosineSquared = 1f - sine * sine;
        everything = cosineSquared < LEAST_COSINE;
        cosine = (float) Math.sqrt(Math.max(0f, cosineSquared));
        end = length + endRadius;
    }

    /** Ends at a light, up to its outermost sample, and lists the spheres in between as shadow candidates. */
    public void listTowardsLight(ShadowColumns columns, Drawing drawing, ShadingLight light) {
        endIn(light.x, light.y, light.z, light.discRadius * drawing.rim);
        cull(drawing, Layout.FIRST_SPHERE, columns.tileCandidates);
    }

    /** Lists the bodies that may reach into the region as those that a tile's rays may hit. */
    void cull(Tile tile, Drawing drawing) {
        cull(drawing, Layout.LIGHT, tile.candidates);
    }

    /** Lists the bodies from {@code first} on that may reach into the region. */
    private void cull(Drawing drawing, int first, BodyList found) {
        BodyColumns bodies = drawing.bodies;
        boolean all = everything || !drawing.shortcuts.take(Shortcut.CULLING);
        found.clear();
        for (int at = 0; at < bodies.count; at += Lanes.COUNT) {
            long near = all ? ~0L >>> (64 - Lanes.COUNT) : touching(bodies.x, bodies.y, bodies.z, bodies.radius, at);
            while (near != 0L) {
                int body = at + Long.numberOfTrailingZeros(near);
                near &= near - 1;
                if (body >= first && bodies.radius[body] >= 0f) {
                    found.add(body);
                }
            }
        }
    }

    /** Whether any mesh may reach into the region. */
    public boolean touchesMesh(Drawing drawing) {
        MeshColumns meshes = drawing.bodies.meshes;
        boolean all = everything || !drawing.shortcuts.take(Shortcut.CULLING) || meshes.count > MOST_MESHES;
        boolean touched = all && meshes.count > 0;
        for (int at = 0; at < meshes.count && !touched; at += Lanes.COUNT) {
            touched = touching(meshes.x, meshes.y, meshes.z, meshes.radius, at) != 0L;
        }
        return touched;
    }

    /** One bit per sphere of the packet at {@code at} that may reach into the region. */
    long touching(float[] columnX, float[] columnY, float[] columnZ, float[] radii, int at) {
        FloatVector x = Lanes.load(columnX, at).sub(baseX);
        FloatVector y = Lanes.load(columnY, at).sub(baseY);
        FloatVector z = Lanes.load(columnZ, at).sub(baseZ);
        FloatVector along = x.mul(axisX).add(y.mul(axisY)).add(z.mul(axisZ));
        FloatVector acrossX = x.sub(along.mul(axisX));
        FloatVector acrossY = y.sub(along.mul(axisY));
        FloatVector acrossZ = z.sub(along.mul(axisZ));
        FloatVector across = Lanes.fma(acrossX, acrossX, Lanes.fma(acrossY, acrossY, acrossZ.mul(acrossZ)))
                .sqrt();
        FloatVector reach = Lanes.load(radii, at).add(radius).mul(Shadow.RELATIVE_MARGIN);
        FloatVector margin = along.abs().add(across).add(reach.abs()).mul(ABSOLUTE_MARGIN);
        FloatVector generous = reach.add(margin);
        return across.mul(cosine)
                .sub(along.mul(sine))
                .compare(VectorOperators.LE, generous)
                .and(along.neg().compare(VectorOperators.LE, generous))
                .and(along.sub(generous).compare(VectorOperators.LE, end))
                .toLong();
    }
}
