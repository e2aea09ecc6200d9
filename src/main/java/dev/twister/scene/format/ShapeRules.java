package dev.twister.scene.format;

import dev.twister.scene.Mesh;
import dev.twister.scene.SceneException;
import dev.twister.scene.Shape;
import dev.twister.scene.Vector3;
import dev.twister.scene.format.json.JsonText;
import dev.twister.scene.property.Range;
import dev.twister.scene.property.SceneLimits;
import java.util.List;
import java.util.function.Function;

/** What the sizes of shapes have to be. */
final class ShapeRules {
    static final String MESHES = "meshes";

    private ShapeRules() {}

    /**
     * @param scene its fields, in the file
     * @throws SceneException if a shape cannot have its size
     */
    static void check(List<Mesh> meshes, Fields scene) {
        for (int index = 0; index < meshes.size(); index++) {
            if (meshes.get(index).geometry() instanceof Shape shape && !isPossible(shape)) {
                List<Place> places = scene.get(MESHES).items(0, meshes.size(), "", Function.identity());
                Place size = places.get(index).fields().get(MeshFields.SIZE);
                throw size.failure(text(shape.size()) + allowed(shape));
            }
        }
    }

    private static boolean isPossible(Shape shape) {
        Vector3 size = shape.size();
        Range length = SceneLimits.LENGTH;
        boolean wide = length.contains(size.x()) && length.contains(size.y());
        boolean deep = shape.kind() == Shape.Kind.QUAD ? size.z() == 0 : length.contains(size.z());
        // A ring without a hole has triangles without an area.
        boolean open = shape.kind() != Shape.Kind.TORUS || size.y() < size.x() / 2;
        return wide && deep && open;
    }

    private static String text(Vector3 size) {
        return "is [" + JsonText.number(size.x()) + ", " + JsonText.number(size.y()) + ", " + JsonText.number(size.z())
                + "], but ";
    }

    private static String allowed(Shape shape) {
        return switch (shape.kind()) {
            case QUAD -> "the size of a quad must be [x, y, 0], with x and y " + SceneLimits.LENGTH;
            case TORUS -> "the size of a torus must be [x, y, z] " + SceneLimits.LENGTH + ", with y below half of x";
            default -> "the size of a " + shape.name() + " must be numbers " + SceneLimits.LENGTH;
        };
    }
}
