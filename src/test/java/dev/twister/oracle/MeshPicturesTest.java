package dev.twister.oracle;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.engine.JvmEngines;
import dev.twister.mesh.Affine;
import dev.twister.mesh.MeshFile;
import dev.twister.mesh.MeshPart;
import dev.twister.mesh.TriangleMesh;
import dev.twister.scene.Camera;
import dev.twister.scene.Ground;
import dev.twister.scene.Light;
import dev.twister.scene.Material;
import dev.twister.scene.Mesh;
import dev.twister.scene.Rendering;
import dev.twister.scene.Rgb;
import dev.twister.scene.Rotation;
import dev.twister.scene.Scene;
import dev.twister.scene.Sphere;
import dev.twister.scene.Vector3;
import dev.twister.scene.light.Lights;
import dev.twister.sky.Skybox;
import dev.twister.world.SceneImages;
import dev.twister.world.SceneMeshes;
import dev.twister.world.StageOrView;
import java.nio.file.Path;
import java.util.List;
import java.util.function.IntFunction;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;

/** Compares meshes with spheres, the plane and copies of themselves, and their views with the oracle. */
class MeshPicturesTest {
    private static final int WIDTH = 90;
    private static final int HEIGHT = 60;
    private static final Path FILE = Path.of("shape.obj");
    private static final Skybox SKY =
            new Skybox(2, 2, new float[] {0.2f, 0.4f, 0.9f, 0.9f, 0.5f, 0.2f, 0.3f, 0.3f, 0.3f, 0.1f, 0.2f, 0.1f});
    private static final Material MATTE = Material.DEFAULT.withColor(new Rgb(0.8, 0.5, 0.3));

    private static Scene scene() {
        return Scene.under(Path.of("none.hdr"))
                .withCamera(Camera.of(new Vector3(0.3, 1.2, -5), 3, 8, 40))
                .withLights(Lights.of(Light.of(new Vector3(-3, 5, -4), 0.5, new Rgb(1, 1, 1))))
                .withGround(Ground.of(20, -1, new Rgb(0.7, 0.7, 0.7), new Rgb(0.3, 0.3, 0.3), 0))
                .withRendering(Rendering.DEFAULT
                        .withSize(WIDTH, HEIGHT)
                        .withShadowSamples(12)
                        .withBounces(4));
    }

    private static LitScene with(Scene scene, MeshFile file) {
        return new LitScene(scene, SceneImages.of(SKY), SceneMeshes.of(scene, source -> file));
    }

    private static LitScene with(Scene scene, TriangleMesh mesh) {
        return with(scene, MeshShapes.file(mesh));
    }

    private static PictureDifference difference(LitScene one, LitScene other) {
        return PictureDifference.between(
                Pictures.argb(JvmEngines.SEQUENTIAL, one), Pictures.argb(JvmEngines.SEQUENTIAL, other));
    }

    @ParameterizedTest(name = "{0}, transmission {1}")
    @CsvSource({"icosahedron, 0", "icosahedron, 1", "cube, 0", "cube, 1"})
    void solidsConvergeToTheSphere(String solid, double transmission) {
        IntFunction<TriangleMesh> shape = solid.equals("cube") ? MeshShapes::cubeSphere : MeshShapes::icosphere;
        Material material = MATTE.withReflectivity(transmission > 0 ? 0 : 60).withTransmission(transmission);
        LitScene sphere = new LitScene(
                scene().withSpheres(List.of(
                        Sphere.of(new Vector3(0, 0, 0), 1, new Rgb(1, 1, 1), 0).withMaterial(material))),
                SKY);
        Scene shown = scene().withMeshes(List.of(Mesh.of(FILE).withMaterial(material)));
        int coarse = difference(sphere, with(shown, shape.apply(3))).differing().length;
        int fine = difference(sphere, with(shown, shape.apply(5))).differing().length;
        assertThat(fine).isLessThan(coarse / 2).isLessThan(WIDTH * HEIGHT / 50);
    }

    @Test
    void twoTrianglesEqualThePlane() {
        Scene plane = scene().withGround(Ground.of(6, -1, MATTE.color(), MATTE.color(), 40))
                .withSpheres(List.of(Sphere.of(new Vector3(0, 0, 0), 1, new Rgb(0.2, 0.8, 0.4), 30)));
        Scene square = plane.withGround(Ground.of(1e-3, -900, MATTE.color(), MATTE.color(), 40))
                .withMeshes(List.of(Mesh.of(FILE)
                        .withPosition(new Vector3(0, -1, 0))
                        .withScale(3)
                        .withMaterial(MATTE.withReflectivity(40))));
        assertThat(difference(new LitScene(plane, SKY), with(square, MeshShapes.square())))
                .matches(PictureDifference::isWithinBound);
    }

    @Test
    void instancesEqualCopies() {
        TriangleMesh cube = MeshShapes.cube();
        float[] twice = new float[2 * cube.positions().length];
        int[] corners = new int[2 * cube.corners().length];
        for (int i = 0; i < cube.positions().length; i++) {
            twice[i] = cube.positions()[i];
            twice[cube.positions().length + i] = cube.positions()[i] + (i % 3 == 0 ? 3 : 0);
        }
        for (int i = 0; i < cube.corners().length; i++) {
            corners[i] = cube.corners()[i];
            corners[cube.corners().length + i] = cube.vertices() + cube.corners()[i];
        }
        TriangleMesh copies = new TriangleMesh(twice, new float[0], new float[0], corners);
        Affine aside = new Affine(
                Affine.IDENTITY.axisX(), Affine.IDENTITY.axisY(), Affine.IDENTITY.axisZ(), new Vector3(3, 0, 0));
        Material mirror = MATTE.withReflectivity(90);
        MeshFile instances = MeshShapes.file(
                List.of(cube),
                List.of(new MeshPart("", 0, Affine.IDENTITY, mirror), new MeshPart("", 0, aside, mirror)));
        Scene scene = scene().withMeshes(List.of(Mesh.of(FILE)
                .withScale(0.5)
                .withRotation(new Rotation(20, 10, 30))
                .withMaterial(mirror)));
        assertThat(difference(with(scene, instances), with(scene, copies))).matches(PictureDifference::isWithinBound);
    }

    @ParameterizedTest
    @EnumSource(StageOrView.class)
    void viewsAreTheOracles(StageOrView picture) {
        if (picture == StageOrView.TESTS) {
            return;
        }
        Scene scene = scene().withSpheres(List.of(Sphere.of(new Vector3(1.5, -0.5, 0.5), 0.5, new Rgb(1, 1, 1), 20)))
                .withMeshes(List.of(
                        Mesh.of(FILE).withMaterial(MATTE.withTransmission(0.7)),
                        Mesh.of(FILE).withPosition(new Vector3(-2, 0, 1)).withMaterial(MATTE.withReflectivity(50))));
        Rendering settings = scene.rendering();
        Scene stage = switch (picture) {
            case HARD_SHADOWS -> scene.withRendering(settings.withBounces(0).withShadowSamples(1));
            case SOFT_SHADOWS -> scene.withRendering(settings.withBounces(0));
            default -> scene;
        };
        LitScene lit = with(scene, MeshShapes.icosphere(0));
        float[] actual =
                Pictures.radiance(JvmEngines.SEQUENTIAL, lit.world().snapshot().showing(picture));
        Oracle oracle = new Oracle(new LitScene(stage, lit.images(), lit.meshes()));
        int odd = 0;
        for (int pixel = 0; pixel < WIDTH * HEIGHT; pixel++) {
            Color expected = switch (picture) {
                case HARD_SHADOWS, SOFT_SHADOWS, BEAUTY -> Color.of(oracle.radiance(pixel % WIDTH, pixel / WIDTH));
                default -> oracle.value(pixel % WIDTH, pixel / WIDTH, picture);
            };
            odd += Math.abs(actual[3 * pixel] - expected.red()) > 0.004 * Math.max(1, Math.abs(expected.red())) ? 1 : 0;
        }
        assertThat(odd).isLessThan(WIDTH * HEIGHT / 250);
    }
}
