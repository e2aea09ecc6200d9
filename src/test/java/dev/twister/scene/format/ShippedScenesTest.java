package dev.twister.scene.format;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatCode;

import com.networknt.schema.InputFormat;
import com.networknt.schema.Schema;
import com.networknt.schema.SchemaRegistry;
import com.networknt.schema.SpecificationVersion;
import dev.twister.scene.generate.SceneGenerator;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.FieldSource;
import org.junit.jupiter.params.provider.MethodSource;

class ShippedScenesTest {
    private static final Path SCENES = Path.of("scenes");

    static final List<SpoiltScenes.Spoilt> SEEN_BY_SCHEMA =
            SpoiltScenes.ALL.stream().filter(SpoiltScenes.Spoilt::schemaSees).toList();

    private final Schema schema = schema();

    static List<Path> shipped() throws IOException {
        try (Stream<Path> files = Files.list(SCENES)) {
            return files.filter(file -> file.toString().endsWith(".json")
                            && !file.toString().endsWith(".schema.json"))
                    .sorted()
                    .toList();
        }
    }

    @ParameterizedTest
    @MethodSource("shipped")
    void fitTheSchemaAndTheReader(Path file) throws IOException {
        assertThat(schema.validate(Files.readString(file), InputFormat.JSON)).isEmpty();
        assertThatCode(() -> SceneReader.read(file)).doesNotThrowAnyException();
    }

    @ParameterizedTest
    @CsvSource({"spheres-100.json, 100, 3, day.hdr", "spheres-10000.json, 10000, 1, sunset.hdr"})
    void generatedOnesAreWhatTheGeneratorMakes(String name, int count, long seed, String skybox, @TempDir Path folder)
            throws IOException {
        Path file = Files.createDirectory(folder.resolve("scenes")).resolve(name);

        SceneWriter.write(
                SceneGenerator.spheres(count, seed, folder.resolve("skyboxes").resolve(skybox)), file);

        assertThat(file).hasSameBinaryContentAs(SCENES.resolve(name));
    }

    @Test
    void schemaTakesTheSamples() {
        assertThat(schema.validate(SampleScene.TEXT, InputFormat.JSON)).isEmpty();
        assertThat(schema.validate(SampleScene.MATERIALS, InputFormat.JSON)).isEmpty();
        String other =
                SampleScene.with("\"width\": 640", "\"width\": 6.4e2").replace("\"version\": 1", "\"version\": 1.0");
        assertThat(schema.validate(other, InputFormat.JSON)).isEmpty();
    }

    @ParameterizedTest
    @FieldSource("SEEN_BY_SCHEMA")
    void schemaRefusesWhatTheReaderRefuses(SpoiltScenes.Spoilt spoilt) {
        assertThat(schema.validate(spoilt.text(), InputFormat.JSON)).isNotEmpty();
    }

    private static Schema schema() {
        try {
            return SchemaRegistry.withDefaultDialect(SpecificationVersion.DRAFT_2020_12)
                    .getSchema(Files.readString(SCENES.resolve("scene.schema.json")), InputFormat.JSON);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }
}
