package dev.twister.mesh.gltf;

import dev.twister.mesh.MeshException;
import java.util.ArrayList;
import java.util.List;
import tools.jackson.databind.JsonNode;

/** A value in a glTF file's JSON, possibly missing, with its path for messages. */
public final class GltfPlace {
    private final String file;
    private final String path;
    private final JsonNode node;

    private GltfPlace(String file, String path, JsonNode node) {
        this.file = file;
        this.path = path;
        this.node = node;
    }

    static GltfPlace root(String file, JsonNode node) {
        return new GltfPlace(file, "$", node);
    }

    /** The names of an object's fields. */
    List<String> names() {
        return List.copyOf(node.propertyNames());
    }

    GltfPlace at(String name) {
        if (exists() && !node.isObject()) {
            throw failure("is no object");
        }
        return new GltfPlace(file, path + "." + name, node.path(name));
    }

    GltfPlace at(int index) {
        return new GltfPlace(file, path + "[" + index + "]", node.path(index));
    }

    boolean exists() {
        return !node.isMissingNode() && !node.isNull();
    }

    /** Number of items of an array; 0 if it is missing. */
    int size() {
        if (exists() && !node.isArray()) {
            throw failure("is no array");
        }
        return node.size();
    }

    List<GltfPlace> items() {
        List<GltfPlace> items = new ArrayList<>();
        for (int i = 0; i < size(); i++) {
            items.add(at(i));
        }
        return items;
    }

    /** The item of a list with this value as its index. */
    GltfPlace in(GltfPlace list) {
        return list.at(index(list));
    }

    /** This value as an index into a list. */
    int index(GltfPlace list) {
        long index = integer();
        if (index < 0 || index >= list.size()) {
            throw failure("is " + index + "; " + list.path + " has " + list.size() + " items, counted from 0");
        }
        return (int) index;
    }

    /** Whether this value is an index into a list. */
    boolean isIndex(GltfPlace list) {
        return node.isInt() && node.intValue() >= 0 && node.intValue() < list.size();
    }

    /** An integer in [0, 2^53]. */
    long count() {
        long count = integer();
        if (count < 0) {
            throw failure("is " + count + "; expected 0 or more");
        }
        return count;
    }

    long countOr(long fallback) {
        return exists() ? count() : fallback;
    }

    private long integer() {
        double value = number();
        if (value != Math.rint(value) || Math.abs(value) > 0x1p53) {
            throw failure("is " + value + "; expected a whole number");
        }
        return (long) value;
    }

    double number() {
        if (!exists()) {
            throw failure("is missing");
        }
        if (!node.isInt() && !node.isLong() && !node.isDouble()) {
            throw failure("is no number, or too large");
        }
        double value = node.doubleValue();
        if (!Double.isFinite(value)) {
            throw failure("is no finite number");
        }
        return value;
    }

    double numberOr(double fallback) {
        return exists() ? number() : fallback;
    }

    /** A number clamped to [0, 1]. */
    double unitOr(double fallback) {
        return Math.clamp(numberOr(fallback), 0.0, 1.0);
    }

    /** The numbers of an array with the length of the fallback, which is used if the array is missing. */
    double[] numbersOr(double... fallback) {
        if (!exists()) {
            return fallback;
        }
        if (size() != fallback.length) {
            throw failure("has " + size() + " items; expected " + fallback.length);
        }
        double[] numbers = new double[fallback.length];
        for (int i = 0; i < numbers.length; i++) {
            numbers[i] = at(i).number();
        }
        return numbers;
    }

    boolean isTrue() {
        return node.isBoolean() && node.booleanValue();
    }

    String text() {
        if (!node.isString()) {
            throw failure(exists() ? "is no string" : "is missing");
        }
        return node.stringValue();
    }

    String textOr(String fallback) {
        return exists() ? text() : fallback;
    }

    MeshException failure(String problem) {
        return new MeshException(file + ": " + path + " " + problem);
    }

    @Override
    public String toString() {
        return path;
    }
}
