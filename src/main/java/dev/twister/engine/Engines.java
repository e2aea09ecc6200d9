package dev.twister.engine;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.ServiceLoader;
import java.util.function.Predicate;
import java.util.stream.Collectors;

/** Finds the engines of this machine. */
public final class Engines {
    /** How the ids of TornadoVM's engines begin. */
    public static final String TORNADO_PREFIX = "tornado";

    private Engines() {}

    /** Whether an engine of this id draws on a device of TornadoVM's. */
    public static boolean isDevice(String id) {
        return id.startsWith(TORNADO_PREFIX);
    }

    /** All engines known here, working or not, the JVM's own first. */
    public static List<EngineOffer> offers() {
        List<EngineOffer> offers = new ArrayList<>(offers(_ -> true));
        if (offers.stream().noneMatch(offer -> isDevice(offer.id()))) {
            offers.add(EngineOffer.impossible(
                    TORNADO_PREFIX,
                    "any OpenCL, CUDA or Metal device",
                    "the kernel compiled by TornadoVM for an accelerator",
                    "no TornadoVM SDK was found. Install one (sdk install tornadovm, or set TORNADOVM_HOME), then start"
                            + " with scripts/twister, which builds the engine and runs it"));
        }
        return List.copyOf(offers);
    }

    /** Those of them that are known at once, without looking for devices. */
    public static List<EngineOffer> offersAtOnce() {
        return offers(provider -> !provider.looksForDevices());
    }

    private static List<EngineOffer> offers(Predicate<EngineProvider> asked) {
        return ServiceLoader.load(EngineProvider.class).stream()
                .map(ServiceLoader.Provider::get)
                .filter(asked)
                .sorted(Comparator.comparing((EngineProvider provider) -> !(provider instanceof JvmEngines))
                        .thenComparing(provider -> provider.getClass().getName()))
                .flatMap(provider -> provider.offers().stream())
                .toList();
    }

    /**
     * Opens the engine of that name; {@code tornado} alone is TornadoVM's first device.
     *
     * @throws UnknownEngineException where no engine has that name
     * @throws EngineException where it cannot be opened
     */
    public static Engine open(String id) {
        return offer(id).opener().get();
    }

    /**
     * The engine of that name, working or not; {@code tornado} alone is TornadoVM's first device.
     *
     * @throws UnknownEngineException where no engine has that name
     */
    public static EngineOffer offer(String id) {
        return find(offersAtOnce(), id).orElseGet(() -> findEverywhere(id));
    }

    private static EngineOffer findEverywhere(String id) {
        List<EngineOffer> offers = offers();
        return find(offers, id)
                .or(() -> offers.stream()
                        .filter(offer -> id.equals(TORNADO_PREFIX) && isDevice(offer.id()))
                        .findFirst())
                .orElseThrow(() -> new UnknownEngineException("no engine is called '" + id + "'; there are "
                        + offers.stream().map(EngineOffer::id).collect(Collectors.joining(", "))));
    }

    private static Optional<EngineOffer> find(List<EngineOffer> offers, String id) {
        return offers.stream().filter(offer -> offer.id().equals(id)).findFirst();
    }
}
