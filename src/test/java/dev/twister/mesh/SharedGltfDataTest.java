package dev.twister.mesh;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Base64;
import java.util.Collections;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** glTF files whose parts share data, which must not make few bytes take much time and memory. */
class SharedGltfDataTest {
    /** Numbers 0 to 3, then positions as bytes. */
    private static final byte[] DATA = {0, 1, 2, 3, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 0};

    @TempDir
    private Path folder;

    @Test
    void refusesMoreTrianglesThanItsBytesCanHold() {
        Path file = gltf(primitives(0), accessors(1_000_000, 1));

        assertThatThrownBy(() -> MeshReader.read(file, 0, _ -> {}))
                .isInstanceOf(MeshException.class)
                .hasMessageContaining("brings the file to 333333 triangles, too many for its ");
    }

    @Test
    void refusesSparseElementsThatManyAccessorsShare() {
        Path file = gltf(primitives(0, 1, 2, 3, 4), accessors(4, 5));

        assertThatThrownBy(() -> MeshReader.read(file, 0, _ -> {}))
                .isInstanceOf(MeshException.class)
                .hasMessageContaining("$.accessors[4] shares its sparse elements");
    }

    @Test
    void readsAnAccessorOnceForAllPrimitives() {
        Path file = gltf(primitives(0, 0, 0, 0, 0), accessors(4, 1));

        assertThat(MeshReader.read(file, 0, _ -> {}).parts()).hasSize(5);
    }

    private Path gltf(String primitives, String accessors) {
        String data = Base64.getEncoder().encodeToString(DATA);
        try {
            return Files.writeString(
                    folder.resolve("a.gltf"),
                    "{\"asset\":{\"version\":\"2.0\"},\"meshes\":[{\"primitives\":[" + primitives + "]}],"
                            + "\"accessors\":[" + accessors + "],"
                            + "\"bufferViews\":[{\"buffer\":0,\"byteLength\":4},"
                            + "{\"buffer\":0,\"byteOffset\":4,\"byteLength\":12}],"
                            + "\"buffers\":[{\"byteLength\":16,\"uri\":\"data:;base64," + data + "\"}]}");
        } catch (IOException failure) {
            throw new AssertionError(failure);
        }
    }

    private static String primitives(int... accessors) {
        StringBuilder text = new StringBuilder();
        for (int accessor : accessors) {
            text.append(text.isEmpty() ? "" : ",")
                    .append("{\"attributes\":{\"POSITION\":")
                    .append(accessor)
                    .append("}}");
        }
        return text.toString();
    }

    private static String accessors(int elements, int count) {
        return String.join(
                ",",
                Collections.nCopies(
                        count,
                        "{\"componentType\":5120,\"count\":" + elements + ",\"type\":\"VEC3\",\"sparse\":{\"count\":4,"
                                + "\"indices\":{\"bufferView\":0,\"componentType\":5121},"
                                + "\"values\":{\"bufferView\":1}}}"));
    }
}
