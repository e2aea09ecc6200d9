package dev.twister.kernel;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import dev.twister.scene.Ground;
import dev.twister.scene.Integrator;
import dev.twister.scene.Material;
import dev.twister.scene.Mesh;
import dev.twister.scene.Rgb;
import dev.twister.scene.Rotation;
import dev.twister.scene.Scene;
import dev.twister.scene.Shape;
import dev.twister.scene.Sphere;
import dev.twister.scene.Vector3;
import dev.twister.scene.material.Finish;
import dev.twister.sky.Skybox;
import dev.twister.world.FrameInput;
import dev.twister.world.SceneImages;
import dev.twister.world.SceneMeshes;
import dev.twister.world.World;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** What rays meet of bodies that have a finish. */
class FinishedBodiesTest {
    private static final double ANGLE = 0.5;
    private static final Material BRUSHED = Material.DEFAULT
            .withMetallic(1)
            .withRoughness(0.5)
            .withFinish(Finish.NONE.withAnisotropy(
                    Finish.NONE.anisotropy().withStrength(1).withRotation(ANGLE)));

    private static final Material LEAF = Material.DEFAULT.withFinish(
            Finish.NONE.withThrough(Finish.NONE.through().withPart(0.5)));

    private final float[] scratch = new float[Layout.SCRATCH_LENGTH];

    /** The quad's images are upright from its front, which faces -z before it is turned. */
    @ParameterizedTest
    @CsvSource({"0, -1", "0, 1", "30, -1", "30, 1"})
    void theGrainOfAMeshFollowsItsTextureCoordinates(double yaw, float side) {
        Mesh quad = Mesh.of(Shape.of(Shape.Kind.QUAD, 2)).withMaterial(BRUSHED).withRotation(new Rotation(yaw, 0, 0));
        float[] path =
                met(scene().withMeshes(List.of(quad)), new float[] {0.1f, 5.2f, 3 * side}, new float[] {0, 0, -side});

        double turn = Math.toRadians(yaw);
        assertVector(path, Math.cos(ANGLE) * Math.cos(turn), Math.sin(ANGLE), -Math.cos(ANGLE) * Math.sin(turn));
    }

    /** The plane's images have their upper edge away from a camera that looks along z. */
    @ParameterizedTest
    @CsvSource({"1", "-1"})
    void theGrainOfThePlaneFollowsItsImages(float side) {
        Ground plane = Ground.of(10, 0, new Rgb(1, 1, 1), new Rgb(1, 1, 1), 0).withMaterial(BRUSHED);
        float[] path = met(scene().withGround(plane), new float[] {0.3f, 2 * side, 0.3f}, new float[] {0, -side, 0});

        assertVector(path, Math.cos(ANGLE), 0, Math.sin(ANGLE));
        assertThat(path[Layout.COAT_NORMAL + 1]).isEqualTo(side, within(1e-6f));
    }

    @Test
    void aRayInsideADiffuseSheetMeetsItsFarSide() {
        Scene scene = scene().withSpheres(List.of(
                Sphere.of(new Vector3(0, 5, 0), 1, new Rgb(1, 1, 1), 0).withMaterial(LEAF)));
        float[] path = new float[Layout.FINISHED_PATH_LENGTH];
        FrameInput traced = input(scene, Integrator.PATH);

        assertThat(inside(path, traced)).isEqualTo(Layout.FIRST_SPHERE);
        assertThat(path[Layout.DISTANCE]).isEqualTo(2, within(1e-6f));
        meet(path, Layout.FIRST_SPHERE, traced);
        assertThat(path[Layout.FROM_INSIDE]).isEqualTo(1);
        assertThat(path[Layout.IS_SHEET]).isEqualTo(Layout.SHEET_OF_BODY);

        FrameInput other = input(scene, Integrator.WHITTED);
        assertThat(inside(path, other)).isEqualTo(Layout.NOTHING);
    }

    /** What a ray meets that has passed into the sphere. */
    private int inside(float[] path, FrameInput input) {
        start(path, input, new float[] {0, 5, -1}, new float[] {0, 0, 1});
        path[Layout.LEAVING] = Layout.FIRST_SPHERE;
        path[Layout.INSIDE] = 1;
        return find(path, input);
    }

    private int find(float[] path, FrameInput input) {
        return Hit.find(
                path,
                scratch,
                input.view().frame(),
                input.bodies().floats(),
                input.bodies().looks(),
                input.bodies().meshes(),
                input.variant(true));
    }

    private float[] met(Scene scene, float[] origin, float[] direction) {
        FrameInput input = input(scene, Integrator.PATH);
        float[] path = new float[Layout.FINISHED_PATH_LENGTH];
        start(path, input, origin, direction);
        path[Layout.LEAVING] = Layout.NOTHING;
        int body = find(path, input);
        assertThat(body).isGreaterThan(Layout.NOTHING);
        meet(path, body, input);
        return path;
    }

    private static void start(float[] path, FrameInput input, float[] origin, float[] direction) {
        double[] shift = {
            input.bodies().origin().x(),
            input.bodies().origin().y(),
            input.bodies().origin().z()
        };
        for (int axis = 0; axis < 3; axis++) {
            path[Layout.ORIGIN + axis] = (float) (origin[axis] - shift[axis]);
            path[Layout.DIRECTION + axis] = direction[axis];
        }
        path[Layout.MEDIUM] = Layout.NOTHING;
        path[Layout.OUTER_MEDIUM] = Layout.NOTHING;
    }

    private static void meet(float[] path, int body, FrameInput input) {
        PathTracer.meet(
                path,
                body,
                input.view().frame(),
                input.bodies().floats(),
                input.bodies().looks(),
                input.bodies().meshes(),
                input.images(),
                input.variant(true));
    }

    /** Without a plane. */
    private static Scene scene() {
        return Scene.under(Path.of("none.hdr"))
                .withGround(Ground.of(0.001, -100, new Rgb(1, 1, 1), new Rgb(1, 1, 1), 0));
    }

    private static FrameInput input(Scene scene, Integrator integrator) {
        Scene shown = scene.withRendering(scene.rendering().withIntegrator(integrator))
                .withMeshes(scene.meshes().stream()
                        .map(mesh -> mesh.withPosition(new Vector3(0, 5, 0)))
                        .toList());
        SceneMeshes meshes = SceneMeshes.read(shown, _ -> {});
        SceneImages images = SceneImages.of(new Skybox(1, 1, new float[3]));
        return World.of(shown, images, meshes).snapshot();
    }

    private static void assertVector(float[] path, double x, double y, double z) {
        double sign = Math.signum(path[Layout.GRAIN] * x + path[Layout.GRAIN + 1] * y + path[Layout.GRAIN + 2] * z);
        assertThat(sign * path[Layout.GRAIN]).isEqualTo(x, within(1e-6));
        assertThat(sign * path[Layout.GRAIN + 1]).isEqualTo(y, within(1e-6));
        assertThat(sign * path[Layout.GRAIN + 2]).isEqualTo(z, within(1e-6));
    }
}
