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

/** Closest transmitting sphere, which rays also hit from inside: {@link Intersection#sphereFromInside}. */
public final class TransmittingSphere {
    private TransmittingSphere() {}

    /** Moves transmitting bodies from the candidates to a separate list. */
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

    /** Replaces hits and distances where a transmitting sphere is closer. */
    public static void find(Tile tile, BodyColumns bodies) {
        for (int c = 0; c < tile.transmitting.count; c++) {
            int body = tile.transmitting.bodies[c];
            float radius = bodies.radius[body];
            measure(tile, bodies.x[body], bodies.y[body], bodies.z[body], radius * radius);
            choose(tile, body, radius * radius);
        }
    }

    /** Writes the terms that decide where a sphere is hit. No helpers are called; see {@code ShadowConics}. */
    static void measure(Tile tile, float centerX, float centerY, float centerZ, float radiusSquared) {
        float[] t = tile.values;
        for (int k = 0; k < tile.live.count; k++) {
            int at = tile.live.places[k];
            FloatVector directionX = FloatVector.fromArray(Lanes.FLOATS, t, at + Tile.DIRECTION_X);
            FloatVector directionY = FloatVector.fromArray(Lanes.FLOATS, t, at + Tile.DIRECTION_Y);
            FloatVector directionZ = FloatVector.fromArray(Lanes.FLOATS, t, at + Tile.DIRECTION_Z);
            FloatVector x = FloatVector.broadcast(Lanes.FLOATS, centerX)
                    .sub(FloatVector.fromArray(Lanes.FLOATS, t, at + Tile.ORIGIN_X));
            FloatVector y = FloatVector.broadcast(Lanes.FLOATS, centerY)
                    .sub(FloatVector.fromArray(Lanes.FLOATS, t, at + Tile.ORIGIN_Y));
            FloatVector z = FloatVector.broadcast(Lanes.FLOATS, centerZ)
                    .sub(FloatVector.fromArray(Lanes.FLOATS, t, at + Tile.ORIGIN_Z));
            FloatVector along = x.mul(directionX).add(y.mul(directionY)).add(z.mul(directionZ));
            FloatVector acrossX = x.sub(along.mul(directionX));
            FloatVector acrossY = y.sub(along.mul(directionY));
            FloatVector acrossZ = z.sub(along.mul(directionZ));
            FloatVector across = acrossX.mul(acrossX).add(acrossY.mul(acrossY)).add(acrossZ.mul(acrossZ));
            along.intoArray(t, at + Tile.SPHERE_ALONG);
            FloatVector.broadcast(Lanes.FLOATS, radiusSquared).sub(across).intoArray(t, at + Tile.SPHERE_CHORD);
            x.mul(x).add(y.mul(y)).add(z.mul(z)).intoArray(t, at + Tile.SPHERE_AWAY);
        }
    }

    static void choose(Tile tile, int body, float radiusSquared) {
        float[] t = tile.values;
        for (int k = 0; k < tile.live.count; k++) {
            int at = tile.live.places[k];
            FloatVector along = FloatVector.fromArray(Lanes.FLOATS, t, at + Tile.SPHERE_ALONG);
            FloatVector chord = FloatVector.fromArray(Lanes.FLOATS, t, at + Tile.SPHERE_CHORD)
                    .sqrt();
            VectorMask<Float> other =
                    FloatVector.fromArray(Lanes.FLOATS, t, at + Tile.LEAVING).compare(VectorOperators.NE, body);
            VectorMask<Float> before = along.compare(VectorOperators.GT, 0f)
                    .and(FloatVector.fromArray(Lanes.FLOATS, t, at + Tile.SPHERE_AWAY)
                            .compare(VectorOperators.GT, radiusSquared))
                    .and(other);
            VectorMask<Float> seen = FloatVector.fromArray(Lanes.FLOATS, t, at + Tile.INSIDE)
                    .compare(VectorOperators.GT, 0f)
                    .or(other);
            // Where the line misses the sphere, the root is NaN and fails every comparison.
            FloatVector distance = along.add(chord).blend(along.sub(chord), before);
            FloatVector closest = FloatVector.fromArray(Lanes.FLOATS, t, at + Tile.DISTANCE);
            FloatVector hit = FloatVector.fromArray(Lanes.FLOATS, t, at + Tile.HIT);
            VectorMask<Float> closer = distance.compare(VectorOperators.EQ, closest)
                    .and(hit.compare(VectorOperators.GT, body))
                    .or(distance.compare(VectorOperators.LT, closest))
                    .and(distance.compare(VectorOperators.GT, 0f))
                    .and(seen);
            closest.blend(distance, closer).intoArray(t, at + Tile.DISTANCE);
            hit.blend(body, closer).intoArray(t, at + Tile.HIT);
        }
    }
}
