package dev.twister.engine.auto;

import dev.twister.engine.Engine;
import dev.twister.engine.EngineException;
import dev.twister.engine.EngineOffer;
import dev.twister.engine.Engines;
import dev.twister.engine.JvmEngines;
import java.time.Duration;
import java.time.LocalDate;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.locks.LockSupport;
import java.util.function.BooleanSupplier;
import java.util.function.Supplier;
import java.util.stream.Stream;

/**
 * Chooses the fastest engine by measuring each on this machine, and remembers it for a month. Pictures are rendered
 * meanwhile; benchmarks wait. That {@code parallel} was the fastest beside others is not believed, as the machine may
 * have been busy: it is confirmed beside the frames of each run. {@code twister devices --measure} measures at once.
 */
public final class FastestEngine {
    /** The name that stands for the fastest engine. */
    public static final String AUTO = "auto";

    /** Excluded: this engine itself, and {@code sequential}, which {@code parallel} supersedes. */
    private static final Set<String> NEVER_TAKEN = Set.of(AUTO, JvmEngines.SEQUENTIAL);

    /** Assumed to be the fastest until engines have been measured; see {@code docs/decisions/008}. */
    private static final String MOSTLY_FASTEST = "vector";

    /** How long frames may wait for the successor, in total. */
    private static final Duration PATIENCE = Duration.ofSeconds(3);

    private static final long LOOK_NANOS = 20_000_000;

    /**
     * Time limit for trials of all JVM engines together, mostly for JIT compilation; a trial ends earlier once it
     * settles.
     */
    private static final Duration JVM_TRIALS = Duration.ofSeconds(30);

    /** Time limit for trials of all devices together, whose first frame includes kernel compilation. */
    private static final Duration DEVICE_TRIALS = Duration.ofSeconds(60);

    private final Trial trial;
    private final ChoiceStore store;
    private final Waiting waiting;

    /** Measures the speed of an engine. */
    @FunctionalInterface
    interface Trial {
        /**
         * The engine's time for a small frame; empty if it fails or renders none within the limit.
         *
         * @param canceled polled; once true, the call returns soon and the result is ignored
         */
        Optional<Duration> frameTime(EngineOffer offer, Duration limit, BooleanSupplier canceled);
    }

    /**
     * The result of an engine's trial.
     *
     * @param engine its id
     * @param frame its fastest frame; empty if it rendered none in time
     */
    public record Time(String engine, Optional<Duration> frame) {}

    /** Waits for a duration, or until canceled. */
    @FunctionalInterface
    interface Waiting {
        void await(Duration time, BooleanSupplier canceled);
    }

    FastestEngine(Trial trial, ChoiceStore store, Waiting waiting) {
        this.trial = trial;
        this.store = store;
        this.waiting = waiting;
    }

    /** Measures with the system clock, and remembers in the user's cache folder. */
    public static FastestEngine ofThisMachine() {
        return new FastestEngine(new TimedTrial(), ChoiceStore.ofThisUser(), FastestEngine::sleep);
    }

    /**
     * Opens an engine that renders at once and switches to the remembered fastest engine as soon as that one is warm.
     * If none is remembered, it switches to the engine that usually is the fastest, and measures the candidates in the
     * background.
     *
     * @throws EngineException if no engine can be opened
     */
    public Engine openAtOnce(List<EngineOffer> offers) {
        List<EngineOffer> candidates = candidates(offers);
        return trusted(remembered(offers), candidates)
                .map(id -> openWarming(openUnmeasured(candidates), id, candidates))
                .orElseGet(() -> openToBeConfirmed(MOSTLY_FASTEST, candidates, () -> offers));
    }

    /**
     * As above, but looks for devices at once only if one of them is remembered as the fastest. Otherwise it looks for
     * them later, in the background, and measures all engines if the devices have changed.
     *
     * @param atOnce the engines that do not run on devices
     * @param all those engines and the devices; may take a while
     * @throws EngineException if no engine can be opened
     */
    public Engine openAtOnce(List<EngineOffer> atOnce, Supplier<List<EngineOffer>> all) {
        List<EngineOffer> candidates = candidates(atOnce);
        Optional<String> known = trusted(store.read(MachineKey.beforeDevices(candidates)), candidates);
        boolean device =
                known.filter(id -> Engines.find(candidates, id).isEmpty()).isPresent();
        if (candidates.isEmpty() || device) {
            return openAtOnce(all.get());
        }
        return openToBeConfirmed(known.orElse(MOSTLY_FASTEST), candidates, all);
    }

    /**
     * That {@code parallel} is the fastest beside others may have been measured on a busy machine or before the JIT was
     * done. Then the usual engine warms up, and takes over only if it renders the same frames faster.
     */
    private static Optional<String> trusted(Optional<String> remembered, List<EngineOffer> candidates) {
        return remembered.filter(id -> !id.equals(JvmEngines.PARALLEL) || candidates.size() == 1);
    }

    private Engine openToBeConfirmed(String id, List<EngineOffer> candidates, Supplier<List<EngineOffer>> all) {
        Engine standIn = openUnmeasured(candidates);
        Engine drawing = openWarming(standIn, id, candidates);
        return new AutoEngine(
                drawing,
                new Successor(canceled -> confirmedBeside(List.of(standIn.id(), id), all, canceled)),
                () -> openUnmeasured(candidates));
    }

    private static Engine openWarming(Engine standIn, String id, List<EngineOffer> candidates) {
        return Optional.of(id)
                .filter(wanted -> !wanted.equals(standIn.id()))
                .flatMap(wanted -> Engines.find(candidates, wanted))
                .<Engine>map(offer -> new AutoEngine(
                        standIn, new Successor(_ -> opened(offer), PATIENCE), () -> openUnmeasured(candidates)))
                .orElse(standIn);
    }

    /**
     * In the background, finds out whether another engine than those that render or warm up already is the fastest of
     * all, including devices.
     */
    private Optional<Engine> confirmedBeside(
            List<String> atWork, Supplier<List<EngineOffer>> all, BooleanSupplier canceled) {
        waiting.await(Successor.WARMING, canceled);
        if (canceled.getAsBoolean()) {
            return Optional.empty();
        }
        List<EngineOffer> candidates = candidates(all.get());
        Optional<String> known = remembered(candidates);
        MachineKey early = MachineKey.beforeDevices(candidates);
        known.filter(id -> !store.read(early).equals(Optional.of(id))).ifPresent(id -> store.write(early, id));
        return known.or(() -> fastestBeside(candidates, canceled))
                .filter(fastest -> !atWork.contains(fastest) && !canceled.getAsBoolean())
                .flatMap(fastest -> Engines.find(candidates, fastest))
                .flatMap(FastestEngine::opened);
    }

    /**
     * Trials slow down the frames and are slowed down by them, so {@code parallel} is not measured where there is
     * another: that one replaces it only when it renders the same frames faster.
     */
    private Optional<String> fastestBeside(List<EngineOffer> candidates, BooleanSupplier canceled) {
        List<EngineOffer> others = candidates.stream()
                .filter(offer -> !offer.id().equals(JvmEngines.PARALLEL))
                .toList();
        List<EngineOffer> rivals = others.isEmpty() ? candidates : others;
        Optional<String> fastest =
                rivals.size() == 1 ? Optional.of(rivals.getFirst().id()) : fastestOf(measure(rivals, canceled));
        remember(candidates, fastest, canceled);
        return fastest;
    }

    private void remember(List<EngineOffer> candidates, Optional<String> fastest, BooleanSupplier canceled) {
        fastest.filter(_ -> !canceled.getAsBoolean()).ifPresent(id -> {
            store.write(MachineKey.beforeDevices(candidates), id);
            // Written last: a reader of this entry may rely on the other one.
            store.write(MachineKey.of(candidates), id);
        });
    }

    private static Optional<String> fastestOf(List<Time> times) {
        return times.stream()
                .filter(time -> time.frame().isPresent())
                .map(Time::engine)
                .findFirst();
    }

    /**
     * Opens the remembered fastest engine, or measures now and waits for the result.
     *
     * @throws EngineException if no engine can be opened
     */
    public Engine openMeasured(List<EngineOffer> offers) {
        List<EngineOffer> candidates = candidates(offers);
        Optional<EngineOffer> known = remembered(offers).flatMap(id -> Engines.find(candidates, id));
        if (known.isPresent()) {
            try {
                return known.get().opener().get();
            } catch (EngineException _) {
                // Something has changed since, such as a driver: measure again.
            }
        }
        return openFirst(candidates, measureAll(candidates));
    }

    private static void sleep(Duration time, BooleanSupplier canceled) {
        long end = System.nanoTime() + time.toNanos();
        while (System.nanoTime() < end && !canceled.getAsBoolean()) {
            LockSupport.parkNanos(LOOK_NANOS);
        }
    }

    private static Optional<Engine> opened(EngineOffer offer) {
        return Optional.of(offer.opener().get());
    }

    /** The id of the engine that {@link #openMeasured} would open, if one is remembered. */
    public Optional<String> remembered(List<EngineOffer> offers) {
        List<EngineOffer> candidates = candidates(offers);
        return store.read(MachineKey.of(candidates))
                .filter(id -> Engines.find(candidates, id).isPresent());
    }

    /** The day on which the remembered engine was measured. */
    public Optional<LocalDate> day(List<EngineOffer> offers) {
        return store.day(MachineKey.of(candidates(offers)));
    }

    /**
     * Measures all engines, with enough time for the devices' compilers, and remembers the fastest. It is first in the
     * list.
     */
    public List<Time> measurePatiently(List<EngineOffer> offers) {
        return measureAll(candidates(offers));
    }

    private List<Time> measureAll(List<EngineOffer> candidates) {
        List<Time> times = measure(candidates, () -> false);
        remember(candidates, fastestOf(times), () -> false);
        return times;
    }

    /** JVM engines are measured first: no device compiler is still running during their trials. */
    private List<Time> measure(List<EngineOffer> candidates, BooleanSupplier canceled) {
        return candidates.stream()
                .sorted(Comparator.comparing(offer -> Engines.isDevice(offer.id())))
                .map(offer -> new Time(offer.id(), trial.frameTime(offer, limit(offer, candidates), canceled)))
                .sorted(Comparator.comparing(
                        time -> time.frame().orElse(null), Comparator.nullsLast(Comparator.naturalOrder())))
                .toList();
    }

    /** This engine's share of the time for trials. */
    private static Duration limit(EngineOffer offer, List<EngineOffer> all) {
        boolean device = Engines.isDevice(offer.id());
        long sharers = all.stream()
                .filter(other -> Engines.isDevice(other.id()) == device)
                .count();
        return (device ? DEVICE_TRIALS : JVM_TRIALS).dividedBy(Math.max(1, sharers));
    }

    private static Engine openUnmeasured(List<EngineOffer> candidates) {
        return openFirst(candidates, List.of());
    }

    /** Tries the measured engines, fastest first, then the paper's baseline, then the others. */
    private static Engine openFirst(List<EngineOffer> candidates, List<Time> times) {
        List<EngineOffer> order = Stream.of(
                        times.stream().filter(time -> time.frame().isPresent()).map(Time::engine),
                        Stream.of(JvmEngines.PARALLEL),
                        candidates.stream().map(EngineOffer::id))
                .flatMap(ids -> ids)
                .distinct()
                .flatMap(id -> Engines.find(candidates, id).stream())
                .toList();
        EngineException failure = new EngineException("no engine works here; 'twister devices' says why");
        for (EngineOffer offer : order) {
            try {
                return offer.opener().get();
            } catch (EngineException notThis) {
                failure.addSuppressed(notThis);
            }
        }
        throw failure;
    }

    private static List<EngineOffer> candidates(List<EngineOffer> offers) {
        return offers.stream()
                .filter(EngineOffer::works)
                .filter(offer -> !NEVER_TAKEN.contains(offer.id()))
                .toList();
    }
}
