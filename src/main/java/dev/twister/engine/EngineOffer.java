package dev.twister.engine;

import java.util.Optional;
import java.util.function.Supplier;

/**
 * An engine that could be used here, before it is opened.
 *
 * @param id the name that commands take
 * @param device what does the work, for a person
 * @param driver the version of the device's driver; empty where there is none
 * @param description one line on how it draws
 * @param obstacle why it cannot run here and what to install; empty where it can
 * @param opener makes the engine; throws {@link EngineException} where that fails, or where there is an obstacle
 */
public record EngineOffer(
        String id,
        String device,
        Optional<String> driver,
        String description,
        Optional<String> obstacle,
        Supplier<Engine> opener) {
    /** An engine that runs here, without a driver. */
    public static EngineOffer working(String id, String device, String description, Supplier<Engine> opener) {
        return new EngineOffer(id, device, Optional.empty(), description, Optional.empty(), opener);
    }

    /** The same by a driver of that version. */
    public EngineOffer withDriver(Optional<String> version) {
        return new EngineOffer(id, device, version, description, obstacle, opener);
    }

    /** An engine that does not, and why. */
    public static EngineOffer impossible(String id, String device, String description, String obstacle) {
        return new EngineOffer(id, device, Optional.empty(), description, Optional.of(obstacle), () -> {
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
