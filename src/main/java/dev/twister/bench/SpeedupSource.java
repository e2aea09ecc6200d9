package dev.twister.bench;

import java.util.Optional;

/** Knows how engines compare at the same setting. */
@FunctionalInterface
interface SpeedupSource {
    /** How many times faster than the baseline, by the means of the same frames; empty where that one was not measured. */
    Optional<Double> speedupOver(String baseline, Measurement measurement);
}
