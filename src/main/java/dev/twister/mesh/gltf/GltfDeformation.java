package dev.twister.mesh.gltf;

import dev.twister.mesh.Affine;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * The vertices of a primitive as the file has them, and what moves them: morph targets displace them, then a skin moves
 * them. All vectors are in the file's axes, three numbers for each vertex.
 *
 * @param tangents without their signs
 * @param targets what each morph target adds to the positions, normals and tangents
 */
@SuppressWarnings("ArrayRecordComponent") // never compared
record GltfDeformation(
        float[] positions, float[] normals, float[] tangents, List<Target> targets, Optional<GltfBinding> binding) {
    private static final float[] NONE = {};
    private static final int MATRIX = 12;

    /** What a morph target adds. */
    record Target(Displacements positions, Displacements normals, Displacements tangents) {}

    /**
     * What a morph target adds to an attribute.
     *
     * @param vertices those that it changes
     * @param by three numbers for each
     */
    record Displacements(int[] vertices, float[] by) {
        private static final Displacements NONE = new Displacements(new int[0], new float[0]);

        static Displacements of(GltfPlace number, GltfAccessors accessors, int vertices, int[] used)
                throws IOException {
            if (!number.exists()) {
                return NONE;
            }
            GltfAccessor accessor = accessors.at(number, 3).checked(vertices);
            float[] all = vectors(accessor, used);
            int changed = 0;
            int[] list = new int[used.length];
            for (int vertex = 0; vertex < used.length; vertex++) {
                if (all[3 * vertex] != 0 || all[3 * vertex + 1] != 0 || all[3 * vertex + 2] != 0) {
                    list[changed++] = vertex;
                }
            }
            int[] numbers = new int[changed];
            float[] by = new float[3 * changed];
            for (int i = 0; i < changed; i++) {
                numbers[i] = list[i];
                System.arraycopy(all, 3 * list[i], by, 3 * i, 3);
            }
            return new Displacements(numbers, by);
        }

        void add(double weight, double[] to) {
            for (int i = 0; i < vertices.length && to.length > 0; i++) {
                for (int axis = 0; axis < 3; axis++) {
                    to[3 * vertices[i] + axis] += weight * by[3 * i + axis];
                }
            }
        }
    }

    /** Vertices that have been moved; normals are not normalized. */
    record Moved(double[] positions, double[] normals, double[] tangents) {}

    /**
     * Reads a primitive.
     *
     * @param used numbers of its vertices in the file
     * @param skin the skin that moves it
     */
    static GltfDeformation of(
            GltfPlace primitive,
            GltfAccessors accessors,
            GltfMeshes.Attributes attributes,
            int[] used,
            Optional<GltfSkin> skin)
            throws IOException {
        int vertices = attributes.positions().count();
        List<Target> targets = new ArrayList<>();
        for (GltfPlace target : primitive.at("targets").items()) {
            accessors.share((long) used.length, target);
            targets.add(new Target(
                    Displacements.of(target.at("POSITION"), accessors, vertices, used),
                    Displacements.of(target.at("NORMAL"), accessors, vertices, used),
                    Displacements.of(target.at("TANGENT"), accessors, vertices, used)));
        }
        return new GltfDeformation(
                vectors(attributes.positions(), used),
                attributes.normals().isPresent() ? vectors(attributes.normals().get(), used) : NONE,
                attributes.tangents().isPresent()
                        ? vectors(attributes.tangents().get(), used)
                        : NONE,
                targets,
                skin.isPresent()
                        ? Optional.of(GltfBinding.of(skin.get(), primitive.at("attributes"), accessors, vertices, used))
                        : Optional.empty());
    }

    private static float[] vectors(GltfAccessor accessor, int[] used) throws IOException {
        float[] vectors = new float[3 * used.length];
        for (int vertex = 0; vertex < used.length; vertex++) {
            for (int axis = 0; axis < 3; axis++) {
                vectors[3 * vertex + axis] = (float) accessor.get(used[vertex], axis);
            }
        }
        return vectors;
    }

    /**
     * Moves the vertices.
     *
     * @param weights of the morph targets; missing ones are 0
     * @param movements of the joints, if there is a skin
     */
    Moved moved(double[] weights, List<Affine> movements) {
        Moved moved = new Moved(doubles(positions), doubles(normals), doubles(tangents));
        for (int i = 0; i < Math.min(weights.length, targets.size()); i++) {
            if (weights[i] != 0) {
                targets.get(i).positions().add(weights[i], moved.positions());
                targets.get(i).normals().add(weights[i], moved.normals());
                targets.get(i).tangents().add(weights[i], moved.tangents());
            }
        }
        binding.ifPresent(bound -> move(bound, GltfBinding.matrices(movements), moved));
        return moved;
    }

    private static double[] doubles(float[] values) {
        double[] doubles = new double[values.length];
        for (int i = 0; i < doubles.length; i++) {
            doubles[i] = values[i];
        }
        return doubles;
    }

    private static void move(GltfBinding binding, double[] matrices, Moved moved) {
        double[] m = new double[MATRIX];
        double[] cofactors = new double[9];
        for (int at = 0; at < moved.positions().length; at += 3) {
            binding.mean(at / 3, matrices, m);
            turn(moved.positions(), at, m);
            moved.positions()[at] += m[9];
            moved.positions()[at + 1] += m[10];
            moved.positions()[at + 2] += m[11];
            if (moved.tangents().length > 0) {
                turn(moved.tangents(), at, m);
            }
            if (moved.normals().length > 0) {
                cofactors(m, cofactors);
                turn(moved.normals(), at, cofactors);
            }
        }
    }

    private static void turn(double[] vectors, int at, double[] m) {
        double x = vectors[at];
        double y = vectors[at + 1];
        double z = vectors[at + 2];
        vectors[at] = x * m[0] + y * m[3] + z * m[6];
        vectors[at + 1] = x * m[1] + y * m[4] + z * m[7];
        vectors[at + 2] = x * m[2] + y * m[5] + z * m[8];
    }

    /** What turns normals so that they stay perpendicular: the cross products of the columns, as columns. */
    private static void cofactors(double[] m, double[] to) {
        for (int column = 0; column < 3; column++) {
            int a = 3 * ((column + 1) % 3);
            int b = 3 * ((column + 2) % 3);
            to[3 * column] = m[a + 1] * m[b + 2] - m[a + 2] * m[b + 1];
            to[3 * column + 1] = m[a + 2] * m[b] - m[a] * m[b + 2];
            to[3 * column + 2] = m[a] * m[b + 1] - m[a + 1] * m[b];
        }
    }
}
