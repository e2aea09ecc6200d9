package dev.twister.mesh.input;

import dev.twister.mesh.MeshException;
import java.util.HashSet;
import java.util.Set;
import java.util.function.Consumer;

/** Reports unsupported features and faults of a file: each once, as one line with the file's name, up to a limit. */
public final class Warnings {
    private static final int MOST = 200;

    private final String name;
    private final Consumer<String> listener;
    private final Set<String> said = new HashSet<>();

    public Warnings(String name, Consumer<String> listener) {
        this.name = name;
        this.listener = listener;
    }

    public void add(String warning) {
        if (said.size() <= MOST && said.add(warning)) {
            listener.accept(name + ": " + (said.size() > MOST ? "further warnings are left out" : warning));
        }
    }

    /** Adds a problem that does not prevent the rest of the file from being read. */
    public void add(MeshException problem, String consequence) {
        String message = problem.getMessage();
        String start = name + ": ";
        add((message.startsWith(start) ? message.substring(start.length()) : message) + consequence);
    }
}
