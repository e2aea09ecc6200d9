package dev.twister.engine.vector;

import dev.twister.kernel.Intersection;
import dev.twister.kernel.Layout;
import jdk.incubator.vector.FloatVector;
import jdk.incubator.vector.VectorMask;
import jdk.incubator.vector.VectorOperators;

/** Which sphere, or the light, each ray meets first: {@link Intersection#sphere}. */
final class NearestSphere {
    private NearestSphere() {}

    /** Writes the bodies met and their distances; {@code candidates} are all that could be met, in ascending order. */
    static void find(Tile tile, BodyColumns bodies, BodyList candidates) {
        float[] t = tile.values;
        for (int k = 0; k < tile.live.count; k++) {
            int at = tile.live.places[k];
            FloatVector leaving = Lanes.load(t, at + Tile.LEAVING);
            FloatVector closest = Lanes.all(Intersection.MISS);
            FloatVector hit = Lanes.all(Layout.NOTHING);
            for (int c = 0; c < candidates.count; c++) {
                int body = candidates.bodies[c];
                FloatVector near = near(t, at, bodies.x[body], bodies.y[body], bodies.z[body], bodies.radius[body]);
                VectorMask<Float> closer = near.compare(VectorOperators.GT, 0f)
                        .and(near.compare(VectorOperators.LT, closest))
                        .and(leaving.compare(VectorOperators.NE, body));
                closest = closest.blend(near, closer);
                hit = hit.blend(body, closer);
            }
            closest.intoArray(t, at + Tile.DISTANCE);
            hit.intoArray(t, at + Tile.HIT);
        }
    }

    /** Distance to the near root, of either sign; not a number where the ray's line passes the sphere. */
    static FloatVector near(float[] t, int at, float centerX, float centerY, float centerZ, float radius) {
        FloatVector directionX = Lanes.load(t, at + Tile.DIRECTION_X);
        FloatVector directionY = Lanes.load(t, at + Tile.DIRECTION_Y);
        FloatVector directionZ = Lanes.load(t, at + Tile.DIRECTION_Z);
        FloatVector x = Lanes.all(centerX).sub(Lanes.load(t, at + Tile.ORIGIN_X));
        FloatVector y = Lanes.all(centerY).sub(Lanes.load(t, at + Tile.ORIGIN_Y));
        FloatVector z = Lanes.all(centerZ).sub(Lanes.load(t, at + Tile.ORIGIN_Z));
        FloatVector along = x.fma(directionX, y.fma(directionY, z.mul(directionZ)));
        FloatVector acrossX = x.sub(along.mul(directionX));
        FloatVector acrossY = y.sub(along.mul(directionY));
        FloatVector acrossZ = z.sub(along.mul(directionZ));
        FloatVector acrossSquared = acrossX.fma(acrossX, acrossY.fma(acrossY, acrossZ.mul(acrossZ)));
        return along.sub(Lanes.all(radius * radius).sub(acrossSquared).sqrt());
    }
}
