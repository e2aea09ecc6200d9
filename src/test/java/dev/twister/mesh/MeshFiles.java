package dev.twister.mesh;

import java.io.ByteArrayOutputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.Base64;
import java.util.Locale;

/** The same shape in every format: a box of 12 triangles with corners at 0 and (2, 1, 3), in Twister's axes. */
public final class MeshFiles {
    /** Corner coordinates in Twister's axes. */
    static final float[][] CORNERS = {
        {0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {0, 1, 0}, {0, 0, 3}, {2, 0, 3}, {2, 1, 3}, {0, 1, 3}
    };

    /** Their counterclockwise normals point outward in Twister's axes. */
    static final int[][] QUADS = {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {3, 7, 6, 2}, {0, 4, 7, 3}, {1, 2, 6, 5}};

    private MeshFiles() {}

    public static int[][] triangles() {
        int[][] triangles = new int[12][];
        for (int i = 0; i < 6; i++) {
            int[] quad = QUADS[i];
            triangles[2 * i] = new int[] {quad[0], quad[1], quad[2]};
            triangles[2 * i + 1] = new int[] {quad[0], quad[2], quad[3]};
        }
        return triangles;
    }

    private static byte[] bytes(String text) {
        return text.getBytes(StandardCharsets.UTF_8);
    }

    static byte[] obj() {
        StringBuilder text = new StringBuilder("# a box\no box\n");
        for (float[] corner : CORNERS) {
            text.append(String.format(Locale.ROOT, "v %s %s %s%n", corner[0], corner[1], -corner[2]));
        }
        text.append("vt 0.25 0.75\nusemtl red\n");
        for (int[] quad : QUADS) {
            text.append("f");
            // Mirroring reverses the winding.
            for (int i = 4; i > 0; i--) {
                text.append(' ').append(quad[i % 4] + 1).append("/-1");
            }
            text.append('\n');
        }
        return bytes(text.toString());
    }

    static byte[] plyText() {
        return bytes(plyHeader("ascii") + plyRows());
    }

    private static String plyHeader(String format) {
        return "ply\nformat " + format + " 1.0\ncomment a box\nelement vertex 8\nproperty float x\nproperty double y\n"
                + "property float z\nproperty uchar red\nelement note 1\nproperty list uchar short words\n"
                + "element face 6\nproperty list uchar ushort vertex_indices\nproperty int flags\nend_header\n";
    }

    private static String plyRows() {
        StringBuilder text = new StringBuilder();
        for (float[] corner : CORNERS) {
            text.append(corner[0] + " " + corner[1] + " " + -corner[2] + " 255\n");
        }
        text.append("2 7 8\n");
        for (int[] quad : QUADS) {
            text.append("4 " + quad[0] + " " + quad[3] + " " + quad[2] + " " + quad[1] + " 5\n");
        }
        return text.toString();
    }

    static byte[] ply(ByteOrder order) {
        ByteBuffer rows = ByteBuffer.allocate(1000).order(order);
        for (float[] corner : CORNERS) {
            rows.putFloat(corner[0]).putDouble(corner[1]).putFloat(-corner[2]).put((byte) 255);
        }
        rows.put((byte) 2).putShort((short) 7).putShort((short) 8);
        for (int[] quad : QUADS) {
            rows.put((byte) 4);
            for (int i = 4; i > 0; i--) {
                rows.putShort((short) quad[i % 4]);
            }
            rows.putInt(5);
        }
        return joined(
                bytes(plyHeader(order == ByteOrder.LITTLE_ENDIAN ? "binary_little_endian" : "binary_big_endian")),
                used(rows));
    }

    static byte[] stlText() {
        StringBuilder text = new StringBuilder("solid box\n");
        for (int[] triangle : triangles()) {
            text.append("facet normal 0 0 0\n  outer loop\n");
            for (int i = 2; i >= 0; i--) {
                float[] corner = CORNERS[triangle[i]];
                text.append("    vertex " + corner[0] + " " + corner[2] + " " + corner[1] + "\n");
            }
            text.append("  endloop\nendfacet\n");
        }
        return bytes(text + "endsolid box\n");
    }

    /** A binary file that begins with "solid", as text files do. */
    static byte[] stlBinary() {
        ByteBuffer file = ByteBuffer.allocate(84 + 50 * 12).order(ByteOrder.LITTLE_ENDIAN);
        file.put(0, bytes("solid but binary")).position(80).putInt(12);
        for (int[] triangle : triangles()) {
            file.putFloat(0).putFloat(0).putFloat(0);
            for (int i = 2; i >= 0; i--) {
                float[] corner = CORNERS[triangle[i]];
                file.putFloat(corner[0]).putFloat(corner[2]).putFloat(corner[1]);
            }
            file.putShort((short) 0);
        }
        return used(file);
    }

    /** A file with the buffer embedded in the text. */
    public static byte[] gltf() {
        return bytes(gltfText(",\"uri\":\"data:application/octet-stream;base64,"
                + Base64.getEncoder().encodeToString(gltfBuffer()) + "\""));
    }

    public static byte[] glb() {
        return glb(gltfText(""), gltfBuffer());
    }

    public static byte[] glb(String text, byte[] buffer) {
        byte[] json = bytes(text + " ".repeat((4 - bytes(text).length % 4) % 4));
        byte[] binary = joined(buffer, new byte[(4 - buffer.length % 4) % 4]);
        ByteBuffer file = ByteBuffer.allocate(28 + json.length + binary.length).order(ByteOrder.LITTLE_ENDIAN);
        file.putInt(0x46546c67).putInt(2).putInt(file.capacity());
        file.putInt(json.length).putInt(0x4e4f534a).put(json);
        file.putInt(binary.length).putInt(0x004e4942).put(binary);
        return file.array();
    }

    /** Positions at half size and moved; the node reverts both. */
    private static byte[] gltfBuffer() {
        ByteBuffer buffer = ByteBuffer.allocate(12 * 8 + 2 * 36).order(ByteOrder.LITTLE_ENDIAN);
        for (float[] corner : CORNERS) {
            buffer.putFloat(corner[0] / 2 - 1).putFloat(corner[1] / 2).putFloat(-corner[2] / 2);
        }
        for (int[] triangle : triangles()) {
            for (int i = 2; i >= 0; i--) {
                buffer.putShort((short) triangle[i]);
            }
        }
        return buffer.array();
    }

    private static String gltfText(String uri) {
        return "{\"asset\":{\"version\":\"2.0\"},\"scene\":0,\"scenes\":[{\"nodes\":[0]}],"
                + "\"nodes\":[{\"children\":[1],\"scale\":[2,2,2]},{\"mesh\":0,\"translation\":[1,0,0]}],"
                + "\"meshes\":[{\"name\":\"box\",\"primitives\":[{\"attributes\":{\"POSITION\":0},\"indices\":1,"
                + "\"material\":0}]}],\"materials\":[{\"pbrMetallicRoughness\":{\"baseColorFactor\":[1,0.5,0.25,1],"
                + "\"metallicFactor\":0,\"roughnessFactor\":0.5}}],"
                + "\"accessors\":[{\"bufferView\":0,\"componentType\":5126,\"count\":8,\"type\":\"VEC3\"},"
                + "{\"bufferView\":1,\"componentType\":5123,\"count\":36,\"type\":\"SCALAR\"}],"
                + "\"bufferViews\":[{\"buffer\":0,\"byteLength\":96},{\"buffer\":0,\"byteOffset\":96,\"byteLength\":72}],"
                + "\"buffers\":[{\"byteLength\":168" + uri + "}]}";
    }

    private static byte[] used(ByteBuffer buffer) {
        byte[] bytes = new byte[buffer.position()];
        buffer.get(0, bytes);
        return bytes;
    }

    private static byte[] joined(byte[]... arrays) {
        ByteArrayOutputStream all = new ByteArrayOutputStream();
        for (byte[] array : arrays) {
            all.writeBytes(array);
        }
        return all.toByteArray();
    }
}
