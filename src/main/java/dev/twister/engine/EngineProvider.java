package dev.twister.engine;

import java.util.List;
import java.util.Optional;

/** A family of engines, found by {@link java.util.ServiceLoader} and listed by {@link Engines}. */
public interface EngineProvider {
    /** The family's engines on this machine, in display order. Never throws. */
    List<EngineOffer> offers();

    /**
     * The prefix, before a colon, of the ids of this family's engines if they run on devices. The prefix alone names
     * the first device. Empty for families without devices; looking for devices takes noticeable time.
     */
    default Optional<String> devices() {
        return Optional.empty();
    }
}
