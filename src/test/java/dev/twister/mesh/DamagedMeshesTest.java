package dev.twister.mesh;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.mesh.gltf.AnimatedGltf;
import dev.twister.mesh.gltf.FinishedGltf;
import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Random;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;

/** Files with bytes changed, removed or inserted: read, or rejected with one line of text. */
class DamagedMeshesTest {
    private static final int MOST_BYTES = 64 << 20;
    private static final List<String> NUMBERS =
            List.of("-1", "0", "4294967295", "2147483648", "1e999", "1e30", "NaN", "-inf", "3", "99999999999999999999");

    private static final Map<String, List<byte[]>> FILES = Map.of(
            ".obj", List.of(MeshFiles.obj()),
            ".ply",
                    List.of(
                            MeshFiles.plyText(),
                            MeshFiles.ply(ByteOrder.LITTLE_ENDIAN),
                            MeshFiles.ply(ByteOrder.BIG_ENDIAN)),
            ".stl", List.of(MeshFiles.stlText(), MeshFiles.stlBinary()),
            ".gltf",
                    List.of(
                            MeshFiles.gltf(),
                            MeshFiles.glb(),
                            AnimatedGltf.example().getBytes(StandardCharsets.UTF_8),
                            FinishedGltf.example().getBytes(StandardCharsets.UTF_8)));

    @Property(tries = 1000)
    void areReadOrRefused(@ForAll long seed) throws IOException {
        Random random = new Random(seed);
        String ending = List.of(".obj", ".ply", ".stl", ".gltf").get(random.nextInt(4));
        List<byte[]> whole = FILES.get(ending);
        byte[] damaged = damage(whole.get(random.nextInt(whole.size())), random);
        Path file = Files.createTempFile("damaged", ending);
        long before = allocated();
        try {
            Files.write(file, damaged);
            List<String> warnings = new ArrayList<>();
            MeshFile mesh = MeshReader.read(file, random.nextBoolean() ? 0 : 40, warnings::add);
            assertThat(warnings).allMatch(warning -> warning.startsWith(file + ": ") && !warning.contains("\n"));
            assertThat(mesh.parts()).isNotEmpty();
            mesh.parts()
                    .forEach(part ->
                            assertThat(part.mesh()).isBetween(0, mesh.meshes().size() - 1));
            mesh.meshes().forEach(DamagedMeshesTest::checkMesh);
            for (int clip = 0; clip < mesh.rig().clips().size(); clip++) {
                double seconds =
                        random.nextDouble() * mesh.rig().clips().get(clip).seconds();
                mesh.rig().posed(mesh, clip, seconds).meshes().forEach(DamagedMeshesTest::checkMesh);
            }
        } catch (MeshException refused) {
            assertThat(refused).message().startsWith(file.toString()).doesNotContain("\n");
        } finally {
            Files.delete(file);
        }
        assertThat(allocated() - before).isLessThan(MOST_BYTES);
    }

    private static long allocated() {
        return ((com.sun.management.ThreadMXBean) ManagementFactory.getThreadMXBean()).getCurrentThreadAllocatedBytes();
    }

    private static void checkMesh(TriangleMesh mesh) {
        assertThat(mesh.triangles()).isPositive();
        for (int corner : mesh.corners()) {
            assertThat(corner >= 0 && corner < mesh.vertices()).isTrue();
        }
        for (float[] numbers : List.of(mesh.positions(), mesh.normals(), mesh.textureCoordinates())) {
            for (float number : numbers) {
                assertThat(Float.isFinite(number)).isTrue();
            }
        }
        assertThat(mesh.normals().length).isIn(0, 3 * mesh.vertices());
        assertThat(mesh.textureCoordinates().length).isIn(0, 2 * mesh.vertices());
        for (int i = 0; i < mesh.normals().length; i += 3) {
            double x = mesh.normals()[i];
            double y = mesh.normals()[i + 1];
            double z = mesh.normals()[i + 2];
            assertThat(Math.abs(x * x + y * y + z * z - 1)).isLessThan(1e-5);
        }
    }

    private static byte[] damage(byte[] whole, Random random) {
        byte[] damaged = whole.clone();
        for (int times = random.nextInt(3); times >= 0; times--) {
            // Half of the damage is near the start, where sizes and codes are.
            int reach = random.nextBoolean() ? damaged.length : Math.min(damaged.length, 200);
            int at = random.nextInt(Math.max(1, reach));
            switch (random.nextInt(5)) {
                case 0 -> damaged = Arrays.copyOf(damaged, at);
                case 1 -> damaged = replaced(damaged, at, at, new byte[] {(byte) random.nextInt(256)});
                case 2, 3 -> damaged = withNumber(damaged, at, random);
                default -> {
                    if (at < damaged.length) {
                        damaged[at] = (byte) random.nextInt(256);
                    }
                }
            }
        }
        return damaged;
    }

    /** Replaces the first number in the text at or after a position. */
    private static byte[] withNumber(byte[] bytes, int from, Random random) {
        int start = from;
        while (start < bytes.length && !isDigit(bytes[start])) {
            start++;
        }
        int end = start;
        while (end < bytes.length && isDigit(bytes[end])) {
            end++;
        }
        String number = NUMBERS.get(random.nextInt(NUMBERS.size()));
        return replaced(bytes, start, end, number.getBytes(StandardCharsets.US_ASCII));
    }

    private static boolean isDigit(byte character) {
        return character >= '0' && character <= '9';
    }

    private static byte[] replaced(byte[] bytes, int from, int to, byte[] by) {
        byte[] changed = Arrays.copyOf(bytes, bytes.length - (to - from) + by.length);
        System.arraycopy(by, 0, changed, from, by.length);
        System.arraycopy(bytes, to, changed, from + by.length, bytes.length - to);
        return changed;
    }
}
