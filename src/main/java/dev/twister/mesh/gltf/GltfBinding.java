package dev.twister.mesh.gltf;

import dev.twister.mesh.Affine;
import dev.twister.scene.Vector3;
import java.io.IOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/**
 * How the vertices of a primitive are bound to the joints of a skin.
 *
 * @param joints {@code int[influences * vertices]}: places of joints in the skin
 * @param weights as many; those of a vertex add up to 1, or are 0 where it is bound to none
 */
@SuppressWarnings("ArrayRecordComponent") // never compared
record GltfBinding(GltfSkin skin, int influences, int[] joints, float[] weights) {
    private static final int MOST_SETS = 8;
    private static final int SET = 4;
    private static final int MATRIX = 12;

    /** @param used numbers of the vertices in the file */
    static GltfBinding of(GltfSkin skin, GltfPlace attributes, GltfAccessors accessors, int vertices, int[] used)
            throws IOException {
        List<GltfAccessor> joints = new ArrayList<>();
        List<GltfAccessor> weights = new ArrayList<>();
        for (int set = 0; set < MOST_SETS && attributes.at("JOINTS_" + set).exists(); set++) {
            joints.add(accessors.at(attributes.at("JOINTS_" + set), SET).checked(vertices));
            weights.add(accessors.at(attributes.at("WEIGHTS_" + set), SET).checked(vertices));
        }
        if (joints.isEmpty()) {
            throw attributes.failure("has no JOINTS_0, but the mesh has a skin");
        }
        int influences = SET * joints.size();
        GltfBinding binding = new GltfBinding(
                skin, influences, new int[influences * used.length], new float[influences * used.length]);
        for (int vertex = 0; vertex < used.length; vertex++) {
            binding.read(vertex, used[vertex], joints, weights);
        }
        return binding;
    }

    private void read(int vertex, int source, List<GltfAccessor> jointSets, List<GltfAccessor> weightSets)
            throws IOException {
        double[] read = new double[influences];
        double total = 0;
        for (int i = 0; i < influences; i++) {
            double weight = weightSets.get(i / SET).get(source, i % SET);
            if (weight > 0) {
                GltfAccessor set = jointSets.get(i / SET);
                double joint = set.get(source, i % SET);
                if (!(joint >= 0 && joint < skin.joints().size())) {
                    throw set.place()
                            .failure("has the joint " + (long) joint + "; the skin has "
                                    + skin.joints().size());
                }
                joints[influences * vertex + i] = (int) joint;
                read[i] = weight;
                total += weight;
            }
        }
        // Weights are to add up to 1, but are rounded, or missing for vertices that no triangle uses.
        for (int i = 0; i < influences && total > 0; i++) {
            weights[influences * vertex + i] = (float) (read[i] / total);
        }
    }

    /** The movements as numbers: three columns and the origin of each. */
    static double[] matrices(List<Affine> movements) {
        double[] matrices = new double[MATRIX * movements.size()];
        for (int joint = 0; joint < movements.size(); joint++) {
            Affine movement = movements.get(joint);
            Vector3[] columns = {movement.axisX(), movement.axisY(), movement.axisZ(), movement.origin()};
            for (int column = 0; column < columns.length; column++) {
                matrices[MATRIX * joint + 3 * column] = columns[column].x();
                matrices[MATRIX * joint + 3 * column + 1] = columns[column].y();
                matrices[MATRIX * joint + 3 * column + 2] = columns[column].z();
            }
        }
        return matrices;
    }

    /**
     * Writes the mean of the movements of a vertex's joints by their weights: three columns and the origin.
     *
     * @param matrices as {@link #matrices} gives them
     */
    void mean(int vertex, double[] matrices, double[] to) {
        Arrays.fill(to, 0);
        double total = 0;
        for (int i = influences * vertex; i < influences * (vertex + 1); i++) {
            double weight = weights[i];
            if (weight > 0) {
                int matrix = MATRIX * joints[i];
                for (int k = 0; k < MATRIX; k++) {
                    to[k] += weight * matrices[matrix + k];
                }
                total += weight;
            }
        }
        if (total == 0) {
            to[0] = 1;
            to[4] = 1;
            to[8] = 1;
        }
    }
}
