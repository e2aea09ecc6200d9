package dev.twister.scene.format;

import dev.twister.scene.SceneException;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.Supplier;

/** What is wrong with a scene file: the first {@value #MOST} faults. Used by one thread. */
final class Problems {
    private static final int MOST = 10;

    private final Set<String> lines = new LinkedHashSet<>();

    /** What is read; empty if it is refused, which is remembered. */
    <T> Optional<T> read(Supplier<T> reader) {
        try {
            return Optional.of(reader.get());
        } catch (SceneException problem) {
            problem.getMessage().lines().limit(MOST).forEach(lines::add);
            return Optional.empty();
        }
    }

    void check(Runnable rule) {
        read(() -> {
            rule.run();
            return rule;
        });
    }

    void add(SceneException problem) {
        check(() -> {
            throw problem;
        });
    }

    boolean isFull() {
        return lines.size() >= MOST;
    }

    /** @throws SceneException if there are any, one line each */
    void refuse() {
        if (!lines.isEmpty()) {
            throw new SceneException(String.join("\n", List.copyOf(lines).subList(0, Math.min(MOST, lines.size()))));
        }
    }
}
