package dev.twister.scene.format;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import dev.twister.scene.Camera;
import dev.twister.scene.CameraKeyframe;
import dev.twister.scene.CameraView;
import dev.twister.scene.Scene;
import dev.twister.scene.SceneException;
import dev.twister.scene.Vector3;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class ViewsTest {
    private static final String CAMERA = "\"focusDistance\": 12.5},";
    private static final String VIEWS = CAMERA + " \"views\": ["
            + "{\"name\": \"Front\", \"position\": [0, -5, -15], \"yaw\": 0, \"pitch\": 7, \"fieldOfView\": 50},"
            + "{\"name\": \"From above\", \"position\": [0, 9, 0], \"yaw\": 30, \"pitch\": 90, \"fieldOfView\": 40,"
            + " \"aperture\": 0.25, \"focusDistance\": 18}],";

    @TempDir
    private Path folder;

    @BeforeEach
    void makeASky() throws IOException {
        Files.createFile(folder.resolve("sky.hdr"));
        Files.createFile(folder.resolve("earth.png"));
    }

    @Test
    void aFisheyeSeesWiderThanPerspective() throws IOException {
        String wide = VIEWS.replace("\"fieldOfView\": 50", "\"fieldOfView\": 250");

        assertThatThrownBy(() -> SceneReader.read(file(wide)))
                .hasMessageEndingWith("$.views[0].fieldOfView is 250, but must be a number from 1 to 179 degrees");
        String fisheye = wide.replace("\"fieldOfView\": 250", "\"projection\": \"fisheye\", \"fieldOfView\": 250");
        Path file = file(fisheye);
        Files.writeString(file, Files.readString(file).replace("\"version\": 2", "\"version\": 4"));
        Scene scene = SceneReader.read(file);
        assertThat(scene.views().getFirst().camera().fieldOfViewDegrees()).isEqualTo(250);
    }

    @Test
    void areReadAndWrittenInTheirOrder() throws IOException {
        Scene scene = SceneReader.read(file(VIEWS));

        assertThat(scene.views())
                .containsExactly(
                        new CameraView("Front", Camera.of(new Vector3(0, -5, -15), 0, 7, 50)),
                        new CameraView(
                                "From above",
                                Camera.of(new Vector3(0, 9, 0), 30, 90, 40)
                                        .withAperture(0.25)
                                        .withFocusDistance(18)));
        Path copy = folder.resolve("copy.json");
        SceneWriter.write(scene, copy);
        assertThat(SceneReader.read(copy)).isEqualTo(scene);
    }

    @Test
    void standStill() {
        Camera camera = Camera.of(new Vector3(0, 1, 2), 3, 4, 50);
        Camera moving = camera.withKeyframes(List.of(CameraKeyframe.of(1, camera)));

        assertThat(new CameraView("Front", moving).camera()).isEqualTo(camera);
    }

    @Test
    void haveNamesOfTheirOwn() throws IOException {
        Path file = file(VIEWS.replace("From above", "Front"));

        assertThatExceptionOfType(SceneException.class)
                .isThrownBy(() -> SceneReader.read(file))
                .withMessageContaining("$.views[1].name is \"Front\", but must be a name that no view before it has");
    }

    @Test
    void haveNoKeyframes() throws IOException {
        Path file = file(VIEWS.replace("\"yaw\": 30", "\"yaw\": 30, \"keyframes\": []"));

        assertThatExceptionOfType(SceneException.class)
                .isThrownBy(() -> SceneReader.read(file))
                .withMessageContaining("$.views[1] has an unknown field \"keyframes\"");
    }

    @Test
    void needTheSecondVersion() {
        Scene scene = SceneReader.read(Path.of("scenes", "benchmark.json"));

        Path file = folder.resolve("viewed.json");
        SceneWriter.write(scene.withViews(List.of(new CameraView("Front", scene.camera()))), file);

        assertThat(file).content().contains("\"version\": 2").contains("\"views\": [\n    {\"name\": \"Front\"");
    }

    private Path file(String camera) throws IOException {
        return Files.writeString(folder.resolve("scene.json"), SampleScene.with(SampleScene.MATERIALS, CAMERA, camera));
    }
}
