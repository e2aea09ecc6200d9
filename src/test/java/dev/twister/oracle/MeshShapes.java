package dev.twister.oracle;

import dev.twister.mesh.Affine;
import dev.twister.mesh.MeshFile;
import dev.twister.mesh.MeshPart;
import dev.twister.mesh.TriangleMesh;
import dev.twister.scene.Material;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Random;

/** Meshes without files, centered at the origin. All but the soup are closed, with outward faces. */
public final class MeshShapes {
    private static final double GOLDEN = (1 + Math.sqrt(5)) / 2;

    private static final double[] ICOSAHEDRON = {
        -1, GOLDEN, 0, 1, GOLDEN, 0, -1, -GOLDEN, 0, 1, -GOLDEN, 0, 0, -1, GOLDEN, 0, 1, GOLDEN, 0, -1, -GOLDEN, 0, 1,
        -GOLDEN, GOLDEN, 0, -1, GOLDEN, 0, 1, -GOLDEN, 0, -1, -GOLDEN, 0, 1
    };

    private static final int[] ICOSAHEDRON_CORNERS = {
        0, 11, 5, 0, 5, 1, 0, 1, 7, 0, 7, 10, 0, 10, 11, 1, 5, 9, 5, 11, 4, 11, 10, 2, 10, 7, 6, 7, 1, 8, 3, 9, 4, 3, 4,
        2, 3, 2, 6, 3, 6, 8, 3, 8, 9, 4, 9, 5, 2, 4, 11, 6, 2, 10, 8, 6, 7, 9, 8, 1
    };

    private static final int[] CUBE_CORNERS = {
        0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6, 0, 1, 5, 0, 5, 4, 2, 6, 7, 2, 7, 3, 0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5
    };

    private MeshShapes() {}

    /** A sphere of radius 1 with 20 * 4^levels triangles, normals and texture coordinates. */
    public static TriangleMesh icosphere(int levels) {
        float[] positions = new float[ICOSAHEDRON.length];
        for (int i = 0; i < positions.length; i++) {
            positions[i] = (float) (ICOSAHEDRON[i] / Math.sqrt(1 + GOLDEN * GOLDEN));
        }
        return sphere(positions, ICOSAHEDRON_CORNERS, levels);
    }

    /** A sphere of radius 1 from a cube, with 12 * 4^levels triangles, normals and texture coordinates. */
    public static TriangleMesh cubeSphere(int levels) {
        float[] positions = cube().positions().clone();
        for (int i = 0; i < positions.length; i++) {
            positions[i] /= (float) Math.sqrt(3);
        }
        return sphere(positions, CUBE_CORNERS, levels);
    }

    private static TriangleMesh sphere(float[] first, int[] firstCorners, int levels) {
        float[] positions = first;
        int[] corners = firstCorners;
        for (int level = 0; level < levels; level++) {
            Halves halves = new Halves(positions);
            corners = halves.split(corners);
            positions = halves.positions();
        }
        return new TriangleMesh(positions, positions.clone(), places(positions), corners);
    }

    private static float[] places(float[] positions) {
        float[] places = new float[positions.length / 3 * 2];
        for (int vertex = 0; vertex < positions.length / 3; vertex++) {
            places[2 * vertex] = 2 * positions[3 * vertex];
            places[2 * vertex + 1] = positions[3 * vertex + 1] + 0.5f * positions[3 * vertex + 2];
        }
        return places;
    }

    /** A cube of side 2 with flat shading. */
    public static TriangleMesh cube() {
        float[] positions = new float[3 * 8];
        for (int i = 0; i < positions.length; i++) {
            positions[i] = (((i / 3) >> (i % 3)) & 1) == 0 ? -1 : 1;
        }
        return new TriangleMesh(positions, new float[0], new float[0], CUBE_CORNERS);
    }

    /** Two triangles at y = 0 that face up, forming a square of side 2. */
    public static TriangleMesh square() {
        return new TriangleMesh(
                new float[] {-1, 0, -1, 1, 0, -1, -1, 0, 1, 1, 0, 1},
                new float[0],
                new float[] {0, 1, 1, 1, 0, 0, 1, 0},
                new int[] {0, 2, 1, 1, 2, 3});
    }

    /** A sphere with dents and bumps, star-shaped about its center. */
    public static TriangleMesh blob(Random random, int levels) {
        TriangleMesh sphere = icosphere(levels);
        float[] positions = sphere.positions().clone();
        for (int vertex = 0; vertex < positions.length / 3; vertex++) {
            float stretch = 0.6f + 0.8f * random.nextFloat();
            for (int axis = 0; axis < 3; axis++) {
                positions[3 * vertex + axis] *= stretch;
            }
        }
        return new TriangleMesh(positions, new float[0], sphere.textureCoordinates(), sphere.corners());
    }

    /** Loose triangles that intersect each other. */
    public static TriangleMesh soup(Random random, int triangles) {
        float[] positions = new float[9 * triangles];
        for (int i = 0; i < positions.length; i++) {
            positions[i] = 2 * random.nextFloat() - 1;
        }
        int[] corners = new int[3 * triangles];
        Arrays.setAll(corners, corner -> corner);
        return new TriangleMesh(positions, new float[0], new float[0], corners);
    }

    /** A file with one untransformed part. */
    public static MeshFile file(TriangleMesh mesh) {
        return file(List.of(mesh), List.of(new MeshPart("", 0, Affine.IDENTITY, Material.DEFAULT)));
    }

    public static MeshFile file(List<TriangleMesh> meshes, List<MeshPart> parts) {
        return new MeshFile(meshes, parts, Map.of(), 0);
    }

    /** Splits each triangle into four, with the new corners on the unit sphere. */
    private static final class Halves {
        private final Map<Long, Integer> vertexByEdge = new HashMap<>();
        private float[] positions;
        private int count;

        Halves(float[] positions) {
            this.positions = positions;
            count = positions.length / 3;
        }

        int[] split(int[] corners) {
            int[] split = new int[4 * corners.length];
            int at = 0;
            for (int i = 0; i < corners.length; i += 3) {
                int a = corners[i];
                int b = corners[i + 1];
                int c = corners[i + 2];
                int ab = half(a, b);
                int bc = half(b, c);
                int ca = half(c, a);
                for (int corner : new int[] {a, ab, ca, ab, b, bc, ca, bc, c, ab, bc, ca}) {
                    split[at++] = corner;
                }
            }
            return split;
        }

        private int half(int a, int b) {
            return vertexByEdge.computeIfAbsent(((long) Math.min(a, b) << 32) | Math.max(a, b), edge -> add(a, b));
        }

        private int add(int a, int b) {
            positions = Arrays.copyOf(positions, Math.max(positions.length, 3 * count + 3));
            if (positions.length < 3 * count + 300) {
                positions = Arrays.copyOf(positions, 2 * positions.length + 300);
            }
            double squared = 0;
            for (int axis = 0; axis < 3; axis++) {
                double middle = positions[3 * a + axis] + (double) positions[3 * b + axis];
                positions[3 * count + axis] = (float) middle;
                squared += middle * middle;
            }
            for (int axis = 0; axis < 3; axis++) {
                positions[3 * count + axis] /= (float) Math.sqrt(squared);
            }
            return count++;
        }

        float[] positions() {
            return Arrays.copyOf(positions, 3 * count);
        }
    }
}
