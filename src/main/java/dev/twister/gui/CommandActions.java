package dev.twister.gui;

import java.util.EnumMap;
import java.util.Map;

/** What each command does. */
final class CommandActions {
    private final Map<Command, Runnable> actions = new EnumMap<>(Command.class);

    CommandActions on(Command command, Runnable action) {
        actions.put(command, action);
        return this;
    }

    void run(Command command) {
        actions.get(command).run();
    }
}
