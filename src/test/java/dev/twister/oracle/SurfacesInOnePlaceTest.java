package dev.twister.oracle;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.engine.JvmEngines;
import dev.twister.engine.vector.VectorEngines;
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
import dev.twister.scene.Vector3;
import dev.twister.scene.light.Lights;
import dev.twister.sky.Skybox;
import dev.twister.world.SceneImages;
import dev.twister.world.SceneMeshes;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

/** Pictures of coincident surfaces equal those of the surface that is seen alone, without a speckle. */
public class SurfacesInOnePlaceTest {
    private static final Path FILE = Path.of("shape.obj");
    private static final Skybox SKY = new Skybox(1, 1, new float[] {0.2f, 0.4f, 0.9f});
    private static final Material RED = Material.DEFAULT.withColor(new Rgb(0.9, 0.2, 0.1));
    private static final Material BLUE = RED.withColor(new Rgb(0.1, 0.3, 0.9));
    private static final Material MIRROR = RED.withReflectivity(100);
    private static final Material GLASS =
            Material.DEFAULT.withTransmission(1).withColor(new Rgb(0.9, 1, 0.9)).withReflectivity(0);
    private static final float RAISED = 1.0001f;
    private static final List<Rotation> ROTATIONS =
            List.of(Rotation.NONE, new Rotation(30, 0, 0), new Rotation(40, 17, 65), new Rotation(200, 3, 91));

    /** Two scenes whose pictures are equal. */
    public record Pair(String name, LitScene coincident, LitScene expected) {
        @Override
        public String toString() {
            return name;
        }
    }

    private static Scene scene() {
        return Scene.under(Path.of("none.hdr"))
                .withCamera(Camera.of(new Vector3(-2.5, 2.5, -8), 15, 12, 35))
                .withLights(Lights.of(Light.of(new Vector3(-3, 6, -4), 0.5, new Rgb(1, 1, 1))))
                .withGround(Ground.of(20, -1.8, new Rgb(0.7, 0.7, 0.7), new Rgb(0.3, 0.3, 0.3), 0))
                .withRendering(Rendering.DEFAULT
                        .withSize(120, 90)
                        .withShadowSamples(12)
                        .withBounces(3));
    }

    private static LitScene lit(Scene scene, MeshFile file) {
        return new LitScene(scene, SceneImages.of(SKY), SceneMeshes.of(scene, _ -> file));
    }

    private static Scene placed(Scene scene, Rotation rotation, Vector3 position, double scale) {
        return scene.withMeshes(List.of(
                Mesh.of(FILE).withRotation(rotation).withPosition(position).withScale(scale)));
    }

    private static MeshFile file(List<TriangleMesh> meshes, Material... materials) {
        List<MeshPart> parts = Stream.iterate(0, i -> i + 1)
                .limit(materials.length)
                .map(i -> new MeshPart("", i, Affine.IDENTITY, materials[i]))
                .toList();
        return MeshShapes.file(meshes, parts);
    }

    private static TriangleMesh flat(float[] positions, int... corners) {
        return new TriangleMesh(positions, new float[0], new float[0], corners);
    }

    /** The cube, with its faces twice: the second time as the given corners of each face's four, in this order. */
    private static TriangleMesh twice(int... order) {
        TriangleMesh cube = MeshShapes.cube();
        int[] once = cube.corners();
        int[] corners = Arrays.copyOf(once, 2 * once.length);
        for (int face = 0; face < once.length; face += 6) {
            int[] four = {once[face], once[face + 1], once[face + 2], once[face + 5]};
            for (int i = 0; i < 6; i++) {
                corners[once.length + face + i] = four[order[i]];
            }
        }
        return flat(cube.positions(), corners);
    }

    private static TriangleMesh table(float height) {
        return flat(new float[] {-3, height, -3, 3, height, -3, 3, height, 3, -3, height, 3}, 0, 2, 1, 0, 3, 2);
    }

    /** A square of half the cube's side within its face toward negative z. */
    private static TriangleMesh decal() {
        return flat(new float[] {-0.5f, -0.5f, -1, 0.5f, -0.5f, -1, 0.5f, 0.5f, -1, -0.5f, 0.5f, -1}, 0, 2, 1, 0, 3, 2);
    }

    public static Stream<Pair> pairs() {
        MeshFile red = file(List.of(MeshShapes.cube()), RED);
        MeshFile mirror = file(List.of(MeshShapes.cube()), MIRROR);
        Scene there = placed(scene(), new Rotation(40, 17, 65), new Vector3(0.3, 0.1, 0.2), 1);
        Scene onTheGround = placed(scene(), Rotation.NONE, new Vector3(0, -0.8, 0), 1);
        TriangleMesh cube = MeshShapes.cube();
        Scene above = placed(scene(), new Rotation(25, 0, 0), Vector3.ZERO, 1);
        TriangleMesh bottomAndBack = flat(cube.positions(), Arrays.copyOfRange(cube.corners(), 6, 18));
        TriangleMesh back = flat(cube.positions(), Arrays.copyOfRange(cube.corners(), 6, 12));
        TriangleMesh raised = flat(
                new float[] {-0.5f, -0.5f, -RAISED, 0.5f, -0.5f, -RAISED, 0.5f, 0.5f, -RAISED, -0.5f, 0.5f, -RAISED},
                decal().corners());
        return Stream.of(
                        ROTATIONS.stream()
                                .map(turn -> new Pair(
                                        "the same triangles, " + turn,
                                        lit(
                                                placed(scene(), turn, Vector3.ZERO, 1),
                                                file(List.of(twice(0, 1, 2, 0, 2, 3)), RED)),
                                        lit(placed(scene(), turn, Vector3.ZERO, 1), red))),
                        Stream.of(
                                new Pair(
                                        "opposite",
                                        lit(there, file(List.of(twice(0, 2, 1, 0, 3, 2)), RED)),
                                        lit(there, red)),
                                new Pair(
                                        "diagonal",
                                        lit(there, file(List.of(twice(0, 1, 3, 1, 2, 3)), RED)),
                                        lit(there, red)),
                                new Pair(
                                        "mirrors",
                                        lit(there, file(List.of(twice(0, 1, 3, 1, 2, 3)), MIRROR)),
                                        lit(there, mirror)),
                                new Pair(
                                        "a hidden decal",
                                        lit(there, file(List.of(cube, decal()), RED, GLASS)),
                                        lit(there, red)),
                                new Pair(
                                        "a decal",
                                        lit(there, file(List.of(decal(), cube), BLUE, RED)),
                                        lit(there, file(List.of(raised, cube), BLUE, RED))),
                                new Pair(
                                        "a mirror as a decal",
                                        lit(there, file(List.of(decal(), cube), MIRROR, RED)),
                                        lit(there, file(List.of(raised, cube), MIRROR, RED))),
                                new Pair(
                                        "a floor on the ground",
                                        lit(onTheGround, file(List.of(bottomAndBack), RED)),
                                        lit(onTheGround, file(List.of(back), RED))),
                                new Pair(
                                        "glass on a table",
                                        lit(above, file(List.of(cube, table(-1)), GLASS, RED)),
                                        lit(above, file(List.of(cube, table(-RAISED)), GLASS, RED)))))
                .flatMap(pairs -> pairs);
    }

    static Stream<Arguments> drawn() {
        return pairs().flatMap(pair ->
                Stream.of(JvmEngines.SEQUENTIAL, VectorEngines.VECTOR).map(engine -> Arguments.of(pair, engine)));
    }

    @ParameterizedTest(name = "{0}, {1}")
    @MethodSource("drawn")
    void showOneOfThem(Pair pair, String engine) {
        PictureDifference difference = PictureDifference.between(
                Pictures.argb(engine, pair.coincident()), Pictures.argb(engine, pair.expected()));

        assertThat(difference).matches(PictureDifference::isWithinBound);
    }
}
