package dev.twister.gui;

import dev.twister.gui.model.SceneNumbers;
import java.util.List;

/** The lens that the picture is seen through. */
final class CameraSection {
    private final Studio studio;
    private final List<NumberRow> numbers;

    CameraSection(Studio studio) {
        this.studio = studio;
        numbers = List.of(
                new NumberRow(SceneNumbers.FIELD_OF_VIEW, "Alt+W", studio),
                new NumberRow(SceneNumbers.APERTURE, "Alt+Shift+A", studio),
                new NumberRow(SceneNumbers.FOCUS_DISTANCE, "Alt+Shift+D", studio));
        studio.sceneProperty().subscribe(_ -> refresh());
        studio.originalProperty().subscribe(_ -> refresh());
    }

    List<PanelRow> rows() {
        return List.copyOf(numbers);
    }

    private void refresh() {
        numbers.forEach(row -> row.show(studio.scene(), studio.original()));
    }
}
