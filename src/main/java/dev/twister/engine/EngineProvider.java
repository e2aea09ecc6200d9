package dev.twister.engine;

import java.util.List;
import java.util.Optional;

/** A family of engines, found by {@link java.util.ServiceLoader}; {@link Engines} asks each for what it offers. */
public interface EngineProvider {
    /** What this family offers on this machine, in the order a person should see it; never fails. */
    List<EngineOffer> offers();

    /**
     * How the ids of this family's engines begin where they are devices, before a colon; the name alone stands for the
     * first one. To look for devices takes a noticeable time. Empty where it does not, and there are none.
     */
    default Optional<String> devices() {
        return Optional.empty();
    }
}
