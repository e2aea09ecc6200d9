package dev.twister.engine.auto;

import dev.twister.engine.EngineOffer;
import java.time.Duration;
import java.util.Optional;
import java.util.function.BooleanSupplier;

/** Finds out how fast an engine is. */
@FunctionalInterface
interface EngineTrial {
    /**
     * How long the engine takes for a small picture; empty where it fails, or has not drawn one within the limit.
     *
     * @param cancelled asked again and again; once it is true, the answer does not count and comes soon
     */
    Optional<Duration> frameTime(EngineOffer offer, Duration limit, BooleanSupplier cancelled);
}
