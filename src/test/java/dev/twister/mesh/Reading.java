package dev.twister.mesh;

import dev.twister.scene.Vector3;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;

/** Reads files from bytes and describes their contents. */
public final class Reading {
    private Reading() {}

    public static MeshFile read(Path folder, String name, byte[] content, double smoothDegrees) {
        return read(folder, name, content, smoothDegrees, new ArrayList<>());
    }

    public static MeshFile read(Path folder, String name, byte[] content, double smoothDegrees, List<String> warnings) {
        Path file = folder.resolve(name);
        try {
            Files.write(file, content);
        } catch (IOException failure) {
            throw new UncheckedIOException(failure);
        }
        return MeshReader.read(file, smoothDegrees, warnings::add);
    }

    public static MeshFile read(Path folder, String name, String content) {
        return read(folder, name, content.getBytes(StandardCharsets.UTF_8), 0);
    }

    /** Returns all placed triangles, each starting from its smallest corner. */
    public static Set<String> triangles(MeshFile file) {
        Set<String> triangles = new TreeSet<>();
        for (MeshPart part : file.parts()) {
            TriangleMesh mesh = file.meshes().get(part.mesh());
            for (int i = 0; i < mesh.corners().length; i += 3) {
                List<String> corners = new ArrayList<>();
                for (int corner = 0; corner < 3; corner++) {
                    corners.add(place(part, mesh, mesh.corners()[i + corner]));
                }
                triangles.add(fromLeast(corners));
            }
        }
        return triangles;
    }

    static String fromLeast(List<String> corners) {
        List<String> turned = new ArrayList<>(corners);
        String least = corners.stream().min(String::compareTo).orElseThrow();
        while (!turned.getFirst().equals(least)) {
            turned.addLast(turned.removeFirst());
        }
        return String.join(" ", turned);
    }

    private static String place(MeshPart part, TriangleMesh mesh, int vertex) {
        Vector3 point = part.placement()
                .point(new Vector3(
                        mesh.positions()[3 * vertex],
                        mesh.positions()[3 * vertex + 1],
                        mesh.positions()[3 * vertex + 2]));
        return place((float) point.x(), (float) point.y(), (float) point.z());
    }

    static String place(float x, float y, float z) {
        return "(" + (x + 0f) + "," + (y + 0f) + "," + (z + 0f) + ")";
    }
}
