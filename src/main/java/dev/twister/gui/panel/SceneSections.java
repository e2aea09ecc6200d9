package dev.twister.gui.panel;

import dev.twister.gui.controls.Command;
import dev.twister.gui.controls.CommandActions;
import dev.twister.gui.controls.Ids;
import dev.twister.gui.controls.Tooltips;
import dev.twister.gui.edit.BodyNumber;
import dev.twister.gui.panel.ChoiceRow.Look;
import dev.twister.gui.property.PropertyNumbers;
import dev.twister.gui.studio.Studio;
import dev.twister.scene.Camera;
import dev.twister.scene.Scene;
import dev.twister.scene.property.BodyProperties;
import dev.twister.scene.property.CameraProperties;
import dev.twister.scene.property.Property;
import dev.twister.scene.property.SceneProperties;
import dev.twister.world.animation.CameraMotion;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import javafx.scene.control.Button;
import javafx.scene.layout.HBox;

/** The sections of what the scene has one of: a camera, a plane and physics. */
final class SceneSections {
    /** Walking speeds in meters per second. */
    private static final List<Double> SPEEDS = List.of(0.2, 0.5, 1.0, 2.0, 5.0, 10.0, 20.0, 50.0, 100.0);

    private SceneSections() {}

    /** The camera's position, direction and lens. */
    static PanelSection camera(Studio studio) {
        List<PanelRow> rows = new ArrayList<>(PropertyRow.follow(
                CameraProperties.ALL.stream()
                        .flatMap(property -> camera(property, studio))
                        .toList(),
                studio));
        ChoiceRow<Double> speed = new ChoiceRow<>(
                "Speed",
                "Walking speed in meters per second; Shift is 4 times as fast.",
                "Alt+Shift+Z",
                metersPerSecond ->
                        new Look(PropertyNumbers.FOCUS_DISTANCE.scale().text(metersPerSecond) + " m/s"),
                studio.cameraControl().speedProperty()::set,
                studio::notice);
        speed.follow(studio.cameraControl().speedProperty(), SPEEDS, CameraMotion.WALK_METERS_PER_SECOND);
        rows.add(speed);
        return new PanelSection("Camera", rows);
    }

    private static <V> Stream<PropertyRow> camera(Property<Camera, V> property, Studio studio) {
        Stream<PropertyRow> own = PropertyRow.of(property.within(Scene::camera, Scene::withCamera), studio);
        return property.equals(CameraProperties.FIELD_OF_VIEW)
                ? Stream.concat(own, Stream.of(PropertyRow.of(property, PropertyNumbers.focalLength(), studio)))
                : own;
    }

    /** The plane's size and height; its colors are those of a selected body. */
    static PanelSection plane(Studio studio) {
        Button select = new Button("Colors and material…");
        select.setId("select-plane");
        select.setTooltip(Tooltips.of("Selects the plane, so that Material shows its colors and reflectivity."));
        select.setOnAction(_ -> studio.selection().select(BodyNumber.PLANE));
        return new PanelSection(
                "Plane",
                PropertyRow.following(Property.within(BodyProperties.PLANE, Scene::ground, Scene::withGround), studio),
                buttons(select));
    }

    /** Whether and how bodies fall, and buttons to pause them and to start from other places. */
    static PanelSection physics(Studio studio, CommandActions actions) {
        SwitchRow moving = new SwitchRow(
                "Physics",
                "Simulate physics. Off: bodies return to their places in the scene.",
                "Alt+M",
                studio.motion()::setOn);
        Button pause = button(Command.PAUSE, actions);
        studio.motion().motionProperty().subscribe(motion -> {
            moving.show(motion.isOn(), false);
            pause.setText(motion.isOn() && !motion.running() ? "Resume" : Command.PAUSE.label());
            pause.setDisable(!motion.isOn());
        });
        List<PanelRow> rows = new ArrayList<>(List.of(moving));
        rows.addAll(PropertyRow.following(
                Property.within(SceneProperties.PHYSICS, Scene::physics, Scene::withPhysics), studio));
        return new PanelSection(
                "Physics", rows, buttons(pause, button(Command.STEP, actions), button(Command.RANDOMIZE, actions)));
    }

    private static Button button(Command command, CommandActions actions) {
        return actions.button(Ids.of(command.label()), command);
    }

    private static HBox buttons(Button... of) {
        HBox buttons = new HBox(of);
        buttons.getStyleClass().add("buttons");
        return buttons;
    }
}
