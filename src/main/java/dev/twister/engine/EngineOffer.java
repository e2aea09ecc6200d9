package dev.twister.engine;

import java.util.Optional;
import java.util.function.Supplier;

/**
 * An engine that could be used here, before it is opened.
 *
 * @param id the name that commands take
 * @param device what does the work, for a person
 * @param description one line on how it draws
 * @param obstacle why it cannot run here and what to install; empty where it can
 * @param opener makes the engine; throws {@link EngineException} where that fails, or where there is an obstacle
 */
public record EngineOffer(
        String id, String device, String description, Optional<String> obstacle, Supplier<Engine> opener) {
    /** An engine that runs here. */
    public static EngineOffer working(String id, String device, String description, Supplier<Engine> opener) {
        return new EngineOffer(id, device, description, Optional.empty(), opener);
    }

    /** An engine that does not, and why. */
    public static EngineOffer impossible(String id, String device, String description, String obstacle) {
        return new EngineOffer(id, device, description, Optional.of(obstacle), () -> {
            throw doesNotWork(id, obstacle);
        });
    }

    private static EngineException doesNotWork(String id, String obstacle) {
        return new EngineException("engine " + id + " does not work here: " + obstacle);
    }

    public boolean works() {
        return obstacle.isEmpty();
    }

    /**
     * Says what keeps the engine from running, without opening it.
     *
     * @throws EngineException where there is an obstacle
     */
    public void check() {
        obstacle.ifPresent(reason -> {
            throw doesNotWork(id, reason);
        });
    }
}
