package dev.twister.oracle;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.engine.JvmEngines;
import dev.twister.engine.vector.VectorEngines;
import dev.twister.mesh.Affine;
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
import dev.twister.scene.Vector3;
import dev.twister.scene.light.Lights;
import dev.twister.sky.Skybox;
import dev.twister.world.SceneImages;
import dev.twister.world.SceneMeshes;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Meshes whose sizes and distances strain the precision of floats. */
class ThinAndFarMeshesTest {
    private static final Path FILE = Path.of("shape.obj");
    private static final Skybox SKY = new Skybox(1, 1, new float[] {0.2f, 0.4f, 0.9f});
    private static final Material RED = Material.DEFAULT.withColor(new Rgb(0.9, 0.2, 0.1));
    private static final Rotation TILTED = new Rotation(40, 17, 65);

    /** Thickness of a wall, as a part of its side. */
    private static final double THIN = 1e-4;

    private static final int NEEDLES = 500;
    private static final double TO_100_KM = 1e4;

    private static Scene scene(double unit, Vector3 origin) {
        return Scene.under(Path.of("none.hdr"))
                .withCamera(Camera.of(new Vector3(-2.5, 2.5, -9.2).times(unit).plus(origin), 15, 15, 35))
                .withLights(Lights.of(
                        Light.of(new Vector3(-3, 6, -4).times(unit).plus(origin), 0.5 * unit, new Rgb(1, 1, 1))))
                .withGround(Ground.of(20 * unit, origin.y() - 1.8 * unit, RED.color(), RED.color(), 0))
                .withRendering(Rendering.DEFAULT
                        .withSize(120, 90)
                        .withShadowSamples(12)
                        .withBounces(1));
    }

    private static int[] picture(String engine, Scene scene, TriangleMesh mesh, Mesh placed) {
        Scene shown = scene.withMeshes(List.of(placed));
        SceneMeshes meshes = SceneMeshes.of(
                shown, _ -> MeshShapes.file(List.of(mesh), List.of(new MeshPart("", 0, Affine.IDENTITY, RED))));
        return Pictures.argb(engine, new LitScene(shown, SceneImages.of(SKY), meshes));
    }

    private static int[] picture(String engine, TriangleMesh mesh) {
        return picture(engine, scene(1, Vector3.ZERO), mesh, Mesh.of(FILE).withRotation(TILTED));
    }

    /** On a plane that is there, too, as planes lie around the y axis. */
    private static int[] pictureAt(String engine, Vector3 place) {
        Scene scene = scene(1, place);
        return picture(
                engine,
                scene.withGround(scene.ground().withSize(1e6)),
                MeshShapes.cube(),
                Mesh.of(FILE).withRotation(TILTED).withPosition(place));
    }

    private static TriangleMesh flat(float[] positions, int... corners) {
        return new TriangleMesh(positions, new float[0], new float[0], corners);
    }

    /** A cube of side 2 with a wall: a second cube within it. */
    private static TriangleMesh hollow() {
        TriangleMesh cube = MeshShapes.cube();
        float[] outer = cube.positions();
        float[] positions = Arrays.copyOf(outer, 2 * outer.length);
        for (int i = 0; i < outer.length; i++) {
            positions[outer.length + i] = (float) (outer[i] * (1 - 2 * THIN));
        }
        int[] once = cube.corners();
        int[] corners = Arrays.copyOf(once, 2 * once.length);
        for (int i = 0; i < once.length; i++) {
            corners[once.length + i] = once[i] + cube.vertices();
        }
        return flat(positions, corners);
    }

    @ParameterizedTest
    @ValueSource(strings = {JvmEngines.SEQUENTIAL, VectorEngines.VECTOR})
    void thinWallsLetNoLightIn(String engine) {
        Scene inside = scene(1, Vector3.ZERO)
                .withCamera(Camera.of(new Vector3(0.1, 0.2, -0.1), 30, 20, 140))
                .withGround(Ground.of(20, -5, RED.color(), RED.color(), 0));
        int[] picture = picture(engine, inside, hollow(), Mesh.of(FILE).withRotation(TILTED));

        // The ambient light alone.
        assertThat(Arrays.stream(picture).distinct()).hasSize(1);
    }

    @ParameterizedTest
    @ValueSource(strings = {JvmEngines.SEQUENTIAL, VectorEngines.VECTOR})
    void thinWallsLookLikeTheirOuterSide(String engine) {
        assertThat(PictureDifference.between(picture(engine, hollow()), picture(engine, MeshShapes.cube())))
                .matches(PictureDifference::isWithinBound);
    }

    /** A fan of triangles whose angles are below 0.2 degrees. */
    @ParameterizedTest
    @ValueSource(strings = {JvmEngines.SEQUENTIAL, VectorEngines.VECTOR})
    void needlesLookLikeTheSquareThatTheyFill(String engine) {
        float[] positions = new float[3 * (NEEDLES + 3)];
        System.arraycopy(new float[] {-1, 0, -1, -1, 0, 1}, 0, positions, 0, 6);
        int[] corners = new int[3 * (NEEDLES + 1)];
        for (int i = 0; i <= NEEDLES; i++) {
            System.arraycopy(new float[] {1, 0, 1 - 2f * i / NEEDLES}, 0, positions, 6 + 3 * i, 3);
            System.arraycopy(new int[] {0, i + 1, i + 2}, 0, corners, 3 * i, 3);
        }

        assertThat(PictureDifference.between(
                        picture(engine, flat(positions, corners)), picture(engine, MeshShapes.square())))
                .matches(PictureDifference::isWithinBound);
    }

    @ParameterizedTest
    @ValueSource(strings = {JvmEngines.SEQUENTIAL, VectorEngines.VECTOR})
    void meshAt100KilometersFromTheOriginLooksAsItDoesThere(String engine) {
        assertThat(PictureDifference.between(
                        pictureAt(engine, new Vector3(60_000, -50_000, 62_450)), pictureAt(engine, Vector3.ZERO)))
                .matches(PictureDifference::isWithinBound);
    }

    @ParameterizedTest
    @ValueSource(strings = {JvmEngines.SEQUENTIAL, VectorEngines.VECTOR})
    void meshAt100KilometersFromTheCameraLooksLikeASmallerNearOne(String engine) {
        int[] large = picture(
                engine,
                scene(TO_100_KM, Vector3.ZERO),
                MeshShapes.cube(),
                Mesh.of(FILE).withRotation(TILTED).withScale(TO_100_KM));

        assertThat(PictureDifference.between(large, picture(engine, MeshShapes.cube())))
                .matches(PictureDifference::isWithinBound);
    }
}
