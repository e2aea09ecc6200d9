import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;

/**
 * Makes bowl.ply beside itself: {@code java scenes/meshes/Bowl.java}. The lower half of a sphere of radius 1 about the
 * origin, open above, with a wall.
 */
public final class Bowl {
    private static final int SIDES = 64;
    private static final int RINGS = 20;
    private static final double WALL = 0.06;

    private Bowl() {}

    public static void main(String[] arguments) throws IOException {
        int vertices = 2 * (SIDES * RINGS + 1);
        int triangles = 2 * SIDES * (2 * RINGS);
        String header = "ply\nformat binary_little_endian 1.0\ncomment Made by Bowl.java\nelement vertex " + vertices
                + "\nproperty float x\nproperty float y\nproperty float z\nelement face " + triangles
                + "\nproperty list uchar ushort vertex_indices\nend_header\n";
        byte[] start = header.getBytes(StandardCharsets.US_ASCII);
        ByteBuffer file = ByteBuffer.allocate(start.length + 12 * vertices + 7 * triangles)
                .order(ByteOrder.LITTLE_ENDIAN)
                .put(start);
        // From the outer pole up to the rim, and down to the inner pole.
        putVertex(file, 0, 1, 0);
        for (int ring = 1; ring <= 2 * RINGS; ring++) {
            int up = Math.min(ring, 2 * RINGS + 1 - ring);
            for (int side = 0; side < SIDES; side++) {
                putVertex(file, Math.PI / 2 * up / RINGS, ring > RINGS ? 1 - WALL : 1, 2 * Math.PI * side / SIDES);
            }
        }
        putVertex(file, 0, 1 - WALL, 0);
        putTriangles(file, vertices - 1);
        Files.write(Path.of("scenes", "meshes", "bowl.ply"), file.array());
    }

    private static void putVertex(ByteBuffer file, double polar, double radius, double azimuth) {
        double level = radius * Math.sin(polar);
        file.putFloat((float) (level * Math.cos(azimuth)))
                .putFloat((float) (-radius * Math.cos(polar)))
                .putFloat((float) (level * Math.sin(azimuth)));
    }

    /** Counterclockwise from outside. */
    private static void putTriangles(ByteBuffer file, int last) {
        for (int side = 0; side < SIDES; side++) {
            int next = (side + 1) % SIDES;
            putTriangle(file, 0, 1 + side, 1 + next);
            for (int ring = 0; ring + 1 < 2 * RINGS; ring++) {
                int here = 1 + ring * SIDES;
                putTriangle(file, here + side, here + SIDES + side, here + SIDES + next);
                putTriangle(file, here + side, here + SIDES + next, here + next);
            }
            putTriangle(file, last, last - SIDES + next, last - SIDES + side);
        }
    }

    private static void putTriangle(ByteBuffer file, int a, int b, int c) {
        file.put((byte) 3).putShort((short) a).putShort((short) b).putShort((short) c);
    }
}
