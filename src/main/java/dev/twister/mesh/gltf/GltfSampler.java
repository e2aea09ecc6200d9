package dev.twister.mesh.gltf;

import dev.twister.mesh.input.QuotedText;
import java.io.IOException;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/**
 * The values of a property of a node at times.
 *
 * @param times of the keys, in rising order, in seconds
 * @param values of each key; of a cubic spline its tangent before, its value and its tangent after
 * @param components numbers of a value; 4 for a rotation, which is a quaternion
 */
@SuppressWarnings("ArrayRecordComponent") // shared by samplers, never compared
record GltfSampler(Interpolation interpolation, float[] times, float[] values, int components, boolean isRotation) {
    /** How it goes from key to key. */
    private enum Interpolation {
        STEP,
        LINEAR,
        CUBICSPLINE
    }

    /** Above this cosine of the angle between quaternions, they are mixed along a line. */
    private static final double NEAR = 1 - 1e-9;

    /** The numbers of accessors, each read once. */
    static final class Values {
        private final GltfAccessors accessors;
        private final Map<List<Integer>, float[]> read = new HashMap<>();

        Values(GltfAccessors accessors) {
            this.accessors = accessors;
        }

        /** All numbers of an accessor with that many components. */
        private float[] of(GltfPlace number, int components) throws IOException {
            GltfAccessor accessor = accessors.at(number, components);
            List<Integer> key = List.of(number.index(accessors.list()), components);
            float[] known = read.get(key);
            if (known == null) {
                accessors.share((long) accessor.count() * components, number);
                known = new float[accessor.count() * components];
                for (int i = 0; i < known.length; i++) {
                    known[i] = (float) accessor.get(i / components, i % components);
                    if (!Float.isFinite(known[i])) {
                        throw accessor.place().failure("has " + known[i] + " at element " + i / components);
                    }
                }
                read.put(key, known);
            }
            return known;
        }
    }

    /**
     * Reads a sampler.
     *
     * @param components of a value
     * @param elements components of an element of the values' accessor: 1 for weights
     */
    static GltfSampler of(GltfPlace sampler, int components, int elements, Values all) throws IOException {
        String name = sampler.at("interpolation").textOr(Interpolation.LINEAR.name());
        Interpolation interpolation = Arrays.stream(Interpolation.values())
                .filter(each -> each.name().equals(name))
                .findFirst()
                .orElseThrow(() -> sampler.at("interpolation")
                        .failure("is " + QuotedText.text(name) + "; expected LINEAR, STEP or CUBICSPLINE"));
        float[] times = all.of(sampler.at("input"), 1);
        if (times.length == 0) {
            throw sampler.at("input").failure("has no keys");
        }
        for (int key = 0; key < times.length; key++) {
            if (key > 0 && times[key] < times[key - 1]) {
                throw sampler.at("input")
                        .failure("has the time " + times[key] + " at key " + key + ", after " + times[key - 1]
                                + "; times must rise");
            }
        }
        float[] values = all.of(sampler.at("output"), elements);
        long needed = (long) times.length * components * (interpolation == Interpolation.CUBICSPLINE ? 3 : 1);
        if (values.length != needed) {
            throw sampler.at("output")
                    .failure(
                            "has " + values.length + " numbers; expected " + needed + " for " + times.length + " keys");
        }
        return new GltfSampler(interpolation, times, values, components, elements == 4);
    }

    /** The time of the last key, at least 0. */
    double seconds() {
        return Math.max(0, times[times.length - 1]);
    }

    /**
     * Writes the value at a time, {@link #components} numbers; before the first and after the last key it is theirs.
     */
    void write(double seconds, double[] to, int at) {
        int found = Arrays.binarySearch(times, (float) seconds);
        int key = Math.clamp(found < 0 ? -found - 2 : found, 0, times.length - 1);
        while (key + 1 < times.length && times[key + 1] <= seconds) {
            key++;
        }
        while (key > 0 && times[key] > seconds) {
            key--;
        }
        if (seconds <= times[0] || key == times.length - 1 || interpolation == Interpolation.STEP) {
            for (int i = 0; i < components; i++) {
                to[at + i] = values[place(key) + i];
            }
        } else {
            double length = (double) times[key + 1] - times[key];
            double part = (seconds - times[key]) / length;
            if (interpolation == Interpolation.CUBICSPLINE) {
                writeSpline(key, part, length, to, at);
            } else {
                writeLine(key, part, to, at);
            }
        }
    }

    private int place(int key) {
        return interpolation == Interpolation.CUBICSPLINE ? components * (3 * key + 1) : components * key;
    }

    private void writeSpline(int key, double part, double length, double[] to, int at) {
        double left = 1 - part;
        for (int i = 0; i < components; i++) {
            int from = place(key) + i;
            int next = place(key + 1) + i;
            to[at + i] = left * left * (1 + 2 * part) * values[from]
                    + part * left * left * length * values[from + components]
                    + part * part * (3 - 2 * part) * values[next]
                    - part * part * left * length * values[next - components];
        }
    }

    private void writeLine(int key, double part, double[] to, int at) {
        int from = place(key);
        int next = place(key + 1);
        double first = 1 - part;
        double second = part;
        if (isRotation) {
            double cosine = 0;
            for (int i = 0; i < components; i++) {
                cosine += (double) values[from + i] * values[next + i];
            }
            double angle = Math.acos(Math.min(1, Math.abs(cosine)));
            boolean apart = Math.abs(cosine) < NEAR;
            first = apart ? Math.sin((1 - part) * angle) / Math.sin(angle) : first;
            second = apart ? Math.sin(part * angle) / Math.sin(angle) : second;
            // The shorter way around.
            second = cosine < 0 ? -second : second;
        }
        for (int i = 0; i < components; i++) {
            to[at + i] = first * values[from + i] + second * values[next + i];
        }
    }
}
