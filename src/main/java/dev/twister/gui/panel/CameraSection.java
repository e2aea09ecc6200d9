package dev.twister.gui.panel;

import dev.twister.gui.panel.ChoiceRow.Look;
import dev.twister.gui.property.PropertyNumbers;
import dev.twister.gui.studio.Studio;
import dev.twister.world.animation.CameraMotion;
import java.util.List;
import java.util.stream.Stream;

/** The camera's position, direction and lens. */
final class CameraSection {
    /** Walking speeds in meters per second. */
    private static final List<Double> SPEEDS = List.of(0.2, 0.5, 1.0, 2.0, 5.0, 10.0, 20.0, 50.0, 100.0);

    private final Studio studio;
    private final List<NumberRow> numbers;
    private final ChoiceRow<Double> speed;

    CameraSection(Studio studio) {
        this.studio = studio;
        numbers = NumberRow.of(PropertyNumbers.ofCamera(), studio);
        speed = new ChoiceRow<>(
                "Speed",
                "Walking speed in meters per second; Shift is 4 times as fast.",
                "Alt+Shift+Z",
                metersPerSecond ->
                        new Look(PropertyNumbers.FOCUS_DISTANCE.scale().text(metersPerSecond) + " m/s"),
                studio.cameraControl().speedProperty()::set,
                studio::notice);
        studio.cameraControl()
                .speedProperty()
                .subscribe(now -> speed.show(SPEEDS, now, CameraMotion.WALK_METERS_PER_SECOND));
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
