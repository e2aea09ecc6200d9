package dev.twister.engine;

import java.util.List;

/** A family of engines, found by {@link java.util.ServiceLoader}; {@link Engines} asks each for what it offers. */
public interface EngineProvider {
    /** What this family offers on this machine, in the order a person should see it; never fails. */
    List<EngineOffer> offers();

    /** Whether it takes a noticeable time to say what there is, because drivers and devices are looked for. */
    default boolean looksForDevices() {
        return false;
    }
}
