package dev.twister.gui;

import dev.twister.gui.drawing.Motion;
import dev.twister.gui.model.SceneNumbers;
import java.util.List;
import javafx.scene.control.Button;
import javafx.scene.layout.HBox;

/** Bodies that move. */
final class PhysicsSection {
    private final SwitchRow moving;
    private final NumberRow gravity;
    private final Button pause;
    private final HBox buttons;

    PhysicsSection(Studio studio, CommandActions actions) {
        moving = new SwitchRow(
                "Physics",
                "Whether bodies fall and collide; off puts them back where the scene has them.",
                "Alt+M",
                studio::setMoving);
        gravity = new NumberRow(SceneNumbers.GRAVITY, "Alt+Y", studio);
        pause = button(Command.PAUSE, actions);
        buttons = new HBox(pause, button(Command.STEP, actions), button(Command.RANDOMISE, actions));
        buttons.getStyleClass().add("buttons");
        studio.motionProperty().subscribe(this::show);
        studio.sceneProperty().subscribe(scene -> gravity.show(scene, studio.original()));
        studio.originalProperty().subscribe(original -> gravity.show(studio.scene(), original));
    }

    List<PanelRow> rows() {
        return List.of(moving, gravity);
    }

    HBox buttons() {
        return buttons;
    }

    private void show(Motion motion) {
        moving.show(motion.isOn(), false);
        pause.setText(motion.isOn() && !motion.running() ? "Go on" : Command.PAUSE.label());
        pause.setDisable(!motion.isOn());
    }

    private static Button button(Command command, CommandActions actions) {
        Button button = new Button(command.label());
        button.setId(PanelRow.id(command.label()));
        button.setTooltip(
                PanelRow.tooltip(command.hint() + "\nKey: " + command.keys().getDisplayText()));
        button.setOnAction(_ -> actions.run(command));
        return button;
    }
}
