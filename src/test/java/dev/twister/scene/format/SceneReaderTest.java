package dev.twister.scene.format;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.catchThrowableOfType;

import com.sun.management.ThreadMXBean;
import dev.twister.Links;
import dev.twister.scene.Camera;
import dev.twister.scene.Ground;
import dev.twister.scene.Light;
import dev.twister.scene.Material;
import dev.twister.scene.Physics;
import dev.twister.scene.Rendering;
import dev.twister.scene.Rgb;
import dev.twister.scene.Scene;
import dev.twister.scene.SceneException;
import dev.twister.scene.Shading;
import dev.twister.scene.Sky;
import dev.twister.scene.Sphere;
import dev.twister.scene.ToneMap;
import dev.twister.scene.Vector3;
import dev.twister.scene.generate.Palette;
import dev.twister.scene.generate.Pour;
import dev.twister.scene.light.Lights;
import dev.twister.scene.select.Title;
import java.io.IOException;
import java.io.RandomAccessFile;
import java.lang.management.ManagementFactory;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import org.assertj.core.api.Assumptions;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.FieldSource;
import org.junit.jupiter.params.provider.ValueSource;

class SceneReaderTest {
    static final List<SpoiltScenes.Spoilt> SPOILT = SpoiltScenes.ALL;

    @TempDir
    Path folder;

    @Test
    void readsEveryField() {
        Scene scene = SceneReader.read(SampleScene.put(folder, SampleScene.TEXT));

        assertThat(scene)
                .isEqualTo(Scene.under(folder.resolve("sky.hdr"))
                        .withTitle(new Title("Sample", "Every field is here."))
                        .withCamera(Camera.of(new Vector3(0, -5, -15), 0, 7, 50))
                        .withLights(Lights.of(Light.of(new Vector3(0, 0, 0), 1.2, new Rgb(1, 1, 1))))
                        .withGround(Ground.of(48, -9.75, new Rgb(0.4, 0.4, 0.4), new Rgb(0.2, 0.2, 0.2), 32))
                        .withSpheres(List.of(
                                Sphere.of(new Vector3(-4, -8, 0), 1.75, new Rgb(1, 0, 0), 24),
                                Sphere.of(new Vector3(0, -8, 0), 1.5, new Rgb(0, 1, 0), 36)))
                        .withSky(new Sky(folder.resolve("sky.hdr"), -35, 2.25))
                        .withShading(new Shading(0.25))
                        .withRendering(Rendering.DEFAULT
                                .withSize(640, 360)
                                .withShadowSamples(16)
                                .withBounces(2)
                                .withSamplesPerPixel(4)
                                .withTone(-0.5, ToneMap.ACES, true))
                        .withPhysics(Physics.DEFAULT
                                .withGravity(new Vector3(0, -1.62, 0))
                                .withElasticity(0.75)
                                .withFriction(0.125)
                                .withDamping(0.05)
                                .withWalls(false)
                                .withSolidLight(true))
                        .withPour(Pour.DEFAULT
                                .withCount(30)
                                .withRate(5.5)
                                .withPosition(new Vector3(1, 2, 3))
                                .withWidth(1.25)
                                .withSpeed(2.5)
                                .withRadii(0.2, 0.3)
                                .withPalette(Palette.LAGOON)
                                .withReflectivity(12)
                                .withSeed(9)));
    }

    @Test
    void readsMaterialsAndTheLens() {
        Scene scene = SceneReader.read(SampleScene.put(folder, SampleScene.MATERIALS));

        Path texture = folder.resolve("earth.png");
        Material glass =
                Material.DEFAULT.withReflectivity(2).withTransmission(0.75).withIor(1.6);
        Material earth = Material.DEFAULT
                .withColor(new Rgb(1, 1, 0.5))
                .withReflectivity(3)
                .withRoughness(0.25)
                .withTexture(texture);
        assertThat(scene.materials()).containsExactly(Map.entry("glass", glass), Map.entry("earth", earth));
        assertThat(scene.camera().aperture()).isEqualTo(0.125);
        assertThat(scene.camera().focusDistance()).isEqualTo(12.5);
        assertThat(scene.ground())
                .isEqualTo(Ground.of(48, -9.75, new Rgb(1, 1, 0.5), new Rgb(0.5, 0, 0), 3)
                        .withMaterial(earth));
        assertThat(scene.spheres())
                .extracting(Sphere::material)
                .containsExactly(
                        glass,
                        Material.DEFAULT
                                .withColor(new Rgb(0, 1, 0))
                                .withReflectivity(36)
                                .withRoughness(0.125)
                                .withTransmission(0.5)
                                .withIor(1.25)
                                .withTexture(texture));
        assertThat(scene.allSpheres().getLast().material().withColor(Material.DEFAULT.color()))
                .isEqualTo(Material.DEFAULT
                        .withReflectivity(12)
                        .withRoughness(0.5)
                        .withTransmission(1)
                        .withIor(2)
                        .withTexture(texture));
        assertThat(TexturePlaces.of(scene))
                .containsExactly(Map.entry(folder.resolve("earth.png"), "$.materials.earth.texture"));
    }

    @Test
    void aNamedMaterialAloneMakesThePlaneOneColor() {
        String text = SampleScene.with(SampleScene.MATERIALS, ", \"oddColor\": [0.5, 0, 0]", "");

        Ground plane = SceneReader.read(SampleScene.put(folder, text)).ground();

        assertThat(plane.oddColor()).isEqualTo(plane.evenColor()).isEqualTo(new Rgb(1, 1, 0.5));
    }

    @Test
    void readsAFileOfTheFirstVersionAlikeInTheSecond() {
        Scene first = SceneReader.read(SampleScene.put(folder, SampleScene.TEXT));

        Scene second = SceneReader.read(SampleScene.put(folder, SampleScene.with("\"version\": 1", "\"version\": 2")));

        assertThat(second).isEqualTo(first);
    }

    @Test
    void refusesATextureThatIsNotThere() {
        String text = SampleScene.with(
                SampleScene.MATERIALS, "0.25, \"texture\": \"earth.png\"", "0.25, \"texture\": \"sub/moon.png\"");

        assertThat(message(SampleScene.put(folder, text)))
                .endsWith(":7:86: $.materials.earth.texture names " + folder.resolve("sub/moon.png")
                        + ": file not found");
    }

    @Test
    void anotherSkyTakesThePlaceOfOneThatIsNotThere() throws IOException {
        Path file = SampleScene.put(folder, SampleScene.MATERIALS);
        Scene scene = SceneReader.read(file);
        Files.delete(folder.resolve("sky.hdr"));
        Path other = folder.resolve("other.hdr");

        assertThat(SceneReader.readUnder(other, file))
                .isEqualTo(scene.withSky(scene.sky().withFile(other)));
        Files.delete(folder.resolve("earth.png"));
        assertThatThrownBy(() -> SceneReader.readUnder(other, file))
                .hasMessageContaining("$.materials.earth.texture names ")
                .hasMessageEndingWith(": file not found");
    }

    @Test
    void readsASceneWhosePicturesAreNotThere() throws IOException {
        Path file = SampleScene.put(folder, SampleScene.MATERIALS);
        Scene scene = SceneReader.read(file);
        Files.delete(folder.resolve("sky.hdr"));
        Files.delete(folder.resolve("earth.png"));

        assertThat(SceneReader.readWithoutPictures(file)).isEqualTo(scene);
    }

    @Test
    void fillsInWhatIsOptional() {
        String text = SampleScene.TEXT.replaceAll(
                "(?m)^  \"(\\$schema|name|description|shading|rendering|physics|pour)\".*\n", "");

        Scene scene = SceneReader.read(SampleScene.put(folder, text));

        assertThat(scene.title().name()).isEmpty();
        assertThat(scene.title().description()).isEmpty();
        assertThat(scene.sky().rotationDegrees()).isZero();
        assertThat(scene.sky().strength()).isEqualTo(1);
        assertThat(scene.shading().ambient()).isEqualTo(Shading.DEFAULT_AMBIENT);
        assertThat(scene.rendering()).isEqualTo(Rendering.DEFAULT);
        assertThat(scene.rendering().srgb()).isTrue();
        assertThat(scene.physics()).isEqualTo(Physics.DEFAULT);
        assertThat(scene.pour()).isEmpty();
    }

    @Test
    void takesWholeNumbersHoweverTheyAreWritten() {
        String text =
                SampleScene.with("\"width\": 640", "\"width\": 6.4e2").replace("\"version\": 1", "\"version\": 1.0");

        assertThat(SceneReader.read(SampleScene.put(folder, text)).rendering().width())
                .isEqualTo(640);
    }

    @Test
    void takesAByteOrderMarkAndAnyLineEnds() {
        Path file = SampleScene.put(folder, "\uFEFF" + SampleScene.TEXT.replace("\n", "\r\n"));

        assertThat(SceneReader.read(file).title().name()).isEqualTo("Sample");
    }

    @ParameterizedTest
    @FieldSource("SPOILT")
    void saysWhereAndWhatIsWrong(SpoiltScenes.Spoilt spoilt) {
        Path file = SampleScene.put(folder, spoilt.text());

        assertThatThrownBy(() -> SceneReader.read(file))
                .isInstanceOf(SceneException.class)
                .message()
                .satisfies(message -> assertThat(message.lines().findFirst()).contains(file + ":" + spoilt.message()));
    }

    @Test
    void saysAllThatIsWrong() {
        Path file = SampleScene.put(
                folder,
                SampleScene.with("\"pitch\": 7", "\"pitch\": 91")
                        .replace("\"radius\": 1.75", "\"radius\": -1")
                        .replace("\"friction\"", "\"frction\""));

        assertThatThrownBy(() -> SceneReader.read(file))
                .isInstanceOf(SceneException.class)
                .message()
                .satisfies(message -> assertThat(message.lines())
                        .hasSize(3)
                        .allMatch(line -> line.startsWith(file + ":"))
                        .anyMatch(line -> line.contains("$.camera.pitch is 91"))
                        .anyMatch(line -> line.contains("$.spheres[0].radius is -1"))
                        .anyMatch(line -> line.contains("did you mean \"friction\"?")));
    }

    @Test
    void saysTheFirstTenFaults() {
        String spheres = "{\"position\": [0, 0, 0], \"radius\": 0}, ".repeat(20);
        Path file = SampleScene.put(folder, SampleScene.with("\"spheres\": [", "\"spheres\": [" + spheres));

        assertThatThrownBy(() -> SceneReader.read(file))
                .message()
                .satisfies(message -> assertThat(message.lines()).hasSize(10));
    }

    @Test
    void aVersionAndABodyAreEnough() {
        Path file =
                SampleScene.put(folder, "{\"version\": 4, \"spheres\": [{\"position\": [0, 1, 0], \"radius\": 1}]}");

        Scene scene = SceneReader.read(file);

        assertThat(scene.camera()).isEqualTo(Camera.USUAL);
        assertThat(scene.sky().file()).isEqualTo(Sky.PLAIN);
        assertThat(scene.lights().list()).containsExactly(Light.DEFAULT);
        assertThat(SceneWriter.text(scene)).contains("\"version\": 4").doesNotContain("skybox");
    }

    @Test
    void countsLinesAsEditorsDo() {
        for (String lineEnd : List.of("\n", "\r\n", "\r")) {
            Path file = SampleScene.put(
                    folder, SampleScene.with("\"pitch\": 7", "\"pitch\": 91").replace("\n", lineEnd));

            assertThat(message(file)).startsWith(file + ":6:59: ");
        }
    }

    @Test
    void refusesADocumentThatIsNoObject() {
        assertThat(message(SampleScene.put(folder, "[1, 2]")))
                .endsWith("scene.json:1:1: the file starts with \"[1, 2]\", but must hold a JSON object");
        assertThat(message(SampleScene.put(folder, " \n ")))
                .endsWith("scene.json:2:2: the file holds only white space, but must hold a JSON object");
    }

    @Test
    void refusesAbsurdNesting() {
        assertThat(message(SampleScene.put(folder, SampleScene.with("1.5", "[".repeat(100_000)))))
                .endsWith("scene.json:16:53: objects and arrays are nested more than 16 deep");
    }

    @Test
    void refusesMoreContainersAndItemsThanAnySceneHas() {
        assertThat(message(SampleScene.put(folder, "{\"a\": [" + "[],".repeat(500_000) + "[]]}")))
                .endsWith("scene.json:1:1500008: $.a has more than 500000 items");
        String most = "[" + "[],".repeat(499_999) + "[]],";
        assertThat(message(SampleScene.put(folder, "{\"a\": [" + most.repeat(4) + "[]]}")))
                .endsWith("a scene file may hold at most 2000000 objects and arrays");
    }

    @Test
    void refusalsOfWholeObjectsSayWhereTheyAre() {
        assertThat(message(SampleScene.put(folder, "{\"a\": [0, {\"b\": {\"c\": 1, \"c\": 2}}]}")))
                .endsWith(": $.a[1].b.c is given twice, first on line 1");
    }

    @Test
    void refusesAFileWithLittleMoreMemoryThanItsOwn() {
        Path file = SampleScene.put(folder, "{\"a\": [" + "[],".repeat(499_999) + "[]]}");
        ThreadMXBean threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
        message(file);
        long before = threads.getCurrentThreadAllocatedBytes();
        message(file);
        assertThat(threads.getCurrentThreadAllocatedBytes() - before).isLessThan(60L * 1_500_000);
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "//host/share/sky.hdr",
                "\\\\\\\\host\\\\share\\\\sky.hdr",
                "/\\\\host/sky.hdr",
                "\\\\\\\\?\\\\UNC\\\\host\\\\sky.hdr"
            })
    void refusesFilesOnOtherMachines(String name) {
        assertThat(message(SampleScene.put(folder, SampleScene.with("sky.hdr", name))))
                .contains(":9:13: $.skybox names a file on another machine, ")
                .endsWith("; copy the file here and name it relative to the scene file's folder");
        assertThat(message(SampleScene.put(
                        folder,
                        SampleScene.with(
                                SampleScene.MATERIALS,
                                "0.25, \"texture\": \"earth.png\"",
                                "0.25, \"texture\": \"" + name + "\""))))
                .contains("$.materials.earth.texture names a file on another machine, ");
    }

    @Test
    void refusesTooManyFields() {
        StringBuilder many = new StringBuilder();
        for (int i = 0; i < 300; i++) {
            many.append("\"a").append(i).append("\": 0, ");
        }

        assertThat(message(SampleScene.put(folder, SampleScene.with("\"yaw\"", many + "\"yaw\""))))
                .contains("$.camera has more than 256 fields");
    }

    @Test
    void refusesATooLongNumberAndString() {
        assertThat(message(SampleScene.put(folder, SampleScene.with("1.5", "1." + "5".repeat(2000)))))
                .endsWith(": a number, a name or a string here is too long");
        assertThat(message(SampleScene.put(folder, SampleScene.with("\"Sample\"", "\"" + "x".repeat(200_000) + "\""))))
                .endsWith(": a number, a name or a string here is too long");
    }

    @Test
    void shortensAndEscapesWhatTheFileSays() {
        assertThat(message(SampleScene.put(folder, SampleScene.with("\"Sample\"", "\"" + "x".repeat(5000) + "\""))))
                .endsWith("$.name is a string of 5000 characters, \"" + "x".repeat(40)
                        + "...\", but must be a string of 0 to 200 characters, none of them a control character");
        assertThat(message(SampleScene.put(
                        folder, SampleScene.with("\"yaw\"", "\"\\u001b[31m" + "x".repeat(300) + "\": 2, \"yaw\""))))
                .endsWith("$.camera has an unknown field \"\\u001b[31m" + "x".repeat(35) + "...\"; allowed here: "
                        + "position, yaw, pitch, fieldOfView");
    }

    @Test
    void refusesASkyboxThatIsNotThere() {
        assertThat(message(SampleScene.put(folder, SampleScene.with("sky.hdr", "../noon.hdr"))))
                .endsWith("scene.json:9:13: $.skybox names " + folder.resolveSibling("noon.hdr") + ": file not found");
        assertThat(message(SampleScene.put(folder, SampleScene.with("sky.hdr", "."))))
                .endsWith("scene.json:9:13: $.skybox names " + folder + ": is a folder, but must be a file");
    }

    @Test
    void findsTheSkyOfASceneBehindLinks() throws IOException {
        Path real = folder.resolve("real");
        Path scene = SampleScene.put(real.resolve("scenes"), SampleScene.with("sky.hdr", "../skies/day.hdr"));
        Path sky = Files.createFile(Files.createDirectory(real.resolve("skies")).resolve("day.hdr"));
        Path home = Files.createDirectory(folder.resolve("home"));
        Path scenes = Links.make(home.resolve("scenes"), real.resolve("scenes"));
        Path file = Links.make(home.resolve("mine.json"), scene);

        assertThat(SceneReader.read(scene).sky().file()).isEqualTo(sky);
        assertThat(SceneReader.read(scenes.resolve("scene.json")).sky().file()).isEqualTo(sky.toRealPath());
        assertThat(SceneReader.read(file).sky().file()).isEqualTo(sky.toRealPath());

        // Paths through linked folders, as scenes were once written.
        Path named = SampleScene.put(scenes, SampleScene.with("sky.hdr", "../near.hdr"));
        Path near = Files.createFile(home.resolve("near.hdr"));
        assertThat(SceneReader.read(named).sky().file()).isEqualTo(near);

        SampleScene.put(scenes, SampleScene.with("sky.hdr", "../skies/day.hdr"));
        Files.delete(sky);
        assertThat(message(file)).endsWith("names " + folder.resolve("skies/day.hdr") + ": file not found");
    }

    @Test
    void refusesWhatIsNoFile() {
        Path missing = folder.resolve("none.json");
        assertThat(message(missing)).isEqualTo(missing + ": file not found");
        assertThat(message(folder)).isEqualTo(folder + ": is a folder, but must be a file");
    }

    @Test
    void refusesAnEmptyFile() {
        Path file = SampleScene.put(folder, "");
        assertThat(message(file)).isEqualTo(file + ": the file is empty (0 bytes)");
    }

    @Test
    void refusesAHugeFileUnread() throws IOException {
        Path file = folder.resolve("huge.json");
        try (RandomAccessFile sparse = new RandomAccessFile(file.toFile(), "rw")) {
            sparse.setLength(1L << 30);
        }
        assertThat(message(file))
                .isEqualTo(file + ": has 1073741824 bytes; a scene file may have at most 67108864 bytes (64 MiB)");
    }

    @Test
    void refusesAnUnreadableFile() {
        Path file = SampleScene.put(folder, SampleScene.TEXT);
        // The superuser may read everything.
        Assumptions.assumeThat(file.toFile().setReadable(false) && !Files.isReadable(file))
                .isTrue();
        assertThat(message(file)).isEqualTo(file + ": cannot be read: permission denied");
    }

    @Test
    void refusesBinaryFilesAndBadText() {
        byte[] png = {(byte) 0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'};
        assertThat(message(SampleScene.put(folder, png)))
                .endsWith("scene.json:1:1: is not UTF-8 text: the byte 0x89 fits no character");

        byte[] cut = Arrays.copyOf("{\n\"é".getBytes(StandardCharsets.UTF_8), 4);
        assertThat(message(SampleScene.put(folder, cut)))
                .endsWith("scene.json:2:2: is not UTF-8 text: the byte 0xC3 fits no character");

        assertThat(message(SampleScene.put(folder, SampleScene.TEXT.getBytes(StandardCharsets.UTF_16))))
                .contains("is not UTF-8 text");
        assertThat(message(SampleScene.put(folder, new byte[1000]))).contains("scene.json:1:1: not valid JSON");
    }

    private static String message(Path file) {
        SceneException refusal = catchThrowableOfType(SceneException.class, () -> SceneReader.read(file));
        assertThat(refusal).as("the refusal of " + file).isNotNull();
        return refusal.getMessage();
    }
}
