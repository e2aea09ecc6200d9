package dev.twister.mesh;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.scene.SrgbCurve;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Colors of vertices and faces. */
class MeshColorsTest {
    private static final String PLY_VERTICES = """
            ply
            format ascii 1.0
            element vertex 3
            property float x
            property float y
            property float z
            """;

    /** Linear value of half of what sRGB stores in 8 bits. */
    private static final float HALF = (float) SrgbCurve.linear(128 / 255.0);

    @TempDir
    Path folder;

    private float[] colors(String name, String content) {
        return Reading.read(folder, name, content).meshes().getFirst().colors();
    }

    @Test
    void ofVerticesInObj() {
        assertThat(colors("a.obj", "v 0 0 0 1 0 0\nv 1 0 0\nv 0 1 0 0 0 1\nf 1 2 3\n"))
                .containsExactlyInAnyOrder(1, 0, 0, 1, 1, 1, 1, 1, 0, 0, 1, 1);
    }

    @Test
    void ofVerticesInObjTo255() {
        assertThat(colors("a.obj", "v 0 0 0 128 0 0\nv 1 0 0 128 0 0\nv 0 1 0 128 0 0\nf 1 2 3\n"))
                .containsExactly(HALF, 0, 0, 1, HALF, 0, 0, 1, HALF, 0, 0, 1);
    }

    @Test
    void weightsInObjAreNoColors() {
        assertThat(colors("a.obj", "v 0 0 0 1\nv 1 0 0 1\nv 0 1 0 1\nf 1 2 3\n"))
                .isEmpty();
    }

    @Test
    void ofVerticesInPly() {
        String text = PLY_VERTICES + "property uchar red\nproperty uchar green\nproperty uchar blue\n"
                + "element face 1\nproperty list uchar int vertex_indices\nend_header\n"
                + "0 0 0 255 0 0\n1 0 0 0 255 0\n0 1 0 0 0 128\n3 0 1 2\n";
        assertThat(colors("a.ply", text)).containsExactlyInAnyOrder(1, 0, 0, 1, 0, 1, 0, 1, 0, 0, HALF, 1);
    }

    /** Two faces of different colors share no vertices. */
    @Test
    void ofFacesInPly() {
        String text = PLY_VERTICES.replace("vertex 3", "vertex 4") + "element face 2\nproperty uchar red\n"
                + "property list uchar int vertex_indices\nproperty uchar green\nproperty uchar blue\nend_header\n"
                + "0 0 0\n1 0 0\n0 1 0\n1 1 0\n255 3 0 1 2 0 0\n0 3 1 3 2 255 0\n";
        assertThat(colors("a.ply", text))
                .containsExactly(1, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1, 0, 1, 0, 1, 0, 1, 0, 1, 0, 1, 0, 1);
    }

    @Test
    void ofViscamInStl() {
        assertThat(stl("", 0x8000 | 31 << 10)).containsExactly(1, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1);
    }

    @Test
    void ofMaterialiseInStl() {
        assertThat(stl("COLOR=\u0080\u0000\u0000\u00ff", 31)).containsExactly(1, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1);
    }

    @Test
    void ofTheWholeInStl() {
        assertThat(stl("COLOR=\u0080\u0000\u0000\u00ff", 0x8000))
                .containsExactly(HALF, 0, 0, 1, HALF, 0, 0, 1, HALF, 0, 0, 1);
    }

    @Test
    void otherBytesInStlAreNoColors() {
        assertThat(stl("", 31)).isEmpty();
    }

    private float[] stl(String header, int attribute) {
        ByteBuffer bytes = ByteBuffer.allocate(84 + 50).order(ByteOrder.LITTLE_ENDIAN);
        bytes.put(header.getBytes(StandardCharsets.ISO_8859_1)).position(80);
        bytes.putInt(1).position(84 + 12);
        for (float value : new float[] {0, 0, 0, 1, 0, 0, 0, 1, 0}) {
            bytes.putFloat(value);
        }
        bytes.putShort((short) attribute);
        return Reading.read(folder, "a.stl", bytes.array(), 0)
                .meshes()
                .getFirst()
                .colors();
    }
}
