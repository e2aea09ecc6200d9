package dev.twister.gui.files;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.scene.select.Title;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;

class CopiedTitleTest {
    private static final Title BENCHMARK = new Title("benchmark", "The paper's scene.");
    private static final Path COPY = Path.of("rooms", "room 1.2.json");

    @Test
    void aCopyIsCalledAsItsFile() {
        assertThat(SceneSaving.copiedTitle(BENCHMARK, BENCHMARK, COPY, false))
                .isEqualTo(new Title("room 1.2", "The paper's scene."));
    }

    @Test
    void theDescriptionOfAShippedSceneIsOfNoOther() {
        assertThat(SceneSaving.copiedTitle(BENCHMARK, BENCHMARK, COPY, true)).isEqualTo(new Title("room 1.2", ""));
    }

    @Test
    void whatSomeoneHasEnteredStays() {
        Title own = new Title("mine", "My own.");
        assertThat(SceneSaving.copiedTitle(own, BENCHMARK, COPY, true)).isEqualTo(own);
    }
}
