package dev.twister.gui.panel;

import dev.twister.gui.model.CameraNumbers;
import dev.twister.gui.model.SceneNumbers;
import dev.twister.gui.panel.ChoiceRow.Look;
import dev.twister.gui.studio.Studio;
import dev.twister.world.CameraMotion;
import java.util.List;
import java.util.stream.Stream;

/** Where the camera is, and the lens that the picture is seen through. */
final class CameraSection {
    private final Studio studio;
    private final List<NumberRow> numbers;
    private final ChoiceRow<Double> speed;

    CameraSection(Studio studio) {
        this.studio = studio;
        numbers = List.of(
                new NumberRow(CameraNumbers.X, "Alt+Shift+1", studio),
                new NumberRow(CameraNumbers.Y, "Alt+Shift+2", studio),
                new NumberRow(CameraNumbers.Z, "Alt+Shift+3", studio),
                new NumberRow(CameraNumbers.YAW, "Alt+Shift+Y", studio),
                new NumberRow(CameraNumbers.PITCH, "Alt+Shift+U", studio),
                new NumberRow(SceneNumbers.FIELD_OF_VIEW, "Alt+W", studio),
                new NumberRow(SceneNumbers.APERTURE, "Alt+Shift+A", studio),
                new NumberRow(SceneNumbers.FOCUS_DISTANCE, "Alt+Shift+D", studio));
        speed = new ChoiceRow<>(
                "Speed",
                "Walking speed in meters per second; Shift is 4 times as fast.",
                "Alt+Shift+Z",
                metersPerSecond -> new Look(SceneNumbers.FOCUS_DISTANCE.text(metersPerSecond) + " m/s"),
                studio.hand().speedProperty()::set,
                studio::notice);
        studio.hand()
                .speedProperty()
                .subscribe(now -> speed.show(CameraNumbers.SPEEDS, now, CameraMotion.WALK_METERS_PER_SECOND));
        studio.sceneProperty().subscribe(_ -> refresh());
        studio.document().originalProperty().subscribe(_ -> refresh());
    }

    List<PanelRow> rows() {
        return Stream.concat(numbers.stream(), Stream.of(speed)).toList();
    }

    private void refresh() {
        numbers.forEach(row -> row.show(studio.scene(), studio.document().original()));
    }
}
