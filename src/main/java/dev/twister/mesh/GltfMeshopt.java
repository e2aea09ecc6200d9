package dev.twister.mesh;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.List;
import java.util.Optional;

/** Buffer views that {@code EXT_meshopt_compression}, or its successor, compresses. */
final class GltfMeshopt {
    private static final List<String> EXTENSIONS = List.of("EXT_meshopt_compression", "KHR_meshopt_compression");

    /** More is never in a compressed byte: 256 elements of 4 bytes. */
    private static final long MOST_PER_BYTE = 1024;

    private static final int LONGEST_ELEMENT = 256;

    private GltfMeshopt() {}

    /** What says how a buffer view is compressed. */
    static Optional<GltfPlace> of(GltfPlace view) {
        return EXTENSIONS.stream()
                .map(name -> view.at("extensions").at(name))
                .filter(GltfPlace::exists)
                .findFirst();
    }

    /** The bytes of the whole view. */
    static byte[] decode(GltfPlace place, byte[] compressed) {
        long count = place.at("count").count();
        long stride = place.at("byteStride").count();
        if (stride < 1 || stride > LONGEST_ELEMENT) {
            throw place.at("byteStride").failure("is " + stride + "; expected 1 to " + LONGEST_ELEMENT);
        }
        if (count > MeshLimits.VERTICES || count * stride > MOST_PER_BYTE * compressed.length) {
            throw place.at("count").failure("is " + count + ", too many for " + compressed.length + " bytes");
        }
        try {
            return decode(place, compressed, (int) count, (int) stride);
        } catch (IndexOutOfBoundsException damaged) {
            throw new MeshException(
                    place.failure("is damaged; export the file again").getMessage(), damaged);
        }
    }

    private static byte[] decode(GltfPlace place, byte[] compressed, int count, int stride) {
        String mode = place.at("mode").text();
        return switch (mode) {
            case "ATTRIBUTES" -> attributes(place, compressed, count, stride);
            case "TRIANGLES" -> numbers(place, MeshoptIndices.triangles(compressed, count), stride);
            case "INDICES" -> numbers(place, MeshoptIndices.sequence(compressed, count), stride);
            default ->
                throw place.at("mode")
                        .failure("is " + Shown.text(mode) + "; expected ATTRIBUTES, TRIANGLES or INDICES");
        };
    }

    private static byte[] attributes(GltfPlace place, byte[] compressed, int count, int stride) {
        String filter = place.at("filter").textOr("NONE");
        boolean fits = switch (filter) {
            case "OCTAHEDRAL", "COLOR" -> stride == 4 || stride == 8;
            case "QUATERNION" -> stride == 8;
            default -> stride % 4 == 0;
        };
        if (!fits) {
            throw place.at("byteStride").failure("is " + stride + ", which " + Shown.text(filter) + " cannot have");
        }
        byte[] elements = MeshoptVertices.decode(compressed, count, stride);
        switch (filter) {
            case "NONE" -> {}
            case "OCTAHEDRAL" -> MeshoptFilter.octahedral(elements, stride);
            case "QUATERNION" -> MeshoptFilter.quaternion(elements);
            case "EXPONENTIAL" -> MeshoptFilter.exponential(elements);
            case "COLOR" -> MeshoptFilter.color(elements, stride);
            default ->
                throw place.at("filter")
                        .failure("is " + Shown.text(filter)
                                + "; expected NONE, OCTAHEDRAL, QUATERNION, EXPONENTIAL or COLOR");
        }
        return elements;
    }

    private static byte[] numbers(GltfPlace place, int[] numbers, int stride) {
        if (stride != Short.BYTES && stride != Integer.BYTES) {
            throw place.at("byteStride").failure("is " + stride + "; expected 2 or 4 for indices");
        }
        ByteBuffer bytes = ByteBuffer.allocate(stride * numbers.length).order(ByteOrder.LITTLE_ENDIAN);
        for (int number : numbers) {
            if (stride == Short.BYTES) {
                bytes.putShort((short) number);
            } else {
                bytes.putInt(number);
            }
        }
        return bytes.array();
    }
}
