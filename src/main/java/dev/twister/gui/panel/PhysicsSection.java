package dev.twister.gui.panel;

import dev.twister.gui.controls.Command;
import dev.twister.gui.controls.CommandActions;
import dev.twister.gui.controls.Ids;
import dev.twister.gui.controls.Tooltips;
import dev.twister.gui.drawing.DrawingRequest.Motion;
import dev.twister.gui.studio.Studio;
import dev.twister.scene.Scene;
import dev.twister.scene.property.Property;
import dev.twister.scene.property.SceneProperties;
import java.util.List;
import java.util.stream.Stream;
import javafx.scene.control.Button;
import javafx.scene.layout.HBox;

/** Settings of the physics. */
final class PhysicsSection {
    private final SwitchRow moving;
    private final List<PropertyRow> rows;
    private final Button pause;
    private final HBox buttons;

    PhysicsSection(Studio studio, CommandActions actions) {
        moving = new SwitchRow(
                "Physics",
                "Simulate physics. Off: bodies return to their places in the scene.",
                "Alt+M",
                studio.motion()::setOn);
        rows = PropertyRow.following(
                Property.within(SceneProperties.PHYSICS, Scene::physics, Scene::withPhysics), studio);
        pause = button(Command.PAUSE, actions);
        buttons = new HBox(pause, button(Command.STEP, actions), button(Command.RANDOMIZE, actions));
        buttons.getStyleClass().add("buttons");
        studio.motion().motionProperty().subscribe(motion -> show(motion));
    }

    List<PanelRow> rows() {
        return Stream.concat(Stream.of(moving), rows.stream().map(PropertyRow::row))
                .toList();
    }

    HBox buttons() {
        return buttons;
    }

    private void show(Motion motion) {
        moving.show(motion.isOn(), false);
        pause.setText(motion.isOn() && !motion.running() ? "Resume" : Command.PAUSE.label());
        pause.setDisable(!motion.isOn());
    }

    private static Button button(Command command, CommandActions actions) {
        Button button = new Button(command.label());
        button.setId(Ids.of(command.label()));
        button.setTooltip(Tooltips.of(command));
        button.setOnAction(_ -> actions.run(command));
        return button;
    }
}
