package dev.twister.gui.controls;

import java.util.EnumMap;
import java.util.Map;

/** Maps commands to their actions. */
public final class CommandActions {
    private final Map<Command, Runnable> actions = new EnumMap<>(Command.class);

    public CommandActions on(Command command, Runnable action) {
        actions.put(command, action);
        return this;
    }

    public void run(Command command) {
        actions.get(command).run();
    }
}
