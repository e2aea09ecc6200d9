package dev.twister.engine.auto;

import java.time.Duration;
import java.util.Optional;

/**
 * What an engine's trial came to.
 *
 * @param engine its id
 * @param frame its fastest frame; empty where it drew none in the time it had
 */
public record EngineTime(String engine, Optional<Duration> frame) {}
