package dev.twister.mesh.gltf;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import dev.twister.mesh.MeshFile;
import dev.twister.mesh.MeshPart;
import dev.twister.mesh.Reading;
import dev.twister.mesh.TriangleMesh;
import dev.twister.scene.MeshAnimation;
import dev.twister.scene.Vector3;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.assertj.core.data.Offset;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Animations of glTF files. The corner that is looked at is the file's point (1, 0, 0), but for its z, negated. */
class GltfAnimationTest {
    private static final Offset<Double> EXACT = within(1e-6);

    @TempDir
    Path folder;

    private final List<String> warnings = new ArrayList<>();
    private final AnimatedGltf gltf = new AnimatedGltf();

    private static void assertCorner(MeshFile file, double seconds, double x, double y, double z) {
        Vector3 corner = corner(file, seconds);
        assertThat(corner.x()).isCloseTo(x, EXACT);
        assertThat(corner.y()).isCloseTo(y, EXACT);
        assertThat(corner.z()).isCloseTo(z, EXACT);
    }

    /** Turning the winding makes the second corner the third. */
    private static Vector3 corner(MeshFile file, double seconds) {
        MeshFile posed = file.posed(MeshAnimation.of("move").withStart(seconds).withLoop(false));
        MeshPart part = posed.parts().getFirst();
        TriangleMesh mesh = posed.meshes().get(part.mesh());
        int at = 3 * mesh.corners()[2];
        float[] positions = mesh.positions();
        return part.placement().point(new Vector3(positions[at], positions[at + 1], positions[at + 2]));
    }

    @ParameterizedTest
    @CsvSource({"LINEAR, 0.5, 2", "LINEAR, 1.5, 4", "LINEAR, 9, 5", "STEP, 0.99, 1", "STEP, 1, 3", "STEP, 2.5, 5"})
    void translationGoesFromKeyToKey(String interpolation, double seconds, double x) {
        int times = gltf.accessor("SCALAR", 0, 1, 2);
        int values = gltf.accessor("VEC3", 0, 0, 0, 2, 0, 0, 4, 0, 0);
        MeshFile file =
                gltf.channel(0, "translation", interpolation, times, values).read(folder, warnings, "");

        assertCorner(file, seconds, x, 0, 0);
        assertThat(file.rig().clips())
                .singleElement()
                .satisfies(clip -> assertThat(clip.seconds()).isEqualTo(2));
        assertThat(warnings).isEmpty();
    }

    @Test
    void cubicSplinesHaveTangentsPerSecond() {
        int times = gltf.accessor("SCALAR", 0, 2);
        // Before, value and after of each key: from 0 upward at 3 a second, and to 0 from above.
        int values = gltf.accessor("VEC3", 0, 0, 0, 0, 0, 0, 0, 3, 0, 0, -3, 0, 0, 0, 0, 0, 0, 0);
        MeshFile file =
                gltf.channel(0, "translation", "CUBICSPLINE", times, values).read(folder, warnings, "");

        assertCorner(file, 1, 1, 1.5, 0);
        assertCorner(file, 2, 1, 0, 0);
    }

    @Test
    void rotationsTakeTheShorterWayAtEvenSpeed() {
        int times = gltf.accessor("SCALAR", 0, 1);
        float half = (float) Math.sqrt(0.5);
        // A quarter turn about z, as the negated quaternion.
        int values = gltf.accessor("VEC4", 0, 0, 0, 1, 0, 0, -half, -half);
        MeshFile file = gltf.channel(0, "rotation", "LINEAR", times, values).read(folder, warnings, "");

        double third = Math.toRadians(30);
        assertCorner(file, 1 / 3.0, Math.cos(third), Math.sin(third), 0);
    }

    @Test
    void aScaleOfZeroHidesAndANodeThatIsFlatAtRestIsShownLater() {
        int times = gltf.accessor("SCALAR", 0, 1);
        int values = gltf.accessor("VEC3", 0, 0, 0, 2, 2, 2);
        MeshFile file = gltf.node(",\"scale\":[0,0,0]")
                .channel(0, "scale", "LINEAR", times, values)
                .read(folder, warnings, "");

        assertCorner(file, 1, 2, 0, 0);
        assertCorner(file, 0, 0, 0, 0);
        assertThat(warnings).isEmpty();
    }

    @Test
    void jointsMoveVerticesAndNormals() {
        int joints = gltf.accessor("VEC4", 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0);
        int weights = gltf.accessor("VEC4", 1, 0, 0, 0, 0.25f, 0.75f, 0, 0, 1, 0, 0, 0);
        int normals = gltf.accessor("VEC3", 0, 0, 1, 0, 0, 1, 0, 0, 1);
        int times = gltf.accessor("SCALAR", 0, 1);
        int values = gltf.accessor("VEC3", 0, 0, 0, 0, 4, 0);
        MeshFile file = gltf.attributes(
                        ",\"JOINTS_0\":" + joints + ",\"WEIGHTS_0\":" + weights + ",\"NORMAL\":" + normals)
                .node(",\"skin\":0,\"translation\":[50,0,0]")
                .nodes(",{\"children\":[]},{}")
                .channel(2, "translation", "LINEAR", times, values)
                .read(folder, warnings, ",\"skins\":[{\"joints\":[1,2]}]");

        assertCorner(file, 0, 1, 0, 0);
        assertCorner(file, 1, 1, 3, 0);
        TriangleMesh still = file.posed(MeshAnimation.of("move")).meshes().getFirst();
        assertThat(still).isSameAs(file.meshes().getFirst());
    }

    @Test
    void weightsMoveMorphTargetsAndMayBeNormalizedIntegers() {
        int target = gltf.accessor("VEC3", 0, 0, 0, 0, 0, -2, 0, 0, 0);
        int times = gltf.accessor("SCALAR", 0, 1);
        int values = gltf.normalized("SCALAR", 2, 0, 127);
        MeshFile file = gltf.primitive(",\"targets\":[{\"POSITION\":" + target + "}]")
                .channel(0, "weights", "LINEAR", times, values)
                .read(folder, warnings, "");

        assertCorner(file, 0.5, 1, 0, 1);
        assertCorner(file, 1, 1, 0, 2);
    }

    @Test
    void normalsThatAFileLacksFollowItsTriangles() {
        int target = gltf.accessor("VEC3", 0, 0, 0, 0, 0, -1, 0, 0, 0);
        int times = gltf.accessor("SCALAR", 0, 1);
        int values = gltf.accessor("SCALAR", 0, 1);
        String text = gltf.primitive(",\"targets\":[{\"POSITION\":" + target + "}]")
                .channel(0, "weights", "LINEAR", times, values)
                .text("");
        MeshFile file = Reading.read(folder, "a.gltf", text.getBytes(StandardCharsets.UTF_8), 30, warnings);

        float[] normals = file.posed(MeshAnimation.of("0").withStart(1).withLoop(false))
                .meshes()
                .getFirst()
                .normals();

        // Of the triangle (0, 0, 0), (1, 0, -1), (0, 1, 0) of the file, whose z is negated.
        assertThat(normals).hasSize(9);
        assertThat((double) normals[0]).isCloseTo(Math.sqrt(0.5), EXACT);
        assertThat((double) normals[2]).isCloseTo(-Math.sqrt(0.5), EXACT);
    }

    @Test
    void aSpeedBelowZeroPlaysBackwardsAndALoopBeginsAgain() {
        MeshAnimation backwards = MeshAnimation.of("move").withStart(1).withSpeed(-2);

        assertThat(backwards.at(0.25).time(4)).isEqualTo(0.5);
        assertThat(backwards.at(1).time(4)).isEqualTo(3);
        assertThat(backwards.withLoop(false).at(1).time(4)).isEqualTo(0);
        assertThat(MeshAnimation.of("move").at(4).time(0)).isEqualTo(0);
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "7 | translation | 0 | 1 | target.node is 7; $.nodes has 1 items",
                "0 | translation | 1 | 0 | has the time 0.0 at key 1, after 1.0; times must rise",
                "0 | translation | 0 | NaN | has NaN at element 1",
                "0 | weights | 0 | 1 | has weights for a mesh without morph targets",
                "0 | rotation | 0 | 1 | expected one with 4 components",
                "0 | color | 0 | 1 | is 'color'; expected translation, rotation, scale or weights"
            })
    void aDamagedAnimationIsToldOnceAndTheMeshStaysAtRest(
            int node, String path, float first, float second, String problem) {
        int times = gltf.accessor("SCALAR", first, second);
        int values = gltf.accessor("VEC3", 0, 0, 0, 2, 0, 0);
        MeshFile file = gltf.channel(node, path, "LINEAR", times, values).read(folder, warnings, "");

        assertThat(warnings)
                .singleElement()
                .asString()
                .contains("$.")
                .contains(problem)
                .endsWith("; the animation is not played, and the mesh is shown at rest");
        assertCorner(file, 1, 1, 0, 0);
    }

    @Test
    void keysWithoutBytesAreLimited() {
        int times = gltf.accessor("SCALAR", 0, 1);
        int values = gltf.accessor("VEC3", 0, 0, 0, 2, 0, 0);
        String text = gltf.channel(0, "translation", "LINEAR", times, values)
                .text("")
                .replace(
                        "{\"bufferView\":" + values + ",\"componentType\":5126,\"type\":\"VEC3\",\"count\":2}",
                        "{\"componentType\":5126,\"type\":\"VEC3\",\"count\":900000}");
        Reading.read(folder, "a.gltf", text.getBytes(StandardCharsets.UTF_8), 0, warnings);

        assertThat(warnings).singleElement().asString().contains("too many for the");
    }
}
