package dev.twister.mesh.gltf;

import dev.twister.mesh.input.Bytes;
import dev.twister.mesh.input.MeshLimits;
import dev.twister.mesh.input.QuotedText;
import java.io.IOException;
import java.nio.ByteOrder;
import java.util.Arrays;

/** Elements in a buffer of a glTF file: numbers, or vectors of several numbers. */
final class GltfAccessor {
    private static final int BYTE = 5120;
    private static final int UNSIGNED_BYTE = 5121;
    private static final int SHORT = 5122;
    private static final int UNSIGNED_SHORT = 5123;
    private static final int UNSIGNED_INT = 5125;
    private static final int FLOAT = 5126;

    /** Limit of elements that are 0 except for a sparse part: no buffer's length limits their number. */
    private static final int MAX_ZEROS = 1_000_000;

    private static final GltfBuffers.Range ZEROS = new GltfBuffers.Range(Bytes.of("", new byte[0]), 0, 0);

    private final GltfPlace place;
    private final GltfBuffers.Range range;
    private final int count;
    private final int components;
    private final int componentType;
    private final int componentBytes;
    private final boolean normalized;
    private final int stride;
    private int[] sparseIndices = {};
    private GltfBuffers.Range sparseValues = ZEROS;

    private GltfAccessor(GltfPlace place, GltfBuffers.Range range, int count, int stride) {
        this.place = place;
        this.range = range;
        this.count = count;
        this.components = components(place);
        this.componentType = (int) place.at("componentType").count();
        this.componentBytes = bytesOf(place.at("componentType"));
        this.normalized = place.at("normalized").isTrue();
        this.stride = stride;
    }

    /** Opens an accessor and checks that all of its elements exist. */
    static GltfAccessor open(GltfPlace root, GltfPlace place, GltfBuffers buffers) throws IOException {
        int components = components(place);
        long count = place.at("count").count();
        int elementBytes = components * bytesOf(place.at("componentType"));
        GltfPlace viewIndex = place.at("bufferView");
        GltfAccessor accessor;
        if (viewIndex.exists()) {
            GltfPlace view = viewIndex.in(root.at("bufferViews"));
            long stride = view.at("byteStride").countOr(elementBytes);
            if (stride < elementBytes || stride > 252) {
                throw view.at("byteStride").failure("is " + stride + "; expected " + elementBytes + " to 252");
            }
            GltfBuffers.Range range =
                    part(place, buffers.view(view), place.at("byteOffset"), count, stride, elementBytes);
            accessor = new GltfAccessor(place, range, (int) count, (int) stride);
        } else {
            if (count > MAX_ZEROS) {
                throw place.failure("has " + count + " elements but no bufferView");
            }
            accessor = new GltfAccessor(place, ZEROS, (int) count, elementBytes);
        }
        if (place.at("sparse").exists()) {
            accessor.openSparse(root, place.at("sparse"), elementBytes, buffers);
        }
        return accessor;
    }

    private static GltfBuffers.Range part(
            GltfPlace place, GltfBuffers.Range view, GltfPlace offset, long count, long stride, long elementBytes) {
        long start = offset.countOr(0);
        if (count > MeshLimits.VERTICES) {
            throw place.failure("has " + count + " elements; at most " + MeshLimits.VERTICES + " are read");
        }
        long needed = count == 0 ? 0 : (count - 1) * stride + elementBytes;
        if (start > view.length() || needed > view.length() - start) {
            throw place.failure("needs " + needed + " bytes from byte " + start + " of a buffer view of "
                    + view.length() + " bytes");
        }
        return new GltfBuffers.Range(view.bytes(), view.start() + start, needed);
    }

    private void openSparse(GltfPlace root, GltfPlace sparse, int elementBytes, GltfBuffers buffers)
            throws IOException {
        long changed = sparse.at("count").count();
        if (changed > count) {
            throw sparse.at("count").failure("is " + changed + "; the accessor has " + count + " elements");
        }
        GltfPlace indices = sparse.at("indices");
        int type = (int) indices.at("componentType").count();
        int size = bytesOf(indices.at("componentType"));
        GltfPlace views = root.at("bufferViews");
        GltfBuffers.Range numbers = part(
                indices,
                buffers.view(indices.at("bufferView").in(views)),
                indices.at("byteOffset"),
                changed,
                size,
                size);
        GltfPlace values = sparse.at("values");
        sparseValues = part(
                values,
                buffers.view(values.at("bufferView").in(views)),
                values.at("byteOffset"),
                changed,
                elementBytes,
                elementBytes);
        sparseIndices = new int[(int) changed];
        for (int i = 0; i < sparseIndices.length; i++) {
            double index = component(numbers, (long) i * size, type);
            if (!(index >= (i == 0 ? 0 : sparseIndices[i - 1] + 1.0) && index < count)) {
                throw indices.failure("are not numbers of elements in rising order");
            }
            sparseIndices[i] = (int) index;
        }
    }

    /** Checks the number of components per element. */
    void checkComponents(int required) {
        if (components != required) {
            throw place.at("type")
                    .failure("is " + QuotedText.text(place.at("type").text()) + "; expected one with " + required
                            + " components");
        }
    }

    int count() {
        return count;
    }

    /** The same, which must have an element for each vertex of a primitive. */
    GltfAccessor checked(int vertices) {
        if (count != vertices) {
            throw place.failure("has " + count + " elements, but the primitive has " + vertices + " vertices");
        }
        return this;
    }

    /** Whether an element has four components. */
    boolean hasFourComponents() {
        return components == 4;
    }

    /** Number of elements that its sparse part replaces. */
    int sparseElements() {
        return sparseIndices.length;
    }

    GltfPlace place() {
        return place;
    }

    /** Whether all elements are zero for lack of data. */
    boolean isEmpty() {
        return count > 0 && range.length() == 0 && sparseIndices.length == 0;
    }

    /** A component of an element; normalized integers are converted to [0, 1] or [-1, 1]. */
    double get(int index, int component) throws IOException {
        int sparse = sparseIndices.length == 0 ? -1 : Arrays.binarySearch(sparseIndices, index);
        if (sparse < 0 && range.length() == 0) {
            return 0;
        }
        double value = sparse < 0
                ? component(range, (long) index * stride + (long) component * componentBytes, componentType)
                : component(sparseValues, ((long) sparse * components + component) * componentBytes, componentType);
        return normalized ? normalized(value) : value;
    }

    private double normalized(double value) {
        return switch (componentType) {
            case BYTE -> Math.max(value / 127, -1);
            case UNSIGNED_BYTE -> value / 255;
            case SHORT -> Math.max(value / 32_767, -1);
            case UNSIGNED_SHORT -> value / 65_535;
            default -> value;
        };
    }

    private static double component(GltfBuffers.Range range, long offset, int type) throws IOException {
        Bytes bytes = range.bytes();
        long at = range.start() + offset;
        return switch (type) {
            case BYTE -> (byte) bytes.at(at);
            case UNSIGNED_BYTE -> bytes.at(at);
            case SHORT -> bytes.shortAt(at, ByteOrder.LITTLE_ENDIAN);
            case UNSIGNED_SHORT -> Short.toUnsignedInt(bytes.shortAt(at, ByteOrder.LITTLE_ENDIAN));
            case UNSIGNED_INT -> Integer.toUnsignedLong(bytes.intAt(at, ByteOrder.LITTLE_ENDIAN));
            default -> bytes.floatAt(at, ByteOrder.LITTLE_ENDIAN);
        };
    }

    private static int components(GltfPlace place) {
        String type = place.at("type").text();
        return switch (type) {
            case "SCALAR" -> 1;
            case "VEC2" -> 2;
            case "VEC3" -> 3;
            case "VEC4", "MAT2" -> 4;
            case "MAT3" -> 9;
            case "MAT4" -> 16;
            default ->
                throw place.at("type").failure("is " + QuotedText.text(type) + "; expected SCALAR, VEC2 or VEC3");
        };
    }

    private static int bytesOf(GltfPlace type) {
        return bytesOf(type, type.count());
    }

    private static int bytesOf(GltfPlace place, long type) {
        return switch ((int) Math.min(type, Integer.MAX_VALUE)) {
            case BYTE, UNSIGNED_BYTE -> 1;
            case SHORT, UNSIGNED_SHORT -> 2;
            case UNSIGNED_INT, FLOAT -> 4;
            default -> throw place.failure("is " + type + "; expected 5120, 5121, 5122, 5123, 5125 or 5126");
        };
    }
}
