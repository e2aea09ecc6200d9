package dev.twister.gui.files;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.FileSystems;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class ScenePatternsTest {
    private static boolean isOffered(String name) {
        return FileNames.scenePatterns("Linux").stream()
                .anyMatch(pattern -> FileSystems.getDefault()
                        .getPathMatcher("glob:" + pattern)
                        .matches(Path.of(name)));
    }

    @ParameterizedTest
    @ValueSource(strings = {"a.json", "lama.json", "myschema.json", "schema.json", "scene.schema2.json", "drama.json"})
    void scenesAreOffered(String name) {
        assertThat(isOffered(name)).isTrue();
    }

    @ParameterizedTest
    @ValueSource(strings = {"scene.schema.json", "a.schema.json", "scene.txt", "json"})
    void theSchemaIsNot(String name) {
        assertThat(isOffered(name)).isFalse();
    }

    @Test
    void otherSystemsTakeEndingsAlone() {
        assertThat(FileNames.scenePatterns("Windows 11")).containsExactly("*.json");
    }
}
