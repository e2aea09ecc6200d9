package dev.twister.engine.vector.step;

import dev.twister.engine.vector.frame.BodyColumns;
import dev.twister.engine.vector.lanes.BodyList;
import dev.twister.engine.vector.lanes.Lanes;
import dev.twister.engine.vector.lanes.Tile;
import dev.twister.kernel.Intersection;
import dev.twister.kernel.Layout;
import jdk.incubator.vector.FloatVector;
import jdk.incubator.vector.VectorMask;
import jdk.incubator.vector.VectorOperators;

/** Closest sphere or light per ray: {@link Intersection#sphere}. */
public final class NearestSphere {
    private NearestSphere() {}

    /**
     * Writes the bodies hit and their distances. {@code candidates} lists all bodies that can be hit, in ascending
     * order. The closest hit stays in memory between candidates, because as a variable carried through the loop it
     * becomes an object in some runs of the JVM. No helpers are called; see {@code ShadowConics}.
     */
    public static void find(Tile tile, BodyColumns bodies, BodyList candidates) {
        float[] t = tile.values;
        for (int k = 0; k < tile.live.count; k++) {
            int at = tile.live.places[k];
            FloatVector.broadcast(Lanes.FLOATS, Intersection.MISS).intoArray(t, at + Tile.DISTANCE);
            FloatVector.broadcast(Lanes.FLOATS, Layout.NOTHING).intoArray(t, at + Tile.HIT);
        }
        for (int c = 0; c < candidates.count; c++) {
            int body = candidates.bodies[c];
            float centerX = bodies.x[body];
            float centerY = bodies.y[body];
            float centerZ = bodies.z[body];
            float radius = bodies.radius[body];
            for (int k = 0; k < tile.live.count; k++) {
                int at = tile.live.places[k];
                FloatVector directionX = FloatVector.fromArray(Lanes.FLOATS, t, at + Tile.DIRECTION_X);
                FloatVector directionY = FloatVector.fromArray(Lanes.FLOATS, t, at + Tile.DIRECTION_Y);
                FloatVector directionZ = FloatVector.fromArray(Lanes.FLOATS, t, at + Tile.DIRECTION_Z);
                FloatVector originX = FloatVector.fromArray(Lanes.FLOATS, t, at + Tile.ORIGIN_X);
                FloatVector originY = FloatVector.fromArray(Lanes.FLOATS, t, at + Tile.ORIGIN_Y);
                FloatVector originZ = FloatVector.fromArray(Lanes.FLOATS, t, at + Tile.ORIGIN_Z);
                FloatVector x = FloatVector.broadcast(Lanes.FLOATS, centerX).sub(originX);
                FloatVector y = FloatVector.broadcast(Lanes.FLOATS, centerY).sub(originY);
                FloatVector z = FloatVector.broadcast(Lanes.FLOATS, centerZ).sub(originZ);
                FloatVector along = x.mul(directionX).add(y.mul(directionY)).add(z.mul(directionZ));
                FloatVector acrossX = x.sub(along.mul(directionX));
                FloatVector acrossY = y.sub(along.mul(directionY));
                FloatVector acrossZ = z.sub(along.mul(directionZ));
                FloatVector across =
                        acrossX.mul(acrossX).add(acrossY.mul(acrossY)).add(acrossZ.mul(acrossZ));
                FloatVector inside =
                        FloatVector.broadcast(Lanes.FLOATS, radius * radius).sub(across);
                FloatVector near = along.sub(inside.sqrt());
                FloatVector leaving = FloatVector.fromArray(Lanes.FLOATS, t, at + Tile.LEAVING);
                FloatVector closest = FloatVector.fromArray(Lanes.FLOATS, t, at + Tile.DISTANCE);
                FloatVector hit = FloatVector.fromArray(Lanes.FLOATS, t, at + Tile.HIT);
                VectorMask<Float> closer = near.compare(VectorOperators.GT, 0f)
                        .and(near.compare(VectorOperators.LT, closest))
                        .and(leaving.compare(VectorOperators.NE, body));
                closest.blend(near, closer).intoArray(t, at + Tile.DISTANCE);
                hit.blend(body, closer).intoArray(t, at + Tile.HIT);
            }
        }
    }
}
