package dev.twister.gui.edit;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.scene.Camera;
import dev.twister.scene.CameraView;
import dev.twister.scene.Scene;
import dev.twister.scene.Vector3;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class ViewEditsTest {
    private static final Camera CAMERA = Camera.of(new Vector3(1, 2, 3), 4, 5, 60);
    private static final Camera OTHER = CAMERA.withYawDegrees(90);
    private static final Scene SCENE = Scene.under(Path.of("sky"))
            .withViews(List.of(new CameraView("Front", CAMERA), new CameraView("View 3", CAMERA)));

    @ParameterizedTest
    @CsvSource({"1, 0", "2, 1", "9, 8", "0, 9"})
    void numberKeysLeadToTheFirstTen(int digit, int index) {
        assertThat(ViewEdits.ofKey(digit)).isEqualTo(index);
        assertThat(ViewEdits.key(index)).hasValue(digit);
    }

    @Test
    void noKeyLeadsToTheEleventh() {
        assertThat(ViewEdits.key(10)).isEmpty();
    }

    @Test
    void anotherOneHasANameOfItsOwn() {
        assertThat(ViewEdits.added(SCENE, OTHER).views().getLast()).isEqualTo(new CameraView("View 4", OTHER));
        assertThat(ViewEdits.added(SCENE.withViews(List.of()), OTHER).views())
                .containsExactly(new CameraView("View 1", OTHER));
    }

    @Test
    void oneIsUpdatedRenamedAndDeleted() {
        CameraView second = SCENE.views().get(1);

        assertThat(ViewEdits.updated(SCENE, 0, OTHER).views()).containsExactly(new CameraView("Front", OTHER), second);
        assertThat(ViewEdits.renamed(SCENE, 0, "Back").views()).containsExactly(new CameraView("Back", CAMERA), second);
        assertThat(ViewEdits.deleted(SCENE, 0).views()).containsExactly(second);
    }

    @Test
    void aNameMustBeFreeAndNotEmpty() {
        assertThat(ViewEdits.complaint(SCENE, 0, "Front")).isEmpty();
        assertThat(ViewEdits.complaint(SCENE, 0, "View 3")).contains("Another view is called 'View 3'");
        assertThat(ViewEdits.complaint(SCENE, 0, "")).contains("A view's name has 1 to 200 characters");
        assertThat(ViewEdits.complaint(SCENE, 0, "a".repeat(201))).isPresent();
        assertThat(ViewEdits.complaint(SCENE, 0, "a".repeat(200))).isEmpty();
    }
}
