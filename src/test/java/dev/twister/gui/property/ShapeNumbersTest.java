package dev.twister.gui.property;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.gui.edit.BodyNumber;
import dev.twister.gui.edit.Scenes;
import dev.twister.scene.Mesh;
import dev.twister.scene.Scene;
import dev.twister.scene.Shape;
import dev.twister.scene.Vector3;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** The sides of shapes as numbers of the panel. */
class ShapeNumbersTest {
    private static final int BODY = BodyNumber.ofMesh(0);

    private static Scene with(Mesh mesh) {
        return Scenes.scene().withMeshes(List.of(mesh));
    }

    private static List<NumberProperty<Scene>> sides(Scene scene) {
        return PropertyNumbers.ofBody(scene, BODY).stream()
                .filter(number -> number.label().startsWith("Shape"))
                .toList();
    }

    private static Vector3 size(Scene scene) {
        return ((Shape) scene.meshes().getFirst().geometry()).size();
    }

    @ParameterizedTest
    @EnumSource(Shape.Kind.class)
    void eachSideIsWrittenAlone(Shape.Kind kind) {
        Scene scene = with(Mesh.of(Shape.of(kind, 2)));
        List<NumberProperty<Scene>> sides = sides(scene);

        assertThat(sides).hasSize(kind == Shape.Kind.QUAD ? 2 : 3);
        Vector3 size = size(scene);
        assertThat(size(sides.get(0).write(scene, 3))).isEqualTo(new Vector3(3, size.y(), size.z()));
        assertThat(size(sides.get(1).write(scene, 0.75))).isEqualTo(new Vector3(size.x(), 0.75, size.z()));
        if (kind != Shape.Kind.QUAD) {
            assertThat(size(sides.get(2).write(scene, 5))).isEqualTo(new Vector3(size.x(), size.y(), 5));
        }
    }

    @Test
    void theHoleOfATorusStaysOpen() {
        Scene scene = with(Mesh.of(Shape.of(Shape.Kind.TORUS, 2)));

        Scene high = sides(scene).get(1).write(scene, 7);
        assertThat(size(high).y()).isLessThan(1);
        Scene narrow = sides(scene).get(0).write(scene, 0.1);
        assertThat(size(narrow).x()).isGreaterThan(2 * size(scene).y());
    }

    @Test
    void aMeshFileHasNoSides() {
        assertThat(sides(with(Mesh.of(Path.of("ball.obj"))))).isEmpty();
    }
}
