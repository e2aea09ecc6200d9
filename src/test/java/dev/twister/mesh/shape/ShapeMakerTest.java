package dev.twister.mesh.shape;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import dev.twister.mesh.Box;
import dev.twister.mesh.TriangleMesh;
import dev.twister.scene.Shape;
import dev.twister.scene.Vector3;
import java.util.HashMap;
import java.util.Map;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;

class ShapeMakerTest {
    private record Edge(Vector3 from, Vector3 to) {}

    @ParameterizedTest
    @EnumSource(
            value = Shape.Kind.class,
            mode = EnumSource.Mode.EXCLUDE,
            names = {"QUAD"})
    void everyEdgeOfAClosedShapeHasATriangleOnEachSide(Shape.Kind kind) {
        TriangleMesh mesh = mesh(kind);
        Map<Edge, Integer> edges = new HashMap<>();
        for (int corner = 0; corner < mesh.corners().length; corner++) {
            int next = corner % 3 == 2 ? corner - 2 : corner + 1;
            edges.merge(new Edge(position(mesh, corner), position(mesh, next)), 1, Integer::sum);
        }

        assertThat(edges.values()).allMatch(count -> count == 1);
        assertThat(edges.keySet()).allMatch(edge -> edges.containsKey(new Edge(edge.to(), edge.from())));
    }

    @ParameterizedTest
    @CsvSource({
        "BOX, 1, 1e-9",
        // Half of the width, height and depth, and pi / 4 of the circle's square.
        "CYLINDER, 0.785398, 5e-4",
        "CONE, 0.261799, 5e-4",
        // 2 pi^2 R r^2 with R = 0.375 and r = 0.125.
        "TORUS, 0.115659, 5e-3",
        "ICOSPHERE, 0.523599, 1e-3"
    })
    void trianglesOfAClosedShapeFaceOutward(Shape.Kind kind, double volume, double error) {
        TriangleMesh mesh = mesh(kind);
        double sum = 0;
        for (int corner = 0; corner < mesh.corners().length; corner += 3) {
            sum += position(mesh, corner).dot(position(mesh, corner + 1).cross(position(mesh, corner + 2))) / 6;
        }

        assertThat(sum).isCloseTo(volume, within(volume * error));
    }

    @ParameterizedTest
    @EnumSource(Shape.Kind.class)
    void normalsAreUnitVectorsOnTheSideOfTheFace(Shape.Kind kind) {
        TriangleMesh mesh = mesh(kind);
        for (int corner = 0; corner < mesh.corners().length; corner++) {
            int first = corner - corner % 3;
            Vector3 a = position(mesh, first);
            Vector3 face = position(mesh, first + 1)
                    .minus(a)
                    .cross(position(mesh, first + 2).minus(a))
                    .normalized();
            Vector3 normal = vector(mesh.normals(), mesh.corners()[corner]);

            assertThat(normal.length()).isCloseTo(1, within(1e-6));
            // Smooth, or flat: no normal is far from its triangle's.
            assertThat(normal.dot(face)).isGreaterThan(0.99);
        }
    }

    @ParameterizedTest
    @EnumSource(Shape.Kind.class)
    void aShapeFillsItsBox(Shape.Kind kind) {
        Box bounds = ShapeMaker.file(Shape.of(kind, 1)).bounds();

        assertThat(bounds.half().times(2)).isEqualTo(kind.unit());
        assertThat(bounds.center()).isEqualTo(Vector3.ZERO);
    }

    @ParameterizedTest
    @EnumSource(Shape.Kind.class)
    void texturesAreNotStretchedOverASeam(Shape.Kind kind) {
        TriangleMesh mesh = mesh(kind);
        for (int corner = 0; corner < mesh.corners().length; corner += 3) {
            // Around a pole, the texture of a globe is as wide as its triangle is seen from the axis.
            for (int other = 1; other < 3 && kind == Shape.Kind.ICOSPHERE; other++) {
                assertThat(u(mesh, corner + other)).isCloseTo(u(mesh, corner), within(0.2));
            }
            assertThat(u(mesh, corner)).isBetween(-0.5, 1.5);
        }
    }

    private static TriangleMesh mesh(Shape.Kind kind) {
        return ShapeMaker.file(Shape.of(kind, 1)).meshes().getFirst();
    }

    private static Vector3 position(TriangleMesh mesh, int corner) {
        return vector(mesh.positions(), mesh.corners()[corner]);
    }

    private static double u(TriangleMesh mesh, int corner) {
        return mesh.textureCoordinates()[2 * mesh.corners()[corner]];
    }

    /** Zeros of both signs are one place. */
    private static Vector3 vector(float[] floats, int vertex) {
        return new Vector3(0.0 + floats[3 * vertex], 0.0 + floats[3 * vertex + 1], 0.0 + floats[3 * vertex + 2]);
    }
}
