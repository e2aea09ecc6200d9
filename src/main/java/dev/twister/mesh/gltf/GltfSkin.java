package dev.twister.mesh.gltf;

import dev.twister.mesh.Affine;
import dev.twister.scene.Vector3;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.function.IntFunction;
import java.util.stream.IntStream;

/**
 * A skin: nodes that move the vertices of a mesh.
 *
 * @param joints numbers of the nodes
 * @param inverses the transform from the mesh's coordinates to each joint's, as the mesh was bound
 */
record GltfSkin(List<Integer> joints, List<Affine> inverses) {
    private static final int MATRIX = 16;

    GltfSkin {
        joints = List.copyOf(joints);
        inverses = List.copyOf(inverses);
    }

    static GltfSkin of(GltfPlace root, int number, GltfAccessors accessors) throws IOException {
        GltfPlace skin = root.at("skins").at(number);
        List<Integer> joints = GltfScenes.indices(skin.at("joints"), root.at("nodes"));
        GltfPlace matrices = skin.at("inverseBindMatrices");
        List<Affine> inverses = new ArrayList<>();
        for (int joint = 0; joint < joints.size(); joint++) {
            inverses.add(matrices.exists() ? matrix(accessors.at(matrices, MATRIX), joint) : Affine.IDENTITY);
        }
        return new GltfSkin(joints, inverses);
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
     * The transforms from the mesh's coordinates to the file's, one for each joint.
     *
     * @param placement from a node's coordinates to the file's
     */
    List<Affine> movements(IntFunction<Affine> placement) {
        return IntStream.range(0, joints.size())
                .mapToObj(joint -> placement.apply(joints.get(joint)).of(inverses.get(joint)))
                .toList();
    }
}
