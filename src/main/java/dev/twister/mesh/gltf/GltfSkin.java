package dev.twister.mesh.gltf;

import dev.twister.mesh.Affine;
import dev.twister.scene.Vector3;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;

/**
 * A skin at rest: the transforms from the coordinates of a mesh to the file's, one for each joint.
 *
 * @param movements where the nodes place the joints, after the inverse bind matrices
 */
record GltfSkin(List<Affine> movements) {
    private static final int MATRIX = 16;
    private static final int MOST_SETS = 8;
    private static final int SET = 4;

    GltfSkin {
        movements = List.copyOf(movements);
    }

    static GltfSkin of(GltfPlace root, int number, GltfNodes nodes, GltfAccessors accessors) throws IOException {
        GltfPlace skin = root.at("skins").at(number);
        List<GltfPlace> joints = skin.at("joints").items();
        GltfPlace matrices = skin.at("inverseBindMatrices");
        List<Affine> movements = new ArrayList<>();
        for (int joint = 0; joint < joints.size(); joint++) {
            Affine placement = nodes.placement(joints.get(joint).index(root.at("nodes")));
            movements.add(matrices.exists() ? placement.of(matrix(accessors.at(matrices, MATRIX), joint)) : placement);
        }
        return new GltfSkin(movements);
    }

    private static Affine matrix(GltfAccessor matrices, int index) throws IOException {
        if (index >= matrices.count()) {
            throw matrices.place().failure("has " + matrices.count() + " matrices; the skin has more joints");
        }
        Vector3[] columns = new Vector3[4];
        for (int column = 0; column < columns.length; column++) {
            columns[column] = new Vector3(
                    matrices.get(index, 4 * column),
                    matrices.get(index, 4 * column + 1),
                    matrices.get(index, 4 * column + 2));
        }
        return new Affine(columns[0], columns[1], columns[2], columns[3]);
    }

    /**
     * The joints and weights of a primitive's vertices.
     *
     * @param joints one accessor for each set of four
     * @param weights as many
     */
    record Binding(List<GltfAccessor> joints, List<GltfAccessor> weights) {
        Binding {
            joints = List.copyOf(joints);
            weights = List.copyOf(weights);
        }

        static Binding of(GltfPlace attributes, GltfAccessors accessors, int vertices) throws IOException {
            List<GltfAccessor> joints = new ArrayList<>();
            List<GltfAccessor> weights = new ArrayList<>();
            for (int set = 0; set < MOST_SETS && attributes.at("JOINTS_" + set).exists(); set++) {
                joints.add(checked(accessors.at(attributes.at("JOINTS_" + set), SET), vertices));
                weights.add(checked(accessors.at(attributes.at("WEIGHTS_" + set), SET), vertices));
            }
            if (joints.isEmpty()) {
                throw attributes.failure("has no JOINTS_0, but the mesh has a skin");
            }
            return new Binding(joints, weights);
        }

        private static GltfAccessor checked(GltfAccessor accessor, int vertices) {
            if (accessor.count() != vertices) {
                throw accessor.place()
                        .failure("has " + accessor.count() + " elements, but the primitive has " + vertices
                                + " vertices");
            }
            return accessor;
        }
    }

    /** The mean of the movements of a vertex's joints by their weights. */
    Affine movement(Binding binding, int vertex) throws IOException {
        Affine sum = new Affine(Vector3.ZERO, Vector3.ZERO, Vector3.ZERO, Vector3.ZERO);
        double total = 0;
        for (int set = 0; set < binding.joints().size(); set++) {
            GltfAccessor joints = binding.joints().get(set);
            for (int i = 0; i < SET; i++) {
                double weight = binding.weights().get(set).get(vertex, i);
                if (weight > 0) {
                    sum = plus(sum, movement(joints, vertex, i), weight);
                    total += weight;
                }
            }
        }
        // Weights are to add up to 1, but are rounded, or missing for vertices that no triangle uses.
        return total > 0
                ? new Affine(
                        sum.axisX().times(1 / total),
                        sum.axisY().times(1 / total),
                        sum.axisZ().times(1 / total),
                        sum.origin().times(1 / total))
                : Affine.IDENTITY;
    }

    private Affine movement(GltfAccessor joints, int vertex, int component) throws IOException {
        double joint = joints.get(vertex, component);
        if (joint >= movements.size()) {
            throw joints.place().failure("has the joint " + (long) joint + "; the skin has " + movements.size());
        }
        return movements.get((int) joint);
    }

    private static Affine plus(Affine sum, Affine added, double weight) {
        return new Affine(
                sum.axisX().plus(added.axisX().times(weight)),
                sum.axisY().plus(added.axisY().times(weight)),
                sum.axisZ().plus(added.axisZ().times(weight)),
                sum.origin().plus(added.origin().times(weight)));
    }
}
