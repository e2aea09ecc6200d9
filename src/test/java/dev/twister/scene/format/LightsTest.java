package dev.twister.scene.format;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import dev.twister.scene.Light;
import dev.twister.scene.Rgb;
import dev.twister.scene.Scene;
import dev.twister.scene.SceneException;
import dev.twister.scene.Vector3;
import dev.twister.scene.light.LightShape;
import dev.twister.scene.light.Lights;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The light or the lights of a scene file. */
class LightsTest {
    private static final String ONE = "\"light\": {\"position\": [0, 0, 0], \"radius\": 1.2, \"color\": [1, 1, 1]}";
    private static final String LAMP = "{\"position\": [1, 2, 3], \"radius\": 0.5, \"color\": [1, 0.5, 0]%s}";
    private static final Light WHITE = Light.of(new Vector3(0, 10, 0), 1, new Rgb(1, 1, 1));

    @TempDir
    Path folder;

    @Test
    void readsSeveral() {
        String second = LAMP.formatted(", \"strength\": 4, \"share\": 0.25");
        Scene scene = read("\"lights\": [" + LAMP.formatted("") + ", " + second + "]");

        Light lamp = Light.of(new Vector3(1, 2, 3), 0.5, new Rgb(1, 0.5, 0));
        assertThat(scene.lights().list())
                .containsExactly(lamp, lamp.withStrength(4.0).withShare(0.25));
    }

    @Test
    void writesOneAsALightAndMoreAsAList() {
        Scene one = Scene.under(Path.of("sky.hdr"));
        Scene two = one.withLights(new Lights(List.of(WHITE, WHITE.withShare(0.5))));

        assertThat(SceneWriter.text(one))
                .contains("\"version\": 1", "\"light\": {")
                .doesNotContain("\"lights\"");
        assertThat(SceneWriter.text(two))
                .contains("\"version\": 3", "\"lights\": [\n    {", "\"share\": 0.5")
                .doesNotContain("\"light\":");
    }

    @Test
    void refusesBoth() {
        refuses(
                ONE + ", \"lights\": [" + LAMP.formatted("") + "]",
                "$.lights and \"light\" are both given; a scene has one of them");
    }

    @Test
    void refusesTooMany() {
        String lamp = LAMP.formatted("");
        refuses(
                "\"lights\": [" + (lamp + ", ").repeat(4999) + lamp + "]",
                "$.lights is an array of 5000 items, but must be an array of 1 to 4096 lights");
    }

    @Test
    void refusesAnEmptyList() {
        refuses("\"lights\": []", "$.lights is an array of 0 items, but must be an array of 1 to 4096 lights");
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', quoteCharacter = '`', textBlock = """
            "share": -1       | $.lights[0].share is -1, but must be a number from 0 to 1000
            "share": 1e400    | $.lights[0].share is 1e400, but must be a number from 0 to 1000
            "strength": -0.1  | $.lights[0].strength is -0.1, but must be a number from 0 to 1000000000 m^2
            """)
    void refusesLampsThatCannotBe(String field, String message) {
        refuses("\"lights\": [" + LAMP.formatted(", " + field) + "]", message);
    }

    @Test
    void readsASunAndWritesItAsItWas() {
        String sun = "\"light\": {\"type\": \"sun\", \"direction\": [0.5, -1, 0], \"angularDiameter\": 0.53,"
                + " \"color\": [1, 0.9, 0.8], \"strength\": 3}";
        Scene scene = readNew(sun);

        assertThat(scene.lights().list())
                .containsExactly(Light.sun(new Vector3(0.5, -1, 0), 0.53)
                        .withColor(new Rgb(1, 0.9, 0.8))
                        .withStrength(3.0));
        assertThat(SceneWriter.text(scene)).contains("\"version\": 4", sun);
    }

    @Test
    void readsASpotAndWritesItAsItWas() {
        String spot = "\"light\": {\"type\": \"spot\", \"position\": [1, 2, 3], \"direction\": [0, -1, 0],"
                + " \"coneAngle\": 60, \"coneBlend\": 0.5}";
        Scene scene = readNew(spot);

        assertThat(scene.lights().first().shape())
                .isEqualTo(LightShape.SPOT.withConeAngleDegrees(60).withConeBlend(0.5));
        assertThat(SceneWriter.text(scene)).contains(spot);
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', quoteCharacter = '`', textBlock = """
            {"type": "spot", "direction": [0, -1, 0], "coneAngle": 181} | $.light.coneAngle is 181, but must be a number from 0.1 to 180 degrees
            {"type": "spot", "direction": [0, -1, 0], "angularDiameter": 1} | $.light.angularDiameter is given, but a light of type "spot" has none
            {"type": "spot"}                            | $.light.type is "spot", which needs "direction": where it shines
            {"type": "sun"}                             | $.light.type is "sun", which needs "direction": where it shines, three numbers from -1000000 to 1000000, one of them not 0
            {"type": "sun", "direction": [0, 0, 0]}     | $.light.direction is [0, 0, 0], but must be three numbers from -1000000 to 1000000, one of them not 0
            {"type": "sun", "direction": [0, -1, 0], "angularDiameter": 91} | $.light.angularDiameter is 91, but must be a number from 0 to 90 degrees
            {"type": "sun", "direction": [0, -1, 0], "radius": 2} | $.light.radius is given, but a light of type "sun" has none
            {"type": "moon", "direction": [0, -1, 0]}   | $.light.type is "moon", but must be one of "sphere", "sun", "spot"
            {"direction": [0, -1, 0]}                   | $.light.direction goes with "type" only, which is not given here; allowed without it: position, radius, color, strength, share, lightGroup, name, group, hidden, locked
            """)
    void refusesLightsThatDoNotFitTheirType(String light, String message) {
        assertThatThrownBy(() -> readNew("\"light\": " + light))
                .isInstanceOf(SceneException.class)
                .hasMessageContaining(message);
    }

    @Test
    void refusesALightWithoutSize() {
        refuses(
                "\"lights\": [" + LAMP.formatted("").replace("0.5, \"color\"", "0, \"color\"") + "]",
                "$.lights[0].radius is 0, but must be a number from 0.000001 to 1000000 meters");
    }

    @Test
    void olderVersionsHaveOneLight() {
        String text = SampleScene.with(ONE, "\"lights\": [" + LAMP.formatted("") + "]");
        assertThatThrownBy(() -> SceneReader.read(SampleScene.put(folder, text)))
                .isInstanceOf(SceneException.class)
                .hasMessageContaining("$.lights needs \"version\": 3 at the top of the file");
    }

    private Scene readNew(String lights) {
        return read(lights, Scene.VERSION);
    }

    private void refuses(String lights, String message) {
        assertThatThrownBy(() -> read(lights))
                .isInstanceOf(SceneException.class)
                .hasMessageContaining(message);
    }

    private Scene read(String lights) {
        return read(lights, 3);
    }

    private Scene read(String lights, int version) {
        String newest = SampleScene.with("\"version\": 1", "\"version\": " + version)
                .replace("\"name\": \"Sample\",\n", "")
                .replace(ONE, lights);
        return SceneReader.read(SampleScene.put(folder, newest));
    }
}
