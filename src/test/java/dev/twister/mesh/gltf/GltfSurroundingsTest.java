package dev.twister.mesh.gltf;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import dev.twister.mesh.Affine;
import dev.twister.mesh.MeshException;
import dev.twister.mesh.MeshFile;
import dev.twister.mesh.MeshPlacement;
import dev.twister.mesh.MeshPose;
import dev.twister.mesh.MeshReader;
import dev.twister.mesh.MeshStage;
import dev.twister.scene.Camera;
import dev.twister.scene.Geometry;
import dev.twister.scene.Light;
import dev.twister.scene.Mesh;
import dev.twister.scene.Rgb;
import dev.twister.scene.Scene;
import dev.twister.scene.Vector3;
import dev.twister.scene.light.LightShape;
import dev.twister.world.Animation;
import dev.twister.world.SceneMeshes;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Scenes, lights and cameras of glTF files. */
class GltfSurroundingsTest {
    /** A triangle from (-5, 0, 0) to (5, 0, 0), 10 high: the stage shows it at 0.2 of its size. */
    private static final String MESH = """
            "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
            "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"}],
            "bufferViews": [{"buffer": 0, "byteLength": 36}],
            "buffers": [{"byteLength": 36,
              "uri": "data:;base64,AACgwAAAAAAAAAAAAACgQAAAAAAAAAAAAAAAAAAAIEEAAAAA"}]
            """;

    private static final String SCENES = """
            "scenes": [{"name": "Day", "nodes": [0]}, {"nodes": [0, 1]}, {"name": "0", "nodes": [0, 1, 2]}],
            "nodes": [{"mesh": 0}, {"mesh": 0}, {"mesh": 0}],
            """;

    @TempDir
    private Path folder;

    private final List<String> warnings = new ArrayList<>();

    private Geometry.OfFile file(String more, String scene) throws IOException {
        Path file = folder.resolve("a.gltf");
        Files.writeString(file, "{\"asset\": {\"version\": \"2.0\"}," + more + MESH + "}");
        return new Geometry.OfFile(file, scene);
    }

    private MeshFile read(String more, String scene) throws IOException {
        return MeshReader.read(file(more, scene), 0, warnings::add);
    }

    private Scene stage(String more) throws IOException {
        return MeshStage.of(file(more, ""), read(more, ""), Path.of("sky.hdr"), MeshPose.OF_FILE);
    }

    private List<Light> lights(String light, String node) throws IOException {
        return stage("""
                        "nodes": [{"mesh": 0}, {"extensions": {"KHR_lights_punctual": {"light": 0}}, %s}],
                        "extensionsUsed": ["KHR_lights_punctual"],
                        "extensions": {"KHR_lights_punctual": {"lights": [{%s}]}},
                        """.formatted(node, light)).lights().list();
    }

    private Camera camera(String camera, String node) throws IOException {
        return stage("\"nodes\": [{\"mesh\": 0}, {\"camera\": 0, %s}], \"cameras\": [{%s}],".formatted(node, camera))
                .views()
                .getFirst()
                .camera();
    }

    @ParameterizedTest
    @CsvSource({"'', 1", "Day, 1", "1, 2", "2, 3", "0, 3"})
    void takesASceneByItsNameElseByItsNumber(String scene, int parts) throws IOException {
        assertThat(read(SCENES, scene).parts()).hasSize(parts);
    }

    @Test
    void refusesAnUnknownSceneAndListsThoseThatAreThere() {
        assertThatThrownBy(() -> read(SCENES, "Night"))
                .isInstanceOf(MeshException.class)
                .hasMessageEndingWith("$.scenes has no scene 'Night'; expected one of: 0 ('Day'), 1, 2 ('0')");
    }

    @Test
    void saysThatOthersAreNotShown() throws IOException {
        read(SCENES, "");

        assertThat(warnings)
                .containsExactly(folder.resolve("a.gltf")
                        + ": there are several scenes: 0 ('Day'), 1, 2 ('0'); the first one is read");
    }

    @Test
    void refusesASceneOfAFileThatHasNone() {
        assertThatThrownBy(() -> read("", "Night"))
                .hasMessageEndingWith("$.scenes has no scenes, but 'Night' is asked for");
    }

    @Test
    void refusesASceneOfAnotherFormat() throws IOException {
        Path file = Files.writeString(folder.resolve("a.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");

        assertThatThrownBy(() -> MeshReader.read(new Geometry.OfFile(file, "Night"), 0, warnings::add))
                .hasMessageEndingWith(
                        "has no scenes, but the scene 'Night' is asked for; only glTF files have several");
    }

    @Test
    void pointLightLightsTheScaledMeshAsTheFiles() throws IOException {
        Light light = lights("\"type\": \"point\", \"intensity\": 25", "\"translation\": [0, 5, 10]")
                .getFirst();

        // 25 cd at 10 m are 0.25 lux; the stage has the light at 2 m.
        assertThat(light.position()).isEqualTo(new Vector3(0, 1, -2));
        assertThat(light.strength().orElseThrow() / 4).isCloseTo(0.25 / Math.PI, within(1e-12));
        assertThat(light.share()).isCloseTo(0.25 / Math.PI, within(1e-12));
    }

    @Test
    void directionalLightIsASunAlongTheNodesAxis() throws IOException {
        Light light = lights(
                        "\"type\": \"directional\", \"intensity\": 2, \"color\": [1, 0, 0]",
                        "\"rotation\": [-0.7071067811865476, 0, 0, 0.7071067811865476]")
                .getFirst();

        assertThat(light.isSun()).isTrue();
        assertThat(light.shape().direction().minus(new Vector3(0, -1, 0)).length())
                .isCloseTo(0, within(1e-9));
        assertThat(light.color()).isEqualTo(new Rgb(1, 0, 0));
        assertThat(light.strength().orElseThrow()).isCloseTo(2 / Math.PI, within(1e-12));
    }

    @Test
    void brightLightsAreDimmedAlike() throws IOException {
        List<Light> lights = stage("""
                        "nodes": [{"mesh": 0}, {"extensions": {"KHR_lights_punctual": {"light": 0}}},
                          {"extensions": {"KHR_lights_punctual": {"light": 1}}}],
                        "extensions": {"KHR_lights_punctual": {"lights": [
                          {"type": "directional", "intensity": 3000}, {"type": "directional", "intensity": 1000}]}},
                        """).lights().list();

        assertThat(lights).extracting(Light::share).containsExactly(0.75, 0.25);
    }

    @Test
    void withoutLightsTheStageHasItsOwn() throws IOException {
        List<Light> dark = lights("\"type\": \"point\", \"intensity\": 0", "\"name\": \"off\"");

        assertThat(dark).isEqualTo(stage("").lights().list());
    }

    @Test
    void spotHasTheConeOfTheFile() throws IOException {
        Light light = lights(
                        "\"type\": \"spot\", \"intensity\": 25,"
                                + " \"spot\": {\"innerConeAngle\": 0.2, \"outerConeAngle\": 0.5}",
                        "\"translation\": [0, 5, 10]")
                .getFirst();

        assertThat(light.shape().kind()).isEqualTo(LightShape.Kind.SPOT);
        assertThat(light.shape().direction()).isEqualTo(new Vector3(0, 0, 1));
        assertThat(light.shape().outerCosine()).isCloseTo(Math.cos(0.5), within(1e-12));
        assertThat(light.shape().innerCosine()).isCloseTo(Math.cos(0.2), within(1e-12));
        assertThat(light.position()).isEqualTo(new Vector3(0, 1, -2));
        assertThat(light.strength().orElseThrow() / 4).isCloseTo(0.25 / Math.PI, within(1e-12));
        assertThat(warnings).isEmpty();
    }

    @Test
    void spotWithoutAnglesHasThoseOfTheFormat() throws IOException {
        LightShape shape =
                lights("\"type\": \"spot\"", "\"name\": \"lamp\"").getFirst().shape();

        assertThat(shape.coneAngleDegrees()).isCloseTo(90, within(1e-9));
        assertThat(shape.coneBlend()).isEqualTo(1);
    }

    @Test
    void cameraBecomesAView() throws IOException {
        Camera camera = camera(
                "\"type\": \"perspective\", \"perspective\": {\"yfov\": 1.5707963267948966, \"znear\": 1}",
                "\"translation\": [10, 5, 0], \"rotation\": [0, 0.7071067811865476, 0, 0.7071067811865476]");

        assertThat(camera.position()).isEqualTo(new Vector3(2, 1, 0));
        assertThat(camera.yawDegrees()).isCloseTo(-90, within(1e-9));
        assertThat(camera.pitchDegrees()).isCloseTo(0, within(1e-9));
        assertThat(camera.fieldOfViewDegrees()).isCloseTo(90, within(1e-9));
    }

    @Test
    void portraitCameraHasItsAngleOverTheWidth() throws IOException {
        Camera camera =
                camera("\"perspective\": {\"yfov\": 1.5707963267948966, \"aspectRatio\": 0.5}", "\"name\": \"tall\"");

        assertThat(camera.fieldOfViewDegrees()).isCloseTo(2 * Math.toDegrees(Math.atan(0.5)), within(1e-9));
    }

    @Test
    void viewsHaveNamesOfTheirOwn() throws IOException {
        Scene scene = stage("""
                "nodes": [{"mesh": 0}, {"camera": 0, "name": "Front"}, {"camera": 0}, {"camera": 0, "name": "Front"}],
                "cameras": [{"perspective": {"yfov": 1}}],
                """);

        assertThat(scene.views()).extracting("name").containsExactly("Front", "camera", "Front 2");
    }

    @Test
    void saysWhatOfCamerasIsLost() throws IOException {
        stage("""
                "nodes": [{"mesh": 0}, {"camera": 0, "rotation": [0, 0, 1, 1]}, {"camera": 1}],
                "cameras": [{"perspective": {"yfov": 1}}, {"orthographic": {"xmag": 4, "ymag": 1.5}}],
                """);

        assertThat(warnings).containsOnly(folder.resolve("a.gltf") + ": $.cameras[0] is rolled; its view is level");
    }

    @Test
    void aCameraWithoutPerspectiveSeesTwiceItsMagnification() throws IOException {
        Scene scene = stage("""
                "nodes": [{"mesh": 0}, {"camera": 0}],
                "cameras": [{"orthographic": {"xmag": 4, "ymag": 1.5}}],
                """);

        assertThat(scene.views().getFirst().camera().projection()).isEqualTo(Camera.Projection.ORTHOGRAPHIC);
        assertThat(scene.views().getFirst().camera().viewHeight()).isEqualTo(3);
    }

    /** A node with the mesh, a spot and a camera that goes 4 to the right and turns by 90 degrees in a second. */
    @Test
    void lightsAndCamerasOfMovingNodesFollowTheAnimation() throws IOException {
        AnimatedGltf gltf = new AnimatedGltf();
        int times = gltf.accessor("SCALAR", 0, 1);
        int places = gltf.accessor("VEC3", 0, 0, 0, 4, 0, 0);
        int turns = gltf.accessor("VEC4", 0, 0, 0, 1, 0, 0.70710677f, 0, 0.70710677f);
        String text = gltf.node(",\"camera\":0,\"name\":\"Eye\",\"extensions\":{\"KHR_lights_punctual\":{\"light\":0}}")
                .channel(0, "translation", "LINEAR", times, places)
                .channel(0, "rotation", "LINEAR", times, turns)
                .text(",\"cameras\":[{\"perspective\":{\"yfov\":1}}],\"extensions\":{\"KHR_lights_punctual\":"
                        + "{\"lights\":[{\"type\":\"spot\"}]}}");
        Path path = folder.resolve("moving.gltf");
        Files.writeString(path, text);
        Geometry.OfFile file = new Geometry.OfFile(path);
        MeshFile held = MeshReader.read(file, 0, warnings::add);
        Scene stage = MeshStage.of(file, held, Path.of("sky.hdr"), MeshPose.OF_FILE);
        Mesh mesh = stage.meshes().getFirst();
        Camera eye = stage.views().getFirst().camera();
        Scene seen = stage.withCamera(eye.withKeyframes(MeshStage.path(stage, held, "Eye")));

        for (double seconds : new double[] {0, 0.25, 0.5, 0.9}) {
            Affine node = MeshPlacement.of(mesh)
                    .of(held.posed(mesh.animation().at(seconds))
                            .parts()
                            .getFirst()
                            .placement());
            Scene now = Animation.at(seen, seconds);

            Light light = now.lights().first();
            Vector3 ahead = node.direction(new Vector3(0, 0, 1)).normalized();
            assertThat(light.position().minus(node.origin()).length()).isCloseTo(0, within(1e-3));
            assertThat(light.shape().toward().plus(ahead).length()).isCloseTo(0, within(1e-3));
            assertThat(now.camera().position().minus(node.origin()).length()).isCloseTo(0, within(1e-3));
            double yaw = Math.toDegrees(Math.atan2(ahead.x(), ahead.z()));
            assertThat(Math.abs(now.camera().yawDegrees() - yaw) % 360).isCloseTo(0, within(0.1));
        }
        assertThat(Animation.at(seen, 0.9).lights().first().position().x())
                .isNotCloseTo(stage.lights().first().position().x(), within(0.1));
        assertThat(MeshStage.path(stage, held, "another")).isEmpty();
        assertThat(Animation.frames(stage, SceneMeshes.of(stage, _ -> held), 10))
                .isEqualTo(10);
    }

    @Test
    void whatRestsHasNoTracks() throws IOException {
        String text = new AnimatedGltf()
                .node(",\"extensions\":{\"KHR_lights_punctual\":{\"light\":0}}")
                .text(",\"extensions\":{\"KHR_lights_punctual\":{\"lights\":[{\"type\":\"point\"}]}}");
        Path path = folder.resolve("resting.gltf");
        Files.writeString(path, text);
        Geometry.OfFile file = new Geometry.OfFile(path);
        Scene stage = MeshStage.of(file, MeshReader.read(file, 0, warnings::add), Path.of("sky.hdr"), MeshPose.OF_FILE);

        assertThat(stage.lights().first().strength()).isPresent();
        assertThat(stage.tracks()).isEmpty();
    }
}
