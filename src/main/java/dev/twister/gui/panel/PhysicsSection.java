package dev.twister.gui.panel;

import dev.twister.gui.controls.Command;
import dev.twister.gui.controls.CommandActions;
import dev.twister.gui.controls.Ids;
import dev.twister.gui.controls.Tooltips;
import dev.twister.gui.drawing.DrawingRequest.Motion;
import dev.twister.gui.property.SceneNumbers;
import dev.twister.gui.studio.Studio;
import dev.twister.scene.Scene;
import java.util.List;
import java.util.stream.Stream;
import javafx.scene.control.Button;
import javafx.scene.layout.HBox;

/** Settings of the physics. */
final class PhysicsSection {
    private final SwitchRow moving;
    private final List<NumberRow> numbers;
    private final SwitchRow walls;
    private final Button pause;
    private final HBox buttons;

    PhysicsSection(Studio studio, CommandActions actions) {
        moving = new SwitchRow(
                "Physics",
                "Simulate physics. Off: bodies return to their places in the scene.",
                "Alt+M",
                studio.motion()::setOn);
        numbers = NumberRow.of(SceneNumbers.PHYSICS, studio);
        walls = new SwitchRow(
                "Walls", "Invisible walls on the border of the plane hold the spheres.", "Alt+Shift+W", on -> {
                    studio.edit(
                            "walls", scene -> scene.withPhysics(scene.physics().withWalls(on)));
                    studio.endGesture();
                });
        pause = button(Command.PAUSE, actions);
        buttons = new HBox(pause, button(Command.STEP, actions), button(Command.RANDOMIZE, actions));
        buttons.getStyleClass().add("buttons");
        studio.motion().motionProperty().subscribe(motion -> show(motion));
        studio.sceneProperty().subscribe(scene -> show(scene, studio.document().original()));
        studio.document().originalProperty().subscribe(original -> show(studio.scene(), original));
    }

    List<PanelRow> rows() {
        return Stream.of(Stream.of(moving), numbers.stream(), Stream.of(walls))
                .<PanelRow>flatMap(rows -> rows)
                .toList();
    }

    HBox buttons() {
        return buttons;
    }

    private void show(Scene scene, Scene usual) {
        numbers.forEach(row -> row.show(scene, usual));
        walls.show(scene.physics().walls(), usual.physics().walls());
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
