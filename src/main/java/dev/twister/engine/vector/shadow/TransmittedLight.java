package dev.twister.engine.vector.shadow;

import dev.twister.engine.vector.frame.BodyColumns;
import dev.twister.engine.vector.frame.Drawing;
import dev.twister.engine.vector.frame.Looks;
import dev.twister.engine.vector.lanes.BodyList;
import dev.twister.engine.vector.lanes.Lanes;
import dev.twister.engine.vector.lanes.ShadowColumns;
import dev.twister.engine.vector.lanes.Tile;
import dev.twister.kernel.Shadow;
import java.util.Arrays;
import jdk.incubator.vector.FloatVector;
import jdk.incubator.vector.VectorMask;
import jdk.incubator.vector.VectorOperators;

/** The visible part of the light behind transmitting spheres, ray by ray: {@link Shadow}. */
final class TransmittedLight {
    private TransmittedLight() {}

    /** Whether any sphere between the tile's points and the light transmits. */
    static boolean isAny(ShadowColumns scratch, Looks looks) {
        BodyList candidates = scratch.tileCandidates;
        boolean any = false;
        for (int c = 0; c < candidates.count; c++) {
            any |= looks.transmits(candidates.bodies[c]);
        }
        return any;
    }

    /** Writes the visible parts of the packet's open lanes. */
    static void find(Tile tile, int at, Drawing drawing, ShadowColumns scratch) {
        scratch.startPacket();
        BodyList candidates = scratch.tileCandidates;
        for (int c = 0; c < candidates.count; c++) {
            int body = candidates.bodies[c];
            long between =
                    ShadowCandidates.between(tile.values, at, drawing.bodies, body) & ShadowCandidates.open(tile, at);
            if (between != 0L) {
                scratch.add(body, between, 0L);
            }
        }
        if (scratch.touched != 0L) {
            ShadowFrame.findAxes(tile, at, drawing, scratch);
            ShadowFrame.placeAll(tile, at, drawing.bodies, scratch);
            limitAll(tile, at, drawing, scratch);
            average(tile, at, drawing, scratch);
        }
    }

    /** Writes the squared radii, negative in lanes that the sphere cannot shade. */
    private static void limitAll(Tile tile, int at, Drawing drawing, ShadowColumns scratch) {
        BodyColumns bodies = drawing.bodies;
        BodyList found = scratch.candidates;
        for (int c = 0; c < found.count; c++) {
            int body = found.bodies[c];
            boolean seenFromInside = drawing.looks.transmits(body);
            limit(tile, at, body, bodies.sphereRadius(body), seenFromInside, scratch.facts, c * ShadowColumns.STRIDE);
        }
    }

    private static void limit(
            Tile tile, int at, int body, float radius, boolean seenFromInside, float[] facts, int to) {
        float[] t = tile.values;
        FloatVector along = Lanes.load(facts, to + ShadowColumns.ALONG);
        FloatVector u = Lanes.load(facts, to + ShadowColumns.ACROSS_U);
        FloatVector w = Lanes.load(facts, to + ShadowColumns.ACROSS_W);
        FloatVector distance = Lanes.load(t, at + Tile.LIGHT_DISTANCE);
        float radiusSquared = radius * radius;
        float nearest = seenFromInside ? -1f : radiusSquared;
        VectorMask<Float> shades = along.compare(VectorOperators.GT, -radius)
                .and(along.sub(radius).compare(VectorOperators.LT, distance.mul(Shadow.RELATIVE_MARGIN)))
                .and(Lanes.fma(along, along, Lanes.fma(u, u, w.mul(w))).compare(VectorOperators.GT, nearest))
                .and(Lanes.load(t, at + Tile.HIT).compare(VectorOperators.NE, body))
                .and(Lanes.load(t, at + Tile.SHADOW_OPEN).compare(VectorOperators.GT, 0f));
        Lanes.all(-1f).blend(radiusSquared, shades).intoArray(facts, to + ShadowColumns.RADIUS_SQUARED);
    }

    /** Writes the mean over the samples of the product of all candidates' transmissions. */
    private static void average(Tile tile, int at, Drawing drawing, ShadowColumns scratch) {
        int samples = drawing.shadowSamples;
        scratch.reserveConics(samples);
        Arrays.fill(scratch.conics, Lanes.BORDER, Lanes.BORDER + samples * Lanes.COUNT, 1f);
        for (int c = 0; c < scratch.candidates.count; c++) {
            float transmission = drawing.looks.transmission(scratch.candidates.bodies[c]);
            dim(tile, at, scratch, c * ShadowColumns.STRIDE, transmission, drawing.disc, samples);
        }
        add(tile, at, scratch, samples);
    }

    /** Multiplies the light of the samples that the candidate blocks by its transmission. */
    static void dim(Tile tile, int at, ShadowColumns scratch, int from, float transmission, float[] disc, int samples) {
        float[] facts = scratch.facts;
        float[] light = scratch.conics;
        FloatVector distance = Lanes.load(tile.values, at + Tile.LIGHT_DISTANCE);
        FloatVector scale = Lanes.load(scratch.frame, ShadowColumns.SCALE);
        FloatVector a = Lanes.load(facts, from + ShadowColumns.ALONG);
        FloatVector u = Lanes.load(facts, from + ShadowColumns.ACROSS_U);
        FloatVector w = Lanes.load(facts, from + ShadowColumns.ACROSS_W);
        FloatVector radiusSquared = Lanes.load(facts, from + ShadowColumns.RADIUS_SQUARED);
        FloatVector beyondA = distance.sub(a);
        FloatVector center = Lanes.fma(a, a, Lanes.fma(u, u, w.mul(w)));
        for (int sample = 0; sample < samples; sample++) {
            FloatVector x = scale.mul(disc[2 * sample]);
            FloatVector y = scale.mul(disc[2 * sample + 1]);
            FloatVector lengthSquared = Lanes.fma(x, x, Lanes.fma(y, y, Lanes.all(1f)));
            FloatVector p = u.sub(a.mul(x));
            FloatVector q = w.sub(a.mul(y));
            FloatVector moment = p.mul(y).sub(q.mul(x));
            FloatVector beyondU = distance.mul(x).sub(u);
            FloatVector beyondW = distance.mul(y).sub(w);
            FloatVector along = Lanes.fma(x, u, Lanes.fma(y, w, a));
            FloatVector beyond = Lanes.fma(beyondA, beyondA, Lanes.fma(beyondU, beyondU, beyondW.mul(beyondW)));
            VectorMask<Float> before = along.compare(VectorOperators.LT, distance.mul(lengthSquared))
                    .or(beyond.compare(VectorOperators.LT, radiusSquared))
                    .and(along.compare(VectorOperators.GT, 0f));
            VectorMask<Float> blocks = before.and(center.compare(VectorOperators.GT, radiusSquared))
                    .or(beyond.compare(VectorOperators.GE, radiusSquared)
                            .and(center.compare(VectorOperators.LE, radiusSquared)))
                    .and(Lanes.fma(moment, moment, Lanes.fma(p, p, q.mul(q)))
                            .compare(VectorOperators.LE, radiusSquared.mul(lengthSquared)));
            FloatVector lit = Lanes.load(light, Lanes.BORDER + sample * Lanes.COUNT);
            lit.blend(lit.mul(transmission), blocks).intoArray(light, Lanes.BORDER + sample * Lanes.COUNT);
        }
    }

    /** Writes the mean of the samples' light as the visible parts of the open lanes. */
    static void add(Tile tile, int at, ShadowColumns scratch, int samples) {
        float[] t = tile.values;
        float[] light = scratch.conics;
        FloatVector blocked = FloatVector.zero(Lanes.FLOATS);
        for (int sample = 0; sample < samples; sample++) {
            blocked = blocked.add(Lanes.all(1f).sub(Lanes.load(light, Lanes.BORDER + sample * Lanes.COUNT)));
        }
        FloatVector visible = Lanes.all(1f).sub(blocked.div(samples));
        Lanes.load(t, at + Tile.VISIBLE)
                .blend(visible, Lanes.load(t, at + Tile.SHADOW_OPEN).compare(VectorOperators.GT, 0f))
                .intoArray(t, at + Tile.VISIBLE);
    }
}
