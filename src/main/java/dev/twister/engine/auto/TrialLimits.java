package dev.twister.engine.auto;

import dev.twister.engine.EngineOffer;
import dev.twister.engine.Engines;
import java.time.Duration;
import java.util.List;

/**
 * How long the trials may take.
 *
 * @param jvm for all engines of the JVM together
 * @param devices for all devices together, whose first frame waits for TornadoVM's compiler
 */
record TrialLimits(Duration jvm, Duration devices) {
    /** Time for the JVM's compiler, and for devices to compile the kernel; a trial that settles ends sooner. */
    static final TrialLimits PATIENT = new TrialLimits(Duration.ofSeconds(30), Duration.ofSeconds(60));

    /** This engine's share. */
    Duration of(EngineOffer offer, List<EngineOffer> all) {
        boolean device = Engines.isDevice(offer.id());
        long sharers = all.stream()
                .filter(other -> Engines.isDevice(other.id()) == device)
                .count();
        return (device ? devices : jvm).dividedBy(Math.max(1, sharers));
    }
}
