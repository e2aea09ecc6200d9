package dev.twister.gui.controls;

import java.util.EnumMap;
import java.util.Map;
import java.util.Optional;
import javafx.beans.property.BooleanProperty;
import javafx.beans.value.ObservableValue;
import javafx.scene.control.Button;

/** What commands do, and of those that switch something, whether it is on. */
public final class CommandActions {
    private final Map<Command, Runnable> actions = new EnumMap<>(Command.class);
    private final Map<Command, ObservableValue<Boolean>> states = new EnumMap<>(Command.class);

    public CommandActions on(Command command, Runnable action) {
        actions.put(command, action);
        return this;
    }

    /** A command that switches something. */
    public CommandActions on(Command command, Runnable action, ObservableValue<Boolean> state) {
        states.put(command, state);
        return on(command, action);
    }

    /** A command that switches a property. */
    public CommandActions on(Command command, BooleanProperty property) {
        return on(command, () -> property.set(!property.get()), property);
    }

    public void run(Command command) {
        actions.get(command).run();
    }

    /** A button that runs a command. */
    public Button button(String id, Command command) {
        Button button = new Button(command.label());
        button.setId(id);
        button.setTooltip(Tooltips.of(command));
        button.setOnAction(_ -> run(command));
        return button;
    }

    /** Whether what the command switches is on; empty if it switches nothing. */
    public Optional<ObservableValue<Boolean>> state(Command command) {
        return Optional.ofNullable(states.get(command));
    }
}
