package dev.twister.scene.format;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;

import dev.twister.scene.Camera;
import dev.twister.scene.CameraKeyframe;
import dev.twister.scene.Scene;
import dev.twister.scene.SceneException;
import dev.twister.scene.Vector3;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class KeyframesTest {
    private static final String KEYFRAMES = "\"fieldOfView\": 50, \"keyframes\": ["
            + "{\"time\": 0, \"position\": [0, -5, -15], \"yaw\": 0, \"pitch\": 7},"
            + "{\"time\": 2.5, \"position\": [1, -4, -15], \"yaw\": 370, \"pitch\": -7,"
            + " \"fieldOfView\": 30, \"focusDistance\": 4}]";

    @TempDir
    private Path folder;

    @BeforeEach
    void makeASky() throws IOException {
        Files.createFile(folder.resolve("sky.hdr"));
        Files.createFile(folder.resolve("earth.png"));
    }

    @Test
    void areReadAndWritten() throws IOException {
        Scene scene = SceneReader.read(file(KEYFRAMES));

        assertThat(scene.camera().keyframes())
                .containsExactly(
                        new CameraKeyframe(0, new Vector3(0, -5, -15), 0, 7, Optional.empty(), Optional.empty()),
                        new CameraKeyframe(2.5, new Vector3(1, -4, -15), 370, -7, Optional.of(30.0), Optional.of(4.0)));

        Path copy = folder.resolve("copy.json");
        SceneWriter.write(scene, copy);
        assertThat(SceneReader.read(copy)).isEqualTo(scene);
        assertThat(Files.readString(copy)).contains("\"version\": 2");
    }

    @Test
    void mustComeOneAfterTheOther() throws IOException {
        Path file = file(KEYFRAMES.replace("2.5", "0"));

        assertThatExceptionOfType(SceneException.class)
                .isThrownBy(() -> SceneReader.read(file))
                .withMessageContaining(
                        "$.camera.keyframes[1].time is 0, but must be above 0, the time of the keyframe before it");
    }

    @Test
    void needTheSecondVersion() {
        Scene scene = SceneReader.read(Path.of("scenes", "benchmark.json"));
        Camera camera = scene.camera();

        Path file = folder.resolve("moving.json");
        SceneWriter.write(scene.withCamera(camera.withKeyframes(List.of(CameraKeyframe.of(1, camera)))), file);

        assertThat(file).content().contains("\"version\": 2").contains("\"keyframes\": [{\"time\": 1");
    }

    private Path file(String camera) throws IOException {
        return Files.writeString(
                folder.resolve("scene.json"), SampleScene.with(SampleScene.MATERIALS, "\"fieldOfView\": 50", camera));
    }
}
