package dev.twister.scene.format;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import com.networknt.schema.InputFormat;
import com.networknt.schema.SchemaRegistry;
import com.networknt.schema.SpecificationVersion;
import dev.twister.scene.Scene;
import dev.twister.scene.SceneException;
import dev.twister.scene.select.Tag;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Names and groups of bodies, and which are hidden or locked. */
class TagsTest {
    private static final String TEXT = """
            {
              "version": 3,
              "camera": {"position": [0, 1, -8], "yaw": 0, "pitch": 7, "fieldOfView": 50},
              "light": {"position": [0, 6, 0], "radius": 1.2, "color": [1, 1, 1], "name": "Sun", "locked": true},
              "plane": {"size": 48, "height": 0, "colors": [[0.4, 0.4, 0.4], [0.2, 0.2, 0.2]], "reflectivity": 32},
              "skybox": "sky.hdr",
              "spheres": [
                {"position": [-4, 8, 0], "radius": 1, "color": [1, 0, 0], "reflectivity": 24, "name": "Ball", "group": "Toys"}
              ],
              "meshes": [{"shape": "box", "name": "Crate", "group": "Toys", "hidden": true}]
            }
            """;

    @TempDir
    Path folder;

    @Test
    void tagsAreReadAndWritten() throws IOException {
        Scene scene = SceneReader.read(SampleScene.put(folder, TEXT));
        assertThat(scene.lights().first().tag()).isEqualTo(new Tag("Sun", "", false, true));
        assertThat(scene.spheres().getFirst().tag()).isEqualTo(new Tag("Ball", "Toys", false, false));
        assertThat(scene.meshes().getFirst().tag()).isEqualTo(new Tag("Crate", "Toys", true, false));
        Path copy = folder.resolve("copy.json");
        SceneWriter.write(scene, copy);
        assertThat(SceneReader.read(copy)).isEqualTo(scene);
        assertThat(Files.readString(copy)).contains("\"version\": 3", "\"name\": \"Ball\", \"group\": \"Toys\"}");
    }

    @Test
    void aSceneHasAVisibleLight() throws IOException {
        Path file = SampleScene.put(folder, SampleScene.with(TEXT, "\"locked\": true", "\"hidden\": true"));
        assertThatThrownBy(() -> SceneReader.read(file))
                .isInstanceOf(SceneException.class)
                .hasMessageEndingWith("$ has hidden lights alone; at least one light must be visible");
    }

    @Test
    void editorsTakeTags() throws IOException {
        var schema = SchemaRegistry.withDefaultDialect(SpecificationVersion.DRAFT_2020_12)
                .getSchema(Files.readString(Path.of("scenes", "scene.schema.json")), InputFormat.JSON);
        assertThat(schema.validate(TEXT, InputFormat.JSON)).isEmpty();
    }
}
