package dev.twister.engine;

import java.util.Optional;
import java.util.function.Supplier;

/**
 * An engine of this machine, before it is opened.
 *
 * @param id the name for commands
 * @param device the processor's or device's name, for display
 * @param driver version of the device's driver; empty if there is none
 * @param description one line on how it renders
 * @param obstacle why it cannot run here and what to install; empty if it can run
 * @param opener opens the engine; throws {@link EngineException} if that fails or if there is an obstacle
 */
public record EngineOffer(
        String id,
        String device,
        Optional<String> driver,
        String description,
        Optional<String> obstacle,
        Supplier<Engine> opener) {
    /** An engine that runs here and needs no driver. */
    public static EngineOffer working(String id, String device, String description, Supplier<Engine> opener) {
        return new EngineOffer(id, device, Optional.empty(), description, Optional.empty(), opener);
    }

    /** The same engine with the version of its driver. */
    public EngineOffer withDriver(String version) {
        return new EngineOffer(id, device, Optional.of(version), description, obstacle, opener);
    }

    /** An engine that cannot run here, with the reason. */
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
     * Checks that the engine can run, without opening it.
     *
     * @throws EngineException if there is an obstacle
     */
    public void check() {
        obstacle.ifPresent(reason -> {
            throw doesNotWork(id, reason);
        });
    }
}
