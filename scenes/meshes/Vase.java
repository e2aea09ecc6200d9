import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import javax.imageio.ImageIO;

/**
 * Makes the vase of scenes/gallery.json beside itself, in every format: {@code java scenes/meshes/Vase.java}. It is 1.5
 * high and stands on the origin.
 */
public final class Vase {
    private static final int SIDES = 24;

    /** Distance from the axis and height: up the outside, then down the inside. */
    private static final double[][] PROFILE = {
        {0, 0}, {0.3, 0}, {0.36, 0.05}, {0.5, 0.3}, {0.55, 0.52}, {0.48, 0.8}, {0.3, 1.05}, {0.22, 1.2}, {0.26, 1.38},
        {0.38, 1.5}, {0.33, 1.5}, {0.21, 1.37}, {0.17, 1.2}, {0.42, 0.8}, {0.49, 0.52}, {0.3, 0.1}, {0, 0.08}
    };

    private static final int COLUMNS = SIDES + 1;

    private Vase() {}

    public static void main(String[] arguments) throws IOException {
        Path folder = Path.of("scenes", "meshes");
        Files.writeString(folder.resolve("vase.obj"), obj());
        Files.writeString(folder.resolve("vase.mtl"), """
                # Made by Vase.java
                newmtl glaze
                Kd 0.12 0.3 0.55
                Ks 1 1 1
                Ns 200
                illum 2
                """);
        Files.write(folder.resolve("vase.glb"), glb());
        Files.write(folder.resolve("vase.ply"), ply());
        Files.write(folder.resolve("vase.stl"), stl());
    }

    private static int vertexCount() {
        return PROFILE.length * COLUMNS;
    }

    /** x, y up, z to the viewer. The last column is the first once more, with other texture coordinates. */
    private static float[] position(int vertex) {
        double[] place = PROFILE[vertex / COLUMNS];
        double angle = 2 * Math.PI * (vertex % COLUMNS % SIDES) / SIDES;
        return new float[] {
            (float) (place[0] * Math.sin(angle)), (float) place[1], (float) (place[0] * Math.cos(angle))
        };
    }

    /** Three vertices for each triangle, counterclockwise from outside; none at the axis is flat. */
    private static int[][] triangles() {
        int last = PROFILE.length - 2;
        int[][] triangles = new int[2 * SIDES * last][];
        int count = 0;
        for (int ring = 0; ring <= last; ring++) {
            for (int side = 0; side < SIDES; side++) {
                int here = ring * COLUMNS + side;
                if (ring > 0) {
                    triangles[count++] = new int[] {here, here + 1, here + COLUMNS + 1};
                }
                if (ring < last) {
                    triangles[count++] = new int[] {here, here + COLUMNS + 1, here + COLUMNS};
                }
            }
        }
        return triangles;
    }

    private static String obj() {
        StringBuilder text = new StringBuilder("# Made by Vase.java\nmtllib vase.mtl\n");
        for (int vertex = 0; vertex < vertexCount(); vertex++) {
            float[] at = position(vertex);
            text.append(String.format(Locale.ROOT, "v %.4f %.4f %.4f\n", at[0], at[1], at[2]));
        }
        text.append("usemtl glaze\n");
        for (int[] triangle : triangles()) {
            text.append("f " + (triangle[0] + 1) + " " + (triangle[1] + 1) + " " + (triangle[2] + 1) + "\n");
        }
        return text.toString();
    }

    private static byte[] ply() {
        int[][] triangles = triangles();
        byte[] header = ("ply\nformat binary_little_endian 1.0\ncomment Made by Vase.java\nelement vertex " + vertexCount()
                        + "\nproperty float x\nproperty float y\nproperty float z\nelement face " + triangles.length
                        + "\nproperty list uchar ushort vertex_indices\nend_header\n")
                .getBytes(StandardCharsets.US_ASCII);
        ByteBuffer file = ByteBuffer.allocate(header.length + 12 * vertexCount() + 7 * triangles.length)
                .order(ByteOrder.LITTLE_ENDIAN)
                .put(header);
        for (int vertex = 0; vertex < vertexCount(); vertex++) {
            putPosition(file, vertex);
        }
        for (int[] triangle : triangles) {
            file.put((byte) 3);
            putCorners(file, triangle);
        }
        return file.array();
    }

    /** STL has z up, and y away from the viewer. */
    private static byte[] stl() {
        int[][] triangles = triangles();
        ByteBuffer file = ByteBuffer.allocate(84 + 50 * triangles.length).order(ByteOrder.LITTLE_ENDIAN);
        file.put("Made by Vase.java".getBytes(StandardCharsets.US_ASCII)).position(80).putInt(triangles.length);
        for (int[] triangle : triangles) {
            file.putFloat(0).putFloat(0).putFloat(0);
            for (int vertex : triangle) {
                float[] at = position(vertex);
                file.putFloat(at[0]).putFloat(-at[2]).putFloat(at[1]);
            }
            file.putShort((short) 0);
        }
        return file.array();
    }

    private static byte[] glb() throws IOException {
        int[][] triangles = triangles();
        byte[] picture = picture();
        int positionBytes = 12 * vertexCount();
        int coordinateBytes = 8 * vertexCount();
        int cornerBytes = 6 * triangles.length;
        int length = positionBytes + coordinateBytes + cornerBytes + picture.length;
        ByteBuffer data = ByteBuffer.allocate((length + 3) / 4 * 4).order(ByteOrder.LITTLE_ENDIAN);
        for (int vertex = 0; vertex < vertexCount(); vertex++) {
            putPosition(data, vertex);
        }
        for (int vertex = 0; vertex < vertexCount(); vertex++) {
            data.putFloat(2f * (vertex % COLUMNS) / SIDES).putFloat(1 - position(vertex)[1] / 1.5f);
        }
        for (int[] triangle : triangles) {
            putCorners(data, triangle);
        }
        data.put(picture);
        String json = """
                {"asset":{"version":"2.0","generator":"Vase.java"},"scene":0,"scenes":[{"nodes":[0]}],\
                "nodes":[{"name":"vase","mesh":0}],"meshes":[{"primitives":[{"attributes":\
                {"POSITION":0,"TEXCOORD_0":1},"indices":2,"material":0}]}],\
                "materials":[{"pbrMetallicRoughness":{"baseColorTexture":{"index":0},"metallicFactor":0,\
                "roughnessFactor":0}}],"textures":[{"source":0}],"images":[{"bufferView":3,"mimeType":"image/png"}],\
                "accessors":[{"bufferView":0,"componentType":5126,"count":%d,"type":"VEC3","min":[-0.55,0,-0.55],\
                "max":[0.55,1.5,0.55]},{"bufferView":1,"componentType":5126,"count":%d,"type":"VEC2"},\
                {"bufferView":2,"componentType":5123,"count":%d,"type":"SCALAR"}],\
                "bufferViews":[%s,%s,%s,%s],"buffers":[{"byteLength":%d}]}"""
                .formatted(
                        vertexCount(),
                        vertexCount(),
                        3 * triangles.length,
                        view(0, positionBytes),
                        view(positionBytes, coordinateBytes),
                        view(positionBytes + coordinateBytes, cornerBytes),
                        view(positionBytes + coordinateBytes + cornerBytes, picture.length),
                        length);
        byte[] text = (json + " ".repeat((4 - json.length() % 4) % 4)).getBytes(StandardCharsets.US_ASCII);
        ByteBuffer file = ByteBuffer.allocate(28 + text.length + data.capacity()).order(ByteOrder.LITTLE_ENDIAN);
        file.putInt(0x46546c67).putInt(2).putInt(file.capacity());
        file.putInt(text.length).putInt(0x4e4f534a).put(text);
        file.putInt(data.capacity()).putInt(0x004e4942).put(data.array());
        return file.array();
    }

    private static String view(int offset, int length) {
        return "{\"buffer\":0,\"byteOffset\":" + offset + ",\"byteLength\":" + length + "}";
    }

    private static void putPosition(ByteBuffer file, int vertex) {
        for (float coordinate : position(vertex)) {
            file.putFloat(coordinate);
        }
    }

    private static void putCorners(ByteBuffer file, int[] triangle) {
        for (int vertex : triangle) {
            file.putShort((short) vertex);
        }
    }

    /** Bands, and leaves between them. */
    private static byte[] picture() throws IOException {
        BufferedImage picture = new BufferedImage(128, 128, BufferedImage.TYPE_INT_RGB);
        Graphics2D graphics = picture.createGraphics();
        graphics.setColor(new Color(0xf2ead8));
        graphics.fillRect(0, 0, 128, 128);
        graphics.setColor(new Color(0x1f4e8c));
        for (int band : new int[] {6, 34, 84, 116}) {
            graphics.fillRect(0, band, 128, 4);
        }
        for (int leaf = 0; leaf < 4; leaf++) {
            graphics.fillOval(32 * leaf + 10, 44, 12, 34);
            graphics.fillOval(32 * leaf, 92, 20, 12);
        }
        graphics.dispose();
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        ImageIO.write(picture, "png", bytes);
        return bytes.toByteArray();
    }
}
