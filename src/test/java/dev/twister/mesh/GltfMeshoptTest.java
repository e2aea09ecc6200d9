package dev.twister.mesh;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.io.InputStream;
import java.util.Arrays;
import java.util.Base64;
import java.util.List;
import java.util.Random;
import java.util.stream.StreamSupport;
import java.util.zip.CRC32;
import org.assertj.core.api.ThrowableAssert.ThrowingCallable;
import org.junit.jupiter.api.Named;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;
import tools.jackson.databind.node.JsonNodeFactory;
import tools.jackson.databind.node.ObjectNode;

/** What meshoptimizer 1.3 encoded, and what its own decoder made of it. */
class GltfMeshoptTest {
    static List<Named<JsonNode>> encoded() throws IOException {
        try (InputStream file = GltfMeshoptTest.class.getResourceAsStream("/meshopt/encoded.json")) {
            return StreamSupport.stream(JsonMapper.shared().readTree(file).spliterator(), false)
                    .map(sample -> Named.of(sample.get("name").asString(), sample))
                    .toList();
        }
    }

    @ParameterizedTest
    @MethodSource("encoded")
    void isDecoded(JsonNode sample) {
        byte[] elements = GltfMeshopt.decode(place(sample), bytes(sample, "source"));

        if (sample.has("elements")) {
            assertThat(elements).isEqualTo(bytes(sample, "elements"));
        } else {
            CRC32 checksum = new CRC32();
            checksum.update(elements);
            assertThat(checksum.getValue()).isEqualTo(sample.get("checksum").asLong());
        }
    }

    @ParameterizedTest
    @MethodSource("encoded")
    void damageIsNamed(JsonNode sample) {
        Random random = new Random(1);
        byte[] source = bytes(sample, "source");
        for (int turn = 0; turn < 200; turn++) {
            byte[] damaged = Arrays.copyOf(source, random.nextInt(source.length));
            if (damaged.length > 0) {
                int place = random.nextInt(damaged.length);
                damaged[place] = (byte) (damaged[place] + 1 + random.nextInt(200));
            }
            assertMeshExceptionAtMost(() -> GltfMeshopt.decode(place(sample), damaged));
        }
    }

    @Test
    void aCountBeyondTheBytesIsRefused() {
        ObjectNode sample = JsonNodeFactory.instance
                .objectNode()
                .put("mode", "ATTRIBUTES")
                .put("count", 40_000_000)
                .put("byteStride", 16);

        assertThatThrownBy(() -> GltfMeshopt.decode(GltfPlace.root("a.glb", sample), new byte[100]))
                .isInstanceOf(MeshException.class)
                .hasMessageContaining("is 40000000, too many for 100 bytes");
    }

    @Test
    void indicesOfAnotherSizeAreRefused() {
        JsonNode triangles = JsonNodeFactory.instance
                .objectNode()
                .put("mode", "TRIANGLES")
                .put("count", 0)
                .put("byteStride", 3);
        byte[] none = new byte[17];
        none[0] = (byte) 0xe1;

        assertThatThrownBy(() -> GltfMeshopt.decode(GltfPlace.root("a.glb", triangles), none))
                .isInstanceOf(MeshException.class)
                .hasMessageContaining("byteStride")
                .hasMessageContaining("is 3; expected 2 or 4 for indices");
    }

    private static void assertMeshExceptionAtMost(ThrowingCallable decoding) {
        try {
            decoding.call();
        } catch (MeshException refused) {
            assertThat(refused).hasMessageContaining("a.glb");
        } catch (Throwable other) {
            throw new AssertionError(other);
        }
    }

    private static GltfPlace place(JsonNode sample) {
        ObjectNode view = (ObjectNode) sample.deepCopy();
        view.set("byteStride", sample.get("stride"));
        return GltfPlace.root("a.glb", view);
    }

    private static byte[] bytes(JsonNode sample, String field) {
        return Base64.getDecoder().decode(sample.get(field).asString());
    }
}
