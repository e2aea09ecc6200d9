package dev.twister.mesh.gltf;

import dev.twister.mesh.input.MeshLimits;
import java.io.IOException;
import java.util.HashMap;
import java.util.Map;

/** The accessors of a glTF file, each of which is opened once, however many primitives use it. */
final class GltfAccessors {
    private final GltfPlace root;
    private final GltfBuffers buffers;
    private final Map<Integer, GltfAccessor> opened = new HashMap<>();
    private long sparseElements;
    private long sharedElements;

    GltfAccessors(GltfPlace root, GltfBuffers buffers) {
        this.root = root;
        this.buffers = buffers;
    }

    /** The accessors in the file. */
    GltfPlace list() {
        return root.at("accessors");
    }

    /**
     * An accessor.
     *
     * @param number its number in the file
     * @param components required number of components per element
     */
    GltfAccessor at(GltfPlace number, int components) throws IOException {
        GltfPlace accessors = root.at("accessors");
        int index = number.index(accessors);
        GltfAccessor accessor = opened.get(index);
        if (accessor == null) {
            accessor = GltfAccessor.open(root, accessors.at(index), buffers);
            opened.put(index, accessor);
            checkSparse(accessor);
        }
        accessor.checkComponents(components);
        return accessor;
    }

    /** An accessor with three or four components. */
    GltfAccessor ofColors(GltfPlace number) throws IOException {
        GltfPlace accessors = root.at("accessors");
        boolean four =
                accessors.at(number.index(accessors)).at("type").textOr("").equals("VEC4");
        return at(number, four ? 4 : 3);
    }

    /**
     * Counts elements that are kept in memory for an animation, before they are read.
     *
     * @throws dev.twister.mesh.MeshException if they are too many for the file's bytes
     */
    void share(long elements, GltfPlace place) {
        sharedElements += elements;
        if (sharedElements > MeshLimits.trianglesOf(buffers.openedBytes())) {
            throw place.failure("brings the elements of animations to " + sharedElements + ", too many for the "
                    + buffers.openedBytes() + " bytes of the file's buffers");
        }
    }

    /** Each takes a byte or more, unless accessors share them to make a small file take much time and memory. */
    private void checkSparse(GltfAccessor accessor) {
        sparseElements += accessor.sparseElements();
        if (sparseElements > buffers.openedBytes()) {
            throw accessor.place()
                    .failure("shares its sparse elements with other accessors, which together are more than the file's"
                            + " bytes");
        }
    }
}
