package dev.twister.kernel;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.mesh.TriangleMesh;
import dev.twister.oracle.MeshShapes;
import dev.twister.scene.Mesh;
import dev.twister.scene.Rotation;
import dev.twister.scene.Scene;
import dev.twister.scene.Vector3;
import dev.twister.sky.Skybox;
import dev.twister.world.Bodies;
import dev.twister.world.MeshLeaves;
import dev.twister.world.SceneImages;
import dev.twister.world.SceneMeshes;
import dev.twister.world.World;
import java.nio.file.Path;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;

/** Rays against meshes: none slips between triangles, and traversal finds what brute force finds. */
class MeshHitTest {
    private static final int MESHES = 40;
    private static final int RAYS = 400;

    private final float[] scratch = new float[Layout.SCRATCH_LENGTH];

    @Test
    void noRayPassesBetweenTheTrianglesOfAClosedMesh() {
        for (int seed = 0; seed < MESHES; seed++) {
            Random random = new Random(seed);
            TriangleMesh mesh = MeshShapes.blob(random, 1 + random.nextInt(3));
            Mesh placed = mesh(random);
            Bodies bodies = bodies(mesh, placed);
            Vector3 origin = placed.position();
            for (int ray = 0; ray < RAYS; ray++) {
                float[] aim = aim(mesh, random);
                float[] path = Paths.ray(
                        new float[] {(float) origin.x(), (float) origin.y(), (float) origin.z()},
                        direction(bodies, aim),
                        Layout.NOTHING);
                assertThat(find(path, bodies))
                        .as("ray %d of seed %d", ray, seed)
                        .isEqualTo(bodies.firstMesh());
            }
        }
    }

    /** A ray from the mesh's center, in world space, to a vertex or a point on an edge. */
    private static float[] aim(TriangleMesh mesh, Random random) {
        int triangle = random.nextInt(mesh.triangles());
        int a = mesh.corners()[3 * triangle];
        int b = mesh.corners()[3 * triangle + 1];
        float part = random.nextInt(3) == 0 ? 0 : random.nextFloat();
        float[] aim = new float[3];
        for (int axis = 0; axis < 3; axis++) {
            aim[axis] = mesh.positions()[3 * a + axis]
                    + part * (mesh.positions()[3 * b + axis] - mesh.positions()[3 * a + axis]);
        }
        return aim;
    }

    private static float[] direction(Bodies bodies, float[] aim) {
        int row = Instance.at(0, bodies.instances(), bodies.floats()) + Layout.INSTANCE_TO_WORLD;
        float[] direction = new float[3];
        float squared = 0;
        for (int axis = 0; axis < 3; axis++) {
            direction[axis] = Instance.vector(bodies.floats(), row + 4 * axis, aim[0], aim[1], aim[2]);
            squared += direction[axis] * direction[axis];
        }
        for (int axis = 0; axis < 3; axis++) {
            direction[axis] *= KernelMath.inverseRoot(squared);
        }
        return direction;
    }

    @Test
    void walkFindsWhatThePlainLoopFinds() {
        for (int seed = 0; seed < MESHES; seed++) {
            Random random = new Random(seed);
            TriangleMesh mesh = switch (random.nextInt(3)) {
                case 0 -> MeshShapes.soup(random, 1 + random.nextInt(300));
                case 1 -> MeshShapes.cube();
                default -> MeshShapes.blob(random, 2);
            };
            Mesh placed = mesh(random);
            Bodies walked = bodies(mesh, placed);
            Bodies plain = MeshLeaves.ofOne(walked);
            for (int ray = 0; ray < RAYS; ray++) {
                float[] path = ray(random, placed);
                int leaving = random.nextInt(mesh.triangles());
                path[Layout.LEAVING_TRIANGLE] = leaving;
                int expected = find(path, plain);
                float distance = path[Layout.DISTANCE];
                float triangle = path[Layout.TRIANGLE];
                assertThat(find(path, walked))
                        .as("ray %d of seed %d", ray, seed)
                        .isEqualTo(expected);
                assertThat(path[Layout.DISTANCE]).isEqualTo(distance);
                assertThat(path[Layout.TRIANGLE]).isEqualTo(triangle);
                assertThat(expected == walked.firstMesh() && triangle == leaving)
                        .isFalse();
            }
        }
    }

    private static Mesh mesh(Random random) {
        return Mesh.of(Path.of("mesh"))
                .withPosition(new Vector3(between(random, 9), between(random, 9), between(random, 9)))
                .withRotation(new Rotation(between(random, 180), between(random, 90), between(random, 180)))
                .withScale(Math.pow(10, between(random, 2)));
    }

    /** A ray toward the mesh from a random point, or along an axis. */
    private static float[] ray(Random random, Mesh placed) {
        float[] direction = new float[3];
        float[] origin = new float[3];
        Vector3 center = placed.position();
        float[] centers = {(float) center.x(), (float) center.y(), (float) center.z()};
        boolean along = random.nextInt(4) == 0;
        int axisAlong = random.nextInt(3);
        float squared = 0;
        for (int axis = 0; axis < 3; axis++) {
            direction[axis] = along ? (axis == axisAlong ? 1 : 0) : (float) random.nextGaussian();
            squared += direction[axis] * direction[axis];
        }
        for (int axis = 0; axis < 3; axis++) {
            direction[axis] *= KernelMath.inverseRoot(squared);
            origin[axis] = (float) (centers[axis] + placed.scale() * (between(random, 1) - 3 * direction[axis]));
        }
        return Paths.ray(origin, direction, Layout.FIRST_SPHERE);
    }

    private static double between(Random random, double reach) {
        return reach * (2 * random.nextDouble() - 1);
    }

    private static Bodies bodies(TriangleMesh mesh, Mesh placed) {
        Scene scene = Scene.under(Path.of("none.hdr")).withMeshes(List.of(placed));
        SceneMeshes meshes = SceneMeshes.of(scene, source -> MeshShapes.file(mesh));
        return World.of(scene, SceneImages.of(new Skybox(1, 1, new float[3])), meshes)
                .snapshot()
                .bodies();
    }

    /** Intersects the mesh alone, without plane and light. */
    private int find(float[] path, Bodies bodies) {
        path[Layout.DISTANCE] = Intersection.MISS;
        float[] frame = new float[Layout.DISC];
        frame[Layout.INSTANCES] = bodies.instances();
        return MeshHit.find(
                path, Layout.NOTHING, scratch, frame, bodies.floats(), bodies.looks(), bodies.meshes(), Variant.MESHES);
    }
}
