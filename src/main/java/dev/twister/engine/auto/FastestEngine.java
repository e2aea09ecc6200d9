package dev.twister.engine.auto;

import dev.twister.engine.Engine;
import dev.twister.engine.EngineException;
import dev.twister.engine.EngineOffer;
import dev.twister.engine.Engines;
import dev.twister.engine.JvmEngines;
import java.time.Duration;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.locks.LockSupport;
import java.util.function.BooleanSupplier;
import java.util.function.Supplier;
import java.util.stream.Stream;

/**
 * Chooses the fastest engine by measuring each once on this machine, and remembers which it was. A picture does not
 * wait for that; a benchmark does.
 */
public final class FastestEngine {
    /** The name that stands for whichever engine is the fastest here. */
    public static final String AUTO = "auto";

    /** Itself, and what parallel does with more threads. */
    private static final Set<String> NEVER_TAKEN = Set.of(AUTO, JvmEngines.SEQUENTIAL);

    /** Assumed until engines have been measured: {@code docs/decisions/008}. */
    private static final String MOSTLY_FASTEST = "vector";

    /** How long frames wait for it, all together. */
    private static final Duration PATIENCE = Duration.ofSeconds(3);

    private static final long LOOK_NANOS = 20_000_000;

    /** Time for the JVM's compiler, for all engines of the JVM together; a trial that settles ends sooner. */
    private static final Duration JVM_TRIALS = Duration.ofSeconds(30);

    /** For all devices together, whose first frame waits for the kernel's compiler. */
    private static final Duration DEVICE_TRIALS = Duration.ofSeconds(60);

    private final Trial trial;
    private final ChoiceStore store;
    private final Waiting waiting;

    /** Finds out how fast an engine is. */
    @FunctionalInterface
    interface Trial {
        /**
         * How long the engine takes for a small picture; empty where it fails, or has not drawn one within the limit.
         *
         * @param canceled asked again and again; once it is true, the answer does not count and comes soon
         */
        Optional<Duration> frameTime(EngineOffer offer, Duration limit, BooleanSupplier canceled);
    }

    /**
     * What an engine's trial came to.
     *
     * @param engine its id
     * @param frame its fastest frame; empty where it drew none in the time it had
     */
    public record Time(String engine, Optional<Duration> frame) {}

    /** Lets so much time go by, or less where nobody waits for what comes after it. */
    @FunctionalInterface
    interface Waiting {
        void await(Duration time, BooleanSupplier canceled);
    }

    FastestEngine(Trial trial, ChoiceStore store, Waiting waiting) {
        this.trial = trial;
        this.store = store;
        this.waiting = waiting;
    }

    /** Measures with a clock, and remembers in the user's cache folder. */
    public static FastestEngine ofThisMachine() {
        return new FastestEngine(new TimedTrial(), ChoiceStore.ofThisUser(), FastestEngine::sleep);
    }

    /**
     * Opens an engine that draws at once, and that goes over to the one that was the fastest when it was measured as
     * soon as that is warm. Where none was measured yet, the one that mostly is the fastest stands in for it, and those
     * that may be faster are measured beside its frames.
     *
     * @throws EngineException where no engine can be opened
     */
    public Engine openAtOnce(List<EngineOffer> offers) {
        List<EngineOffer> candidates = candidates(offers);
        return remembered(offers)
                .map(id -> openWarming(openUnmeasured(candidates), id, candidates))
                .orElseGet(() -> openToBeConfirmed(MOSTLY_FASTEST, candidates, () -> offers));
    }

    /**
     * The same, but devices are looked for at once only where one of them was the fastest; otherwise that is done when
     * there is time, and where they are others than those measured, the engines are measured then.
     *
     * @param atOnce the engines that need no device
     * @param all those, and the devices; may take a while
     * @throws EngineException where no engine can be opened
     */
    public Engine openAtOnce(List<EngineOffer> atOnce, Supplier<List<EngineOffer>> all) {
        List<EngineOffer> candidates = candidates(atOnce);
        Optional<String> known = store.read(MachineKey.beforeDevices(candidates));
        boolean device =
                known.filter(id -> Engines.find(candidates, id).isEmpty()).isPresent();
        if (candidates.isEmpty() || device) {
            return openAtOnce(all.get());
        }
        return openToBeConfirmed(known.orElse(MOSTLY_FASTEST), candidates, all);
    }

    private Engine openToBeConfirmed(String id, List<EngineOffer> candidates, Supplier<List<EngineOffer>> all) {
        Engine standIn = openUnmeasured(candidates);
        Engine drawing = openWarming(standIn, id, candidates);
        return new AutoEngine(
                drawing,
                new Successor(canceled -> confirmedBeside(drawing, standIn.id(), all, canceled)),
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

    /** Whether what draws is the fastest of all engines, now that there is time to look for all of them. */
    private Optional<Engine> confirmedBeside(
            Engine drawing, String standIn, Supplier<List<EngineOffer>> all, BooleanSupplier canceled) {
        waiting.await(Successor.WARMING, canceled);
        if (canceled.getAsBoolean()) {
            return Optional.empty();
        }
        List<EngineOffer> candidates = candidates(all.get());
        Optional<String> known = remembered(candidates);
        known.ifPresent(id -> store.write(MachineKey.beforeDevices(candidates), id));
        return known.or(() -> fastestBeside(drawing, standIn, candidates, canceled))
                .filter(fastest -> !fastest.equals(drawing.id()) && !canceled.getAsBoolean())
                .flatMap(fastest -> Engines.find(candidates, fastest))
                .flatMap(FastestEngine::opened);
    }

    /**
     * Trials take from the frames: there are none but of those that can be the fastest. An engine that went over to
     * another has lost to it.
     */
    private Optional<String> fastestBeside(
            Engine drawing, String standIn, List<EngineOffer> candidates, BooleanSupplier canceled) {
        boolean beaten = !drawing.id().equals(standIn);
        List<EngineOffer> rivals = candidates.stream()
                .filter(offer -> !beaten || !offer.id().equals(standIn))
                .toList();
        Optional<String> fastest =
                rivals.size() == 1 ? Optional.of(rivals.getFirst().id()) : fastestOf(measure(rivals, canceled));
        remember(candidates, fastest, canceled);
        return fastest;
    }

    private void remember(List<EngineOffer> candidates, Optional<String> fastest, BooleanSupplier canceled) {
        fastest.filter(_ -> !canceled.getAsBoolean()).ifPresent(id -> {
            store.write(MachineKey.beforeDevices(candidates), id);
            // Last: who finds this one finds all that is remembered.
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
     * Opens the engine that was the fastest when it was measured, or else measures now, patiently.
     *
     * @throws EngineException where no engine can be opened
     */
    public Engine openMeasured(List<EngineOffer> offers) {
        List<EngineOffer> candidates = candidates(offers);
        Optional<EngineOffer> known = remembered(offers).flatMap(id -> Engines.find(candidates, id));
        if (known.isPresent()) {
            try {
                return known.get().opener().get();
            } catch (EngineException _) {
                // Something changed since (a driver, say): measure again.
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

    /** The id of the engine that {@link #openMeasured} takes, where it was measured before. */
    public Optional<String> remembered(List<EngineOffer> offers) {
        List<EngineOffer> candidates = candidates(offers);
        return store.read(MachineKey.of(candidates))
                .filter(id -> Engines.find(candidates, id).isPresent());
    }

    /** Measures with the patience that a device's compiler needs, and remembers; the fastest comes first. */
    public List<Time> measurePatiently(List<EngineOffer> offers) {
        return measureAll(candidates(offers));
    }

    private List<Time> measureAll(List<EngineOffer> candidates) {
        List<Time> times = measure(candidates, () -> false);
        remember(candidates, fastestOf(times), () -> false);
        return times;
    }

    /** The JVM's engines come first: they need no compiler that could still be at work beside the next trial. */
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

    /** Those that drew, the fastest first; where none was ready in time, the paper's baseline, then any. */
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
