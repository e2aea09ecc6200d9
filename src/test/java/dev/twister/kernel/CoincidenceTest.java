package dev.twister.kernel;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.mesh.TriangleMesh;
import dev.twister.oracle.MeshShapes;
import dev.twister.scene.Geometry;
import dev.twister.scene.Ground;
import dev.twister.scene.Mesh;
import dev.twister.scene.Rotation;
import dev.twister.scene.Scene;
import dev.twister.scene.Vector3;
import dev.twister.sky.Skybox;
import dev.twister.world.FrameInput;
import dev.twister.world.SceneImages;
import dev.twister.world.SceneMeshes;
import dev.twister.world.World;
import java.nio.file.Path;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;

/** Rays at faces that lie in one plane. */
class CoincidenceTest {
    private static final int RAYS = 2000;
    private static final double BELOW = -20;
    private static final Rotation TILTED = new Rotation(40, 17, 65);
    private static final Path SQUARE = Path.of("square");
    private static final Path TRIANGLE = Path.of("triangle");
    private static final Path DOUBLE = Path.of("double");

    private final float[] path = new float[Layout.PATH_LENGTH];
    private final float[] scratch = new float[Layout.SCRATCH_LENGTH];
    private final Random random = new Random(1);

    @Test
    void lowerBodyIsSeen() {
        for (List<Path> files : List.of(List.of(SQUARE, TRIANGLE), List.of(TRIANGLE, SQUARE))) {
            FrameInput input =
                    input(files.stream().map(file -> placed(file, TILTED, 0)).toList(), BELOW);
            for (int ray = 0; ray < RAYS; ray++) {
                assertThat(seen(input)).isEqualTo(input.bodies().firstMesh());
            }
        }
    }

    @Test
    void lowerTriangleIsSeen() {
        FrameInput input = input(List.of(placed(DOUBLE, TILTED, 0)), BELOW);
        for (int ray = 0; ray < RAYS; ray++) {
            assertThat(seen(input)).isEqualTo(input.bodies().firstMesh());
            assertThat(path[Layout.TRIANGLE]).isEqualTo(lowestTriangle(input));
        }
    }

    private float lowestTriangle(FrameInput input) {
        float[] bodies = input.bodies().floats();
        int instance = Instance.at(0, input.bodies().instances(), bodies);
        MeshRay.enter(
                path,
                instance,
                path[Layout.ORIGIN],
                path[Layout.ORIGIN + 1],
                path[Layout.ORIGIN + 2],
                path[Layout.DIRECTION],
                path[Layout.DIRECTION + 1],
                path[Layout.DIRECTION + 2],
                bodies);
        int triangles = Instance.triangles(bodies, instance);
        int lowest = 0;
        while (Triangle.distance(
                        path,
                        triangles + Layout.TRIANGLE_STRIDE * lowest,
                        input.bodies().meshes())
                == Intersection.MISS) {
            lowest++;
        }
        return lowest;
    }

    @Test
    void planeIsSeenBelowAMeshOnIt() {
        FrameInput input = input(List.of(placed(SQUARE, Rotation.NONE, 0)), 0);
        for (int ray = 0; ray < RAYS; ray++) {
            assertThat(seen(input)).isEqualTo(Layout.PLANE);
        }
    }

    @Test
    void closerOfTwoParallelFacesIsSeen() {
        FrameInput input =
                input(List.of(placed(SQUARE, Rotation.NONE, 0), placed(TRIANGLE, Rotation.NONE, 1e-3)), BELOW);
        for (int ray = 0; ray < RAYS; ray++) {
            int body = seen(input);
            int upper = path[Layout.ORIGIN + 1] > 0f ? 1 : 0;
            assertThat(body).isEqualTo(input.bodies().firstMesh() + upper);
        }
    }

    private static Mesh placed(Path file, Rotation rotation, double height) {
        return Mesh.of(file).withPosition(new Vector3(0, height, 0)).withRotation(rotation);
    }

    private static FrameInput input(List<Mesh> placed, double groundHeight) {
        Scene scene = Scene.under(Path.of("none.hdr"))
                .withGround(Ground.DEFAULT.withHeight(groundHeight))
                .withMeshes(placed);
        SceneMeshes meshes = SceneMeshes.of(scene, source -> MeshShapes.file(shape(source.geometry())));
        return World.of(scene, SceneImages.of(new Skybox(1, 1, new float[3])), meshes)
                .snapshot();
    }

    /** A square of side 2, a triangle around it, or the square's triangles twice with other first corners. */
    private static TriangleMesh shape(Geometry file) {
        TriangleMesh square = MeshShapes.square();
        TriangleMesh other = file.equals(new Geometry.OfFile(DOUBLE))
                ? new TriangleMesh(
                        square.positions(), new float[0], new float[0], new int[] {0, 2, 1, 1, 2, 3, 2, 1, 0, 3, 1, 2})
                : new TriangleMesh(
                        new float[] {-3.1f, 0, -2.3f, 3.3f, 0, -2.9f, 0.2f, 0, 4.7f},
                        new float[0],
                        new float[0],
                        new int[] {0, 1, 2});
        return file.equals(new Geometry.OfFile(SQUARE)) ? square : other;
    }

    /** The body that a random ray through the square's middle, at least 6 degrees steep, meets. */
    private int seen(FrameInput input) {
        float[] away = new float[3];
        float steepness = 0f;
        while (steepness < 0.1f) {
            float squared = 0f;
            for (int axis = 0; axis < 3; axis++) {
                away[axis] = (float) random.nextGaussian();
                squared += away[axis] * away[axis];
            }
            for (int axis = 0; axis < 3; axis++) {
                away[axis] /= (float) Math.sqrt(squared);
            }
            steepness = Math.abs(steepness(input, away));
        }
        float reach = 3f + 9f * random.nextFloat();
        float[] middle = inWorld(input, random.nextFloat() - 0.5f, 0f, random.nextFloat() - 0.5f);
        for (int axis = 0; axis < 3; axis++) {
            path[Layout.ORIGIN + axis] = middle[axis] + reach * away[axis];
            path[Layout.DIRECTION + axis] = -away[axis];
        }
        path[Layout.LEAVING] = Layout.LIGHT;
        return Hit.find(
                path,
                scratch,
                input.view().frame(),
                input.bodies().floats(),
                input.bodies().looks(),
                input.bodies().meshes(),
                input.variant(false));
    }

    private static float[] inWorld(FrameInput input, float x, float y, float z) {
        float[] bodies = input.bodies().floats();
        int row = Instance.at(0, input.bodies().instances(), bodies) + Layout.INSTANCE_TO_WORLD;
        float[] point = new float[3];
        for (int axis = 0; axis < 3; axis++) {
            point[axis] = Instance.point(bodies, row + 4 * axis, x, y, z);
        }
        return point;
    }

    private static float steepness(FrameInput input, float[] direction) {
        float[] bodies = input.bodies().floats();
        int row = Instance.at(0, input.bodies().instances(), bodies) + Layout.INSTANCE_TO_MESH;
        return Instance.vector(bodies, row + 4, direction[0], direction[1], direction[2]);
    }
}
