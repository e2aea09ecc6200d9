package dev.twister.gui.panel;

import dev.twister.gui.panel.ChoiceRow.Look;
import dev.twister.gui.property.PropertyNumbers;
import dev.twister.gui.studio.Studio;
import dev.twister.scene.Camera;
import dev.twister.scene.Scene;
import dev.twister.scene.property.CameraProperties;
import dev.twister.scene.property.Property;
import dev.twister.world.animation.CameraMotion;
import java.util.List;
import java.util.stream.Stream;

/** The camera's position, direction and lens. */
final class CameraSection {
    /** Walking speeds in meters per second. */
    private static final List<Double> SPEEDS = List.of(0.2, 0.5, 1.0, 2.0, 5.0, 10.0, 20.0, 50.0, 100.0);

    private final List<PropertyRow> rows;
    private final ChoiceRow<Double> speed;

    CameraSection(Studio studio) {
        rows = PropertyRow.follow(
                CameraProperties.ALL.stream()
                        .flatMap(property -> rows(property, studio))
                        .toList(),
                studio);
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
    }

    private static <V> Stream<PropertyRow> rows(Property<Camera, V> property, Studio studio) {
        Stream<PropertyRow> own = PropertyRow.of(property.within(Scene::camera, Scene::withCamera), studio);
        return property.equals(CameraProperties.FIELD_OF_VIEW)
                ? Stream.concat(own, Stream.of(PropertyRow.of(property, PropertyNumbers.focalLength(), studio)))
                : own;
    }

    List<PanelRow> rows() {
        return Stream.concat(rows.stream().map(PropertyRow::row), Stream.of(speed))
                .toList();
    }
}
