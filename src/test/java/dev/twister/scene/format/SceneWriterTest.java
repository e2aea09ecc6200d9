package dev.twister.scene.format;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import dev.twister.Links;
import dev.twister.scene.Camera;
import dev.twister.scene.Ground;
import dev.twister.scene.Light;
import dev.twister.scene.Material;
import dev.twister.scene.Rgb;
import dev.twister.scene.Scene;
import dev.twister.scene.SceneException;
import dev.twister.scene.Shading;
import dev.twister.scene.Sphere;
import dev.twister.scene.Vector3;
import dev.twister.scene.generate.Pour;
import dev.twister.scene.light.Lights;
import dev.twister.scene.select.Title;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.SequencedMap;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class SceneWriterTest {
    @TempDir
    Path folder;

    @Test
    void writesOneLineAPartAndOneASphere() throws IOException {
        Path file = folder.resolve("out.json");

        SceneWriter.write(scene(24), file);

        assertThat(file).hasContent("""
                {
                  "version": 1,
                  "name": "A \"name\"",
                  "description": "",
                  "camera": {"position": [0, -5, -15.5], "yaw": -0.0, "pitch": 7, "fieldOfView": 50},
                  "light": {"position": [0, 0, 0], "radius": 1.0E-5, "color": [1, 1, 1]},
                  "plane": {"size": 48, "height": -9.75, "colors": [[0.4, 0.4, 0.4], [0.2, 0.2, 0.2]], "reflectivity": 32},
                  "skybox": "../skyboxes/day.hdr",
                  "shading": {"ambient": 0.2},
                  "rendering": {"width": 1280, "height": 720, "shadowSamples": 200, "bounces": 3, "samplesPerPixel": 1, "exposure": 0, "toneMap": "clamp", "srgb": true},
                  "spheres": [
                    {"position": [-8, -8, 0], "radius": 1.75, "color": [1, 0.123456789, 1], "reflectivity": 24}
                  ]
                }
                """.replace("\"A \"name\"\"", "\"A \\\"name\\\"\""));
        assertThat(names()).containsExactly("out.json");
    }

    @Test
    void writesNamesOfMaterialsWhereBodiesHaveThem() throws IOException {
        Path file = SampleScene.put(Files.createDirectory(folder.resolve("scenes")), SampleScene.MATERIALS);
        Scene scene = SceneReader.read(file);

        SceneWriter.write(scene, folder.resolve("out.json"));

        assertThat(Files.readString(folder.resolve("out.json"))).contains("""
                          "version": 2,
                        """, """
                          "materials": {
                            "glass": {"color": [1, 1, 1], "reflectivity": 2, "transmission": 0.75, "ior": 1.6},
                            "earth": {"color": [1, 1, 0.5], "reflectivity": 3, "roughness": 0.25, "texture": "scenes/earth.png"}
                          },
                          "plane": {"size": 48, "height": -9.75, "material": "earth", "oddColor": [0.5, 0, 0]},
                        """, """
                            {"position": [-4, -8, 0], "radius": 1.75, "material": "glass"},
                        """);
        assertThat(SceneReader.read(folder.resolve("out.json"))).isEqualTo(scene);
    }

    @Test
    void writesTheSecondVersionOnlyWhereItIsNeeded() throws IOException {
        Scene plain = scene(24);
        Sphere sphere = plain.spheres().getFirst();
        SequencedMap<String, Material> materials = new LinkedHashMap<>();
        materials.put("unused", Material.DEFAULT);

        assertThat(version(plain)).isEqualTo(1);
        assertThat(version(plain.withPour(Pour.DEFAULT))).isEqualTo(1);
        assertThat(version(plain.withMaterials(materials))).isEqualTo(2);
        assertThat(version(plain.withCamera(plain.camera().withFocusDistance(3))))
                .isEqualTo(2);
        assertThat(version(plain.withSpheres(
                        List.of(sphere, sphere.withMaterial(sphere.material().withIor(1.4))))))
                .isEqualTo(2);
        assertThat(version(plain.withGround(
                        plain.ground().withMaterial(plain.ground().material().withRoughness(0.5)))))
                .isEqualTo(2);
        assertThat(version(plain.withPour(Pour.DEFAULT.withMaterial(Material.DEFAULT.withTransmission(1)))))
                .isEqualTo(2);
    }

    private int version(Scene scene) throws IOException {
        Path file = folder.resolve("version.json");
        SceneWriter.write(scene, file);
        return Files.readString(file).contains("\"version\": 2") ? 2 : 1;
    }

    @Test
    void replacesAFileAndLeavesNothingElse() throws IOException {
        Path file = Files.writeString(folder.resolve("out.json"), "old");

        SceneWriter.write(scene(24), file);

        assertThat(Files.readString(file)).startsWith("{\n  \"version\": 1");
        assertThat(names()).containsExactly("out.json");
    }

    @Test
    void keepsTheOldFileWhereTheSceneIsInvalid() throws IOException {
        Path file = Files.writeString(folder.resolve("out.json"), "old");

        assertThatThrownBy(() -> SceneWriter.write(scene(Double.NaN), file))
                .isInstanceOf(SceneException.class)
                .hasMessage(
                        file + " (not written): $.spheres[0].reflectivity is NaN, but must be a number from 0 to 128");
        assertThat(file).hasContent("old");
        assertThat(names()).containsExactly("out.json");
    }

    @Test
    void refusesAFolderAndALackOfOne() {
        assertThatThrownBy(() -> SceneWriter.write(scene(24), folder))
                .isInstanceOf(SceneException.class)
                .hasMessage(folder + ": cannot be written: is a folder or a device, but must be a file");
        Path lost = folder.resolve("none").resolve("out.json");
        assertThatThrownBy(() -> SceneWriter.write(scene(24), lost))
                .isInstanceOf(SceneException.class)
                .hasMessage(lost + ": cannot be written: there is no folder to write it in");
    }

    @Test
    void namesTheSkyAsItIsReachedFromTheScenesRealFolder() throws IOException {
        Path sky = sky(folder.resolve("skyboxes"));
        Path deep = Files.createDirectories(folder.resolve("real/deep"));
        Path file = Links.make(folder.resolve("link"), deep).resolve("out.json");

        SceneWriter.write(sceneUnder(sky), file);

        assertThat(Files.readString(file)).contains("\"skybox\": \"../../skyboxes/day.hdr\"");
        assertThat(SceneReader.read(file).sky().file()).isEqualTo(sky.toRealPath());
        assertThat(SceneReader.read(deep.resolve("out.json")).sky().file()).isEqualTo(sky);
    }

    @Test
    void namesTheSkyAsItIsReachedFromTheFileBehindALink() throws IOException {
        Path sky = sky(folder.resolve("skyboxes"));
        Path deep = Files.createDirectories(folder.resolve("real/deep"));
        Path file = Links.make(folder.resolve("out.json"), deep.resolve("out.json"));

        SceneWriter.write(sceneUnder(sky), file);

        assertThat(SceneReader.read(deep.resolve("out.json")).sky().file()).isEqualTo(sky);
        assertThat(SceneReader.read(file).sky().file()).isEqualTo(sky.toRealPath());
    }

    @Test
    void keepsALinkToAFolderOfSkies() throws IOException {
        sky(folder.resolve("elsewhere/skies"));
        Path skies = Links.make(folder.resolve("skies"), folder.resolve("elsewhere/skies"));
        Path file = folder.resolve("out.json");

        SceneWriter.write(sceneUnder(skies.resolve("day.hdr")), file);

        assertThat(Files.readString(file)).contains("\"skybox\": \"skies/day.hdr\"");
    }

    @Test
    void namesTheSkyBesideASceneThatALinkLeadsToAsItWas() throws IOException {
        sky(folder.resolve("elsewhere/skies"));
        Path real = Files.createDirectory(folder.resolve("real"));
        Path skies = Links.make(real.resolve("skies"), folder.resolve("elsewhere/skies"));
        Path file = real.resolve("scene.json");
        SceneWriter.write(sceneUnder(skies.resolve("day.hdr")), file);
        String before = Files.readString(file);
        Path near = Links.make(Files.createDirectory(folder.resolve("home")).resolve("near.json"), file);
        Path far = Links.make(Files.createDirectories(folder.resolve("a/b/c")).resolve("far.json"), file);

        SceneWriter.write(SceneReader.read(near), near);
        assertThat(Files.readString(file)).isEqualTo(before);
        SceneWriter.write(SceneReader.read(far), far);
        assertThat(Files.readString(file)).isEqualTo(before);
    }

    private static Path sky(Path skies) throws IOException {
        return Files.createFile(Files.createDirectories(skies).resolve("day.hdr"));
    }

    private List<String> names() throws IOException {
        try (Stream<Path> files = Files.list(folder)) {
            return files.map(file -> file.getFileName().toString()).toList();
        }
    }

    private Scene scene(double reflectivity) {
        return scene(reflectivity, folder.resolveSibling("skyboxes").resolve("day.hdr"));
    }

    private static Scene sceneUnder(Path sky) {
        return scene(24, sky);
    }

    private static Scene scene(double reflectivity, Path sky) {
        return Scene.under(sky)
                .withTitle(Title.NONE.withName("A \"name\""))
                .withCamera(Camera.of(new Vector3(0, -5, -15.5), -0.0, 7, 50))
                .withLights(Lights.of(Light.of(new Vector3(0, 0, 0), 0.00001, new Rgb(1, 1, 1))))
                .withGround(Ground.of(48, -9.75, new Rgb(0.4, 0.4, 0.4), new Rgb(0.2, 0.2, 0.2), 32))
                .withSpheres(List.of(Sphere.of(new Vector3(-8, -8, 0), 1.75, new Rgb(1, 0.123456789, 1), reflectivity)))
                .withShading(new Shading(0.2));
    }
}
