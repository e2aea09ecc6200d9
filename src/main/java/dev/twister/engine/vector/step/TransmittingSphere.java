package dev.twister.engine.vector.step;

import dev.twister.engine.vector.frame.BodyColumns;
import dev.twister.engine.vector.frame.Looks;
import dev.twister.engine.vector.lanes.BodyList;
import dev.twister.engine.vector.lanes.Lanes;
import dev.twister.engine.vector.lanes.Tile;
import dev.twister.kernel.Intersection;
import jdk.incubator.vector.FloatVector;
import jdk.incubator.vector.VectorMask;
import jdk.incubator.vector.VectorOperators;

/** Whether a sphere that transmits is met before others, which is seen from inside too: {@link Intersection#sphereFromInside}. */
public final class TransmittingSphere {
    private TransmittingSphere() {}

    /** Moves the bodies that transmit from the candidates to a list of their own. */
    public static void tellApart(Tile tile, Looks looks) {
        BodyList candidates = tile.candidates;
        int opaque = 0;
        tile.transmitting.clear();
        for (int k = 0; k < candidates.count; k++) {
            int body = candidates.bodies[k];
            if (looks.transmits(body)) {
                tile.transmitting.add(body);
            } else {
                candidates.bodies[opaque] = body;
                opaque++;
            }
        }
        candidates.count = opaque;
    }

    /** Mends the hits and distances where one is closer. */
    public static void find(Tile tile, BodyColumns bodies) {
        for (int c = 0; c < tile.transmitting.count; c++) {
            int body = tile.transmitting.bodies[c];
            find(tile, body, bodies.x[body], bodies.y[body], bodies.z[body], bodies.radius[body]);
        }
    }

    static void find(Tile tile, int body, float centerX, float centerY, float centerZ, float radius) {
        float[] t = tile.values;
        float radiusSquared = radius * radius;
        for (int k = 0; k < tile.live.count; k++) {
            int at = tile.live.places[k];
            FloatVector directionX = Lanes.load(t, at + Tile.DIRECTION_X);
            FloatVector directionY = Lanes.load(t, at + Tile.DIRECTION_Y);
            FloatVector directionZ = Lanes.load(t, at + Tile.DIRECTION_Z);
            FloatVector x = Lanes.all(centerX).sub(Lanes.load(t, at + Tile.ORIGIN_X));
            FloatVector y = Lanes.all(centerY).sub(Lanes.load(t, at + Tile.ORIGIN_Y));
            FloatVector z = Lanes.all(centerZ).sub(Lanes.load(t, at + Tile.ORIGIN_Z));
            FloatVector along = x.mul(directionX).add(y.mul(directionY)).add(z.mul(directionZ));
            FloatVector acrossX = x.sub(along.mul(directionX));
            FloatVector acrossY = y.sub(along.mul(directionY));
            FloatVector acrossZ = z.sub(along.mul(directionZ));
            FloatVector across = acrossX.mul(acrossX).add(acrossY.mul(acrossY)).add(acrossZ.mul(acrossZ));
            FloatVector half = Lanes.all(radiusSquared).sub(across);
            FloatVector chord = Lanes.larger(half, Lanes.all(0f)).sqrt();
            VectorMask<Float> own = Lanes.load(t, at + Tile.LEAVING).compare(VectorOperators.EQ, body);
            VectorMask<Float> passedBy = own.and(Lanes.load(t, at + Tile.INSIDE).compare(VectorOperators.LE, 0f));
            VectorMask<Float> before = along.compare(VectorOperators.GT, 0f)
                    .and(x.mul(x).add(y.mul(y)).add(z.mul(z)).compare(VectorOperators.GT, radiusSquared))
                    .andNot(own);
            FloatVector near = Lanes.larger(along.sub(chord), Lanes.all(0f));
            FloatVector far = along.add(chord);
            FloatVector distance = far.blend(near, before);
            VectorMask<Float> met = half.compare(VectorOperators.GE, 0f)
                    .and(before.or(far.compare(VectorOperators.GT, 0f)))
                    .andNot(passedBy);
            FloatVector closest = Lanes.load(t, at + Tile.DISTANCE);
            FloatVector hit = Lanes.load(t, at + Tile.HIT);
            VectorMask<Float> closer = distance.compare(VectorOperators.EQ, closest)
                    .and(hit.compare(VectorOperators.GT, body))
                    .or(distance.compare(VectorOperators.LT, closest))
                    .and(met);
            closest.blend(distance, closer).intoArray(t, at + Tile.DISTANCE);
            hit.blend(body, closer).intoArray(t, at + Tile.HIT);
        }
    }
}
