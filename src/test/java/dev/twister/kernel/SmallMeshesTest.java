package dev.twister.kernel;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import dev.twister.oracle.MeshShapes;
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
import java.util.Random;
import java.util.stream.IntStream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.RepeatedTest;
import org.junit.jupiter.api.RepetitionInfo;

/** Meshes of one leaf are met in the world's coordinates where they are met in their own. */
class SmallMeshesTest {
    private static final int MESHES = 9;
    private static final int RAYS = 300;
    private static final double BELOW = -1e4;

    private final float[] path = new float[Layout.PATH_LENGTH];
    private final float[] scratch = new float[Layout.SCRATCH_LENGTH];
    private Random random;
    private FrameInput input;
    private float[] bodies;
    private int instances;

    @BeforeEach
    void placeMeshes(RepetitionInfo repetition) {
        random = new Random(repetition.getCurrentRepetition());
        Scene scene = Scene.under(Path.of("none.hdr"))
                .withGround(Ground.DEFAULT.withHeight(BELOW))
                .withMeshes(IntStream.range(0, MESHES).mapToObj(this::placed).toList());
        SceneMeshes meshes = SceneMeshes.of(
                scene,
                source -> MeshShapes.file(
                        source.toString().contains("square")
                                ? MeshShapes.square()
                                : MeshShapes.soup(
                                        new Random(source.hashCode()), 1 + Math.floorMod(source.hashCode(), 4))));
        input = World.of(scene, SceneImages.of(new Skybox(1, 1, new float[3])), meshes)
                .snapshot();
        bodies = input.bodies().floats();
        instances = input.bodies().instances();
    }

    private Mesh placed(int number) {
        return Mesh.of(Path.of(number % 2 == 0 ? "square" : "soup" + number))
                .withPosition(new Vector3(between(20), between(20), between(20)))
                .withRotation(new Rotation(between(180), between(90), between(180)))
                .withScale(Math.pow(10, between(1)));
    }

    private double between(double reach) {
        return reach * (2 * random.nextDouble() - 1);
    }

    @RepeatedTest(8)
    void eachLeafHasTheTrianglesOfItsInstance() {
        int small = 0;
        for (int node = 0; node < 2 * MESHES - 1; node++) {
            small += bodies[instances + 1 + Layout.NODE_STRIDE * node + Layout.NODE_SPHERES] > 0f ? 1 : 0;
        }
        assertThat(small).isEqualTo(MESHES);
    }

    @RepeatedTest(8)
    void raysMeetWhatTheyMeetInTheMeshesCoordinates() {
        int hits = 0;
        for (int ray = 0; ray < RAYS; ray++) {
            aim();
            float expected = nearest();
            int body = find();
            assertThat(path[Layout.DISTANCE]).isCloseTo(expected, within(1e-4f * (1f + Math.min(expected, 1e3f))));
            hits += body == Layout.NOTHING ? 0 : 1;
        }
        assertThat(hits).isGreaterThan(RAYS / 10);
    }

    /** A ray that starts on a mesh, even on an edge between two of its triangles, doesn't meet it at once. */
    @RepeatedTest(8)
    void raysLeaveTheMeshThatTheyStartOn() {
        for (int ray = 0; ray < RAYS; ray++) {
            aim();
            int body = find();
            if (body != Layout.NOTHING) {
                leave(body);
                int next = find();
                assertThat(next == body && path[Layout.DISTANCE] < 1e-3f).isFalse();
            }
        }
    }

    private void leave(int body) {
        int triangle = (int) path[Layout.TRIANGLE];
        int instance = Instance.at((int) path[Layout.INSTANCE], instances, bodies);
        assertThat((int) bodies[instance + Layout.INSTANCE_BODY]).isEqualTo(body);
        MeshSurface.find(path, input.view().frame(), bodies, input.bodies().meshes(), input.variant(false));
        for (int axis = 0; axis < 3; axis++) {
            path[Layout.ORIGIN + axis] = path[Layout.POINT + axis];
            path[Layout.DIRECTION + axis] += 0.3f * (float) random.nextGaussian();
        }
        path[Layout.LEAVING] = body;
        path[Layout.LEAVING_TRIANGLE] = triangle;
    }

    /** A ray from anywhere to a point of a mesh, which may be on an edge. */
    private void aim() {
        int number = random.nextInt(MESHES);
        int row = Instance.at(number, instances, bodies) + Layout.INSTANCE_TO_WORLD;
        float x = random.nextFloat() - 0.5f;
        float z = random.nextInt(4) == 0 ? x : random.nextFloat() - 0.5f;
        float squared = 0f;
        for (int axis = 0; axis < 3; axis++) {
            path[Layout.ORIGIN + axis] = (float) between(30);
            path[Layout.DIRECTION + axis] =
                    Instance.point(bodies, row + 4 * axis, x, 0f, z) - path[Layout.ORIGIN + axis];
            squared += path[Layout.DIRECTION + axis] * path[Layout.DIRECTION + axis];
        }
        for (int axis = 0; axis < 3; axis++) {
            path[Layout.DIRECTION + axis] /= (float) Math.sqrt(squared);
        }
        path[Layout.LEAVING] = Layout.LIGHT;
        path[Layout.LEAVING_TRIANGLE] = Layout.NOTHING;
    }

    private int find() {
        path[Layout.DISTANCE] = Intersection.MISS;
        return MeshHit.find(
                path,
                Layout.NOTHING,
                scratch,
                input.view().frame(),
                bodies,
                input.bodies().looks(),
                input.bodies().meshes(),
                input.variant(false));
    }

    /** Distance of the ray to the nearest triangle, tested in its mesh's coordinates. */
    private float nearest() {
        float nearest = Intersection.MISS;
        for (int number = 0; number < MESHES; number++) {
            int instance = Instance.at(number, instances, bodies);
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
            int at = Instance.triangles(bodies, instance);
            for (int triangle = 0; triangle < bodies[instance + Layout.INSTANCE_TRIANGLES]; triangle++) {
                nearest = Math.min(
                        nearest,
                        Triangle.distance(
                                path,
                                at + Layout.TRIANGLE_STRIDE * triangle,
                                input.bodies().meshes()));
            }
        }
        return nearest;
    }
}
