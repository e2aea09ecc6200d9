package dev.twister.scene.format;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;

import dev.twister.scene.Easing;
import dev.twister.scene.Keyframe;
import dev.twister.scene.Scene;
import dev.twister.scene.SceneException;
import dev.twister.scene.Track;
import dev.twister.scene.TrackTarget;
import dev.twister.scene.Vector3;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class TracksTest {
    private static final String TRACKS = "{\"target\": \"spheres[1]\", \"property\": \"position\", \"keyframes\": ["
            + "{\"time\": 0, \"value\": [0, 1, 2], \"easing\": \"linear\"}, {\"time\": 2, \"value\": [3, 4, 5]}]},"
            + "{\"target\": \"lights[0]\", \"property\": \"share\", \"loop\": true, \"keyframes\": ["
            + "{\"time\": 1, \"value\": 0.5}]}";

    @TempDir
    private Path folder;

    @BeforeEach
    void makeASky() throws IOException {
        Files.createFile(folder.resolve("sky.hdr"));
    }

    @Test
    void areReadAndWritten() throws IOException {
        Scene scene = SceneReader.read(file(TRACKS));

        assertThat(scene.tracks())
                .containsExactly(
                        Track.of(
                                TrackTarget.sphere(1),
                                "position",
                                Keyframe.of(0, new Vector3(0, 1, 2)).withEasing(Easing.LINEAR),
                                Keyframe.of(2, new Vector3(3, 4, 5))),
                        Track.of(TrackTarget.light(0), "share", Keyframe.of(1, 0.5))
                                .withLoop(true));

        Path copy = folder.resolve("copy.json");
        SceneWriter.write(scene, copy);
        assertThat(SceneReader.read(copy)).isEqualTo(scene);
    }

    @Test
    void needTheThirdVersion() throws IOException {
        Path old = Files.writeString(
                folder.resolve("old.json"), Files.readString(file(TRACKS)).replace("\"version\": 3", "\"version\": 2"));

        assertThatExceptionOfType(SceneException.class)
                .isThrownBy(() -> SceneReader.read(old))
                .withMessageContaining("$.tracks needs \"version\": 3");

        Scene scene = SceneReader.read(file(TRACKS));
        Path still = folder.resolve("still.json");
        SceneWriter.write(scene.withTracks(List.of()), still);
        assertThat(still).content().contains("\"version\": 1");
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', quoteCharacter = '`', textBlock = """
                    spheres[1] | spheres[2]  | $.tracks[0].target is "spheres[2]", but must be one of the scene's spheres, of which it has 2
                    spheres[1] | sphere 1    | $.tracks[0].target is "sphere 1", but must be camera, plane, sky,
                    "position" | "place"     | $.tracks[0].property is "place", but must be one of the properties of spheres[1]: position, radius, color,
                    [3, 4, 5]  | 3           | $.tracks[0].keyframes[1].value is 3, but must be an array of 3 numbers from -1000000 to 1000000 meters
                    "value": 0.5 | "value": -1 | $.tracks[1].keyframes[0].value is -1, but must be a number from 0 to 1000
                    "time": 2  | "time": 0   | $.tracks[0].keyframes[1].time is 0, but must be above 0, the time of the keyframe before it
                    lights[0]", "property": "share | spheres[1]", "property": "position | $.tracks[1].keyframes[0].value is 0.5, but must be an array of 3 numbers
                    linear     | fast        | $.tracks[0].keyframes[0].easing is "fast", but must be one of
                    """)
    void mistakesAreTold(String part, String replacement, String message) throws IOException {
        Path file = file(TRACKS.replace(part, replacement));

        assertThatExceptionOfType(SceneException.class)
                .isThrownBy(() -> SceneReader.read(file))
                .withMessageContaining(message);
    }

    @Test
    void aPropertyHasOneTrack() throws IOException {
        String once = TRACKS.substring(0, TRACKS.indexOf("]},") + 2);
        Path file = file(once + "," + once);

        assertThatExceptionOfType(SceneException.class)
                .isThrownBy(() -> SceneReader.read(file))
                .withMessageContaining(
                        "$.tracks[1].property is \"position\", but must be a property of spheres[1] that no"
                                + " track before it has");
    }

    private Path file(String tracks) throws IOException {
        String text = SampleScene.with(SampleScene.TEXT, "\"version\": 1", "\"version\": 3");
        return Files.writeString(
                folder.resolve("scene.json"), text.replaceFirst("\n}\n$", ",\n  \"tracks\": [" + tracks + "]\n}\n"));
    }
}
