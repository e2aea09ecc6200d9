package dev.twister.engine.vector.shortcut;

import dev.twister.engine.vector.frame.BodyColumns;
import dev.twister.engine.vector.frame.Drawing;
import dev.twister.engine.vector.frame.ShadingLight;
import dev.twister.engine.vector.lanes.Lanes;
import dev.twister.engine.vector.lanes.Tile;
import dev.twister.engine.vector.step.CameraLanes;
import dev.twister.kernel.Illumination;
import dev.twister.kernel.Layout;
import jdk.incubator.vector.FloatVector;
import jdk.incubator.vector.VectorMask;
import jdk.incubator.vector.VectorOperators;

/**
 * Ground tiles: all view rays hit the plane first. The steps here are specialized: the normal points up, all lanes have
 * the same hit, and reflection only negates y.
 */
public final class GroundAlone {
    /** What a tile without spheres and light shows. */
    enum View {
        /** All view rays miss the plane. */
        NOTHING,
        /** All view rays hit the plane, and its specular exponent is an integer, as the steps here require. */
        GROUND,
        /** Undecided: some view rays may hit the plane. */
        PART
    }

    /** Part of the plane's half side within which a hit is certain. */
    private static final float WITHIN = 0.9999f;

    private GroundAlone() {}

    /**
     * Classifies a tile whose view rays hit neither spheres nor the light. The visible part of the plane's level is a
     * quadrilateral; it lies in the plane's square if its corners do. In that case {@code ground} is set to start
     * around it.
     */
    static View view(Tile tile, Drawing drawing, BoundingCone ground) {
        float[] camera = drawing.input.view().frame();
        float down = drawing.planeHeight - camera[Layout.CAMERA_POSITION + 1];
        boolean meets = true;
        float leastX = Float.MAX_VALUE;
        float leastZ = Float.MAX_VALUE;
        float mostX = -Float.MAX_VALUE;
        float mostZ = -Float.MAX_VALUE;
        for (int corner = 0; corner < 4 && meets; corner++) {
            float along = down / CameraLanes.corner(drawing, tile, corner, 1);
            float x = camera[Layout.CAMERA_POSITION] + along * CameraLanes.corner(drawing, tile, corner, 0);
            float z = camera[Layout.CAMERA_POSITION + 2] + along * CameraLanes.corner(drawing, tile, corner, 2);
            leastX = Math.min(leastX, x);
            leastZ = Math.min(leastZ, z);
            mostX = Math.max(mostX, x);
            mostZ = Math.max(mostZ, z);
            // Where along overflows, a ray is level or almost level.
            meets = along > 0f && along < Float.MAX_VALUE;
        }
        View view = View.PART;
        float within = WITHIN * drawing.planeHalfSide;
        float outside = drawing.planeHalfSide / WITHIN;
        float left = leastX - drawing.planeX;
        float right = mostX - drawing.planeX;
        float front = leastZ - drawing.planeZ;
        float back = mostZ - drawing.planeZ;
        if (meets && (left > outside || right < -outside || front > outside || back < -outside)) {
            view = View.NOTHING;
        } else if (meets
                && left > -within
                && right < within
                && front > -within
                && back < within
                && isWhole(drawing.bodies.reflectivity(Layout.PLANE))) {
            view = View.GROUND;
            ground.startIn(leastX, mostX, drawing.planeHeight, leastZ, mostZ);
        }
        return view;
    }

    private static boolean isWhole(float power) {
        return power == (int) power;
    }

    /** Lists all live packets as ground, and writes hits, hit points and a throughput of 1. */
    public static void meet(Tile tile, Drawing drawing) {
        tile.skies.clear();
        tile.lights.clear();
        tile.spheres.clear();
        tile.grounds.clear();
        tile.surfaces.clear();
        float[] camera = drawing.input.view().frame();
        float fromX = camera[Layout.CAMERA_POSITION];
        float fromZ = camera[Layout.CAMERA_POSITION + 2];
        float height = drawing.planeHeight;
        float down = height - camera[Layout.CAMERA_POSITION + 1];
        float[] t = tile.values;
        for (int k = 0; k < tile.live.count; k++) {
            int at = tile.live.places[k];
            tile.grounds.add(at);
            tile.surfaces.add(at);
            FloatVector along = Lanes.all(down).div(Lanes.load(t, at + Tile.DIRECTION_Y));
            // Rounded like the kernel's points: far away, rounding decides which square of the checker is hit.
            Lanes.load(t, at + Tile.DIRECTION_X).mul(along).add(fromX).intoArray(t, at + Tile.POINT_X);
            Lanes.all(height).intoArray(t, at + Tile.POINT_Y);
            Lanes.load(t, at + Tile.DIRECTION_Z).mul(along).add(fromZ).intoArray(t, at + Tile.POINT_Z);
            Lanes.all(Layout.PLANE).intoArray(t, at + Tile.HIT);
            Lanes.all(1f).intoArray(t, at + Tile.THROUGHPUT);
        }
    }

    /** Replaces {@code LightDirection}. */
    public static void findLight(Tile tile, Drawing drawing) {
        tile.shadows.clear();
        BodyColumns bodies = drawing.bodies;
        ShadingLight light = drawing.lights[0];
        float lightX = light.x;
        float lightZ = light.z;
        float above = light.y - drawing.planeHeight;
        float least = bodies.reflectivity(Layout.PLANE) > 0f ? 0f : drawing.ambient;
        float[] t = tile.values;
        for (int k = 0; k < tile.grounds.count; k++) {
            int at = tile.grounds.places[k];
            FloatVector x = Lanes.all(lightX).sub(Lanes.load(t, at + Tile.POINT_X));
            FloatVector z = Lanes.all(lightZ).sub(Lanes.load(t, at + Tile.POINT_Z));
            FloatVector squared = Lanes.fma(x, x, Lanes.fma(z, z, Lanes.all(above * above)));
            FloatVector inverse = Lanes.inverseRoot(squared);
            FloatVector cosine = inverse.mul(above);
            x.mul(inverse).intoArray(t, at + Tile.TO_LIGHT_X);
            cosine.intoArray(t, at + Tile.TO_LIGHT_Y);
            z.mul(inverse).intoArray(t, at + Tile.TO_LIGHT_Z);
            squared.mul(inverse).intoArray(t, at + Tile.LIGHT_DISTANCE);
            cosine.intoArray(t, at + Tile.NORMAL_DOT_LIGHT);
            Lanes.all(1f).intoArray(t, at + Tile.VISIBLE);
            VectorMask<Float> open = cosine.compare(VectorOperators.GT, least);
            Lanes.all(0f).blend(1f, open).intoArray(t, at + Tile.SHADOW_OPEN);
            if (open.anyTrue()) {
                tile.shadows.add(at);
            }
        }
    }

    /** Replaces {@code Highlight.findCosines} and {@code Highlight.sort}: all lanes have the same exponent. */
    public static void findHighlight(Tile tile, Drawing drawing) {
        tile.onePower.clear();
        tile.wholePowers.clear();
        tile.fractionPowers.clear();
        float power = drawing.bodies.reflectivity(Layout.PLANE);
        float shine = (power + 8f) * Illumination.INVERSE_EIGHT_PI * power * (1f / Layout.MAX_REFLECTIVITY);
        float[] t = tile.values;
        for (int k = 0; k < tile.grounds.count; k++) {
            int at = tile.grounds.places[k];
            FloatVector x = Lanes.load(t, at + Tile.TO_LIGHT_X).sub(Lanes.load(t, at + Tile.DIRECTION_X));
            FloatVector y = Lanes.load(t, at + Tile.TO_LIGHT_Y).sub(Lanes.load(t, at + Tile.DIRECTION_Y));
            FloatVector z = Lanes.load(t, at + Tile.TO_LIGHT_Z).sub(Lanes.load(t, at + Tile.DIRECTION_Z));
            FloatVector cosine = y.mul(Lanes.inverseRoot(Lanes.fma(x, x, Lanes.fma(y, y, z.mul(z)))));
            Lanes.smaller(Lanes.larger(cosine, Lanes.all(0f)), Lanes.all(1f)).intoArray(t, at + Tile.SPECULAR);
            Lanes.all(0f)
                    .blend(
                            Lanes.load(t, at + Tile.VISIBLE).mul(shine),
                            Lanes.load(t, at + Tile.NORMAL_DOT_LIGHT).compare(VectorOperators.GT, 0f))
                    .intoArray(t, at + Tile.SPECULAR_WEIGHT);
            tile.onePower.add(at);
            tile.powers[at / Lanes.COUNT] = power;
        }
    }

    /** Reflects the live rays and moves their origins to the plane. */
    public static void leave(Tile tile) {
        float[] t = tile.values;
        for (int k = 0; k < tile.live.count; k++) {
            int at = tile.live.places[k];
            Lanes.load(t, at + Tile.DIRECTION_Y).neg().intoArray(t, at + Tile.DIRECTION_Y);
            Lanes.load(t, at + Tile.POINT_X).intoArray(t, at + Tile.ORIGIN_X);
            Lanes.load(t, at + Tile.POINT_Y).intoArray(t, at + Tile.ORIGIN_Y);
            Lanes.load(t, at + Tile.POINT_Z).intoArray(t, at + Tile.ORIGIN_Z);
            Lanes.all(Layout.PLANE).intoArray(t, at + Tile.LEAVING);
        }
    }
}
