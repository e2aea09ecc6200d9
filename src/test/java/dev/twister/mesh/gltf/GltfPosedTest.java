package dev.twister.mesh.gltf;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.mesh.MeshFile;
import dev.twister.mesh.Reading;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Base64;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Skins and morph targets at rest. */
class GltfPosedTest {
    private static final float[] POSITIONS = {1, 0, 0, 2, 0, 0, 1, 1, 0};
    private static final float[] DISPLACEMENTS = {0, 0, 0, 0, 0, 0, 0, 0.5f, 0};
    private static final byte[] JOINTS = {0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0};
    private static final float[] WEIGHTS = {1, 0, 0, 0, 1, 0, 0, 0, 0.5f, 0.5f, 0, 0};
    private static final float[] INVERSE_BIND = {
        1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, -1, 0, 0, 1, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1
    };

    @TempDir
    Path folder;

    private final List<String> warnings = new ArrayList<>();

    private static String buffer() {
        ByteBuffer bytes = ByteBuffer.allocate(36 + 36 + 12 + 48 + 128).order(ByteOrder.LITTLE_ENDIAN);
        put(bytes, POSITIONS);
        put(bytes, DISPLACEMENTS);
        bytes.put(JOINTS);
        put(bytes, WEIGHTS);
        put(bytes, INVERSE_BIND);
        return Base64.getEncoder().encodeToString(bytes.array());
    }

    private static void put(ByteBuffer bytes, float[] values) {
        for (float value : values) {
            bytes.putFloat(value);
        }
    }

    private MeshFile read(String mesh, String node, String rest) {
        String text = "{\"asset\":{\"version\":\"2.0\"},\"scenes\":[{\"nodes\":[0,1]}],\"nodes\":[{\"mesh\":0,"
                + "\"translation\":[100,0,0]" + node + "},{\"translation\":[0,5,0],\"scale\":[2,2,2]},{}],"
                + "\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":0,\"JOINTS_0\":2,\"WEIGHTS_0\":3},"
                + "\"targets\":[{\"POSITION\":1}]}]" + mesh + "}],"
                + "\"accessors\":[" + accessor(0, 5126, 3, "VEC3") + "," + accessor(36, 5126, 3, "VEC3") + ","
                + accessor(72, 5121, 3, "VEC4") + "," + accessor(84, 5126, 3, "VEC4") + ","
                + accessor(132, 5126, 2, "MAT4") + "],\"bufferViews\":[{\"buffer\":0,\"byteLength\":260}],"
                + "\"buffers\":[{\"byteLength\":260,\"uri\":\"data:;base64," + buffer() + "\"}]" + rest + "}";
        return Reading.read(folder, "a.gltf", text.getBytes(StandardCharsets.UTF_8), 0, warnings);
    }

    private static String accessor(int offset, int type, int count, String kind) {
        return "{\"bufferView\":0,\"byteOffset\":" + offset + ",\"componentType\":" + type + ",\"count\":" + count
                + ",\"type\":\"" + kind + "\"}";
    }

    private static String skin(String joints) {
        return ",\"skins\":[{\"joints\":" + joints + ",\"inverseBindMatrices\":4}]";
    }

    @Test
    void jointsPlaceASkinnedMeshAndItsNodeDoesNot() {
        MeshFile file = read("", ",\"skin\":0", skin("[1,2]"));

        assertThat(Reading.triangles(file)).containsExactly("(0.0,5.0,0.0) (0.5,4.0,0.0) (2.0,5.0,0.0)");
        assertThat(warnings).isEmpty();
    }

    @Test
    void weightsOfTheMeshDisplaceMorphTargets() {
        MeshFile file = read(",\"weights\":[2]", "", "");

        assertThat(Reading.triangles(file)).containsExactly("(101.0,0.0,0.0) (101.0,2.0,0.0) (102.0,0.0,0.0)");
        assertThat(warnings).isEmpty();
    }

    @Test
    void weightsOfTheNodeComeFirstAndTheSkinAfterThem() {
        MeshFile file = read(",\"weights\":[2]", ",\"weights\":[-1],\"skin\":0", skin("[1,2]"));

        assertThat(Reading.triangles(file)).containsExactly("(0.0,5.0,0.0) (0.5,3.25,0.0) (2.0,5.0,0.0)");
    }

    @Test
    void aDamagedSkinLeavesTheMeshWhereItsNodePlacesIt() {
        MeshFile file = read("", ",\"skin\":0", skin("[1]"));

        assertThat(Reading.triangles(file)).containsExactly("(101.0,0.0,0.0) (101.0,1.0,0.0) (102.0,0.0,0.0)");
        assertThat(warnings).singleElement().asString().contains("joint 1; the skin has 1; shown without its skin");
    }

    @Test
    void instancesAreParts() {
        MeshFile file = read(
                "",
                ",\"extensions\":{\"EXT_mesh_gpu_instancing\":{\"attributes\":{\"TRANSLATION\":0}}}",
                ",\"extensionsRequired\":[\"EXT_mesh_gpu_instancing\"]");

        assertThat(file.meshes()).hasSize(1);
        assertThat(file.parts())
                .extracting(part -> part.placement().origin().x())
                .containsExactly(101.0, 102.0, 101.0);
        assertThat(warnings).isEmpty();
    }
}
