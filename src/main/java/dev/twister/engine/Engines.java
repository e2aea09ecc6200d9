package dev.twister.engine;

import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.ServiceLoader;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** Finds the engines of this machine. */
public final class Engines {
    private Engines() {}

    /** The names of the families whose engines are devices; each stands for its first one. */
    public static List<String> deviceFamilies() {
        return providers()
                .flatMap(provider -> provider.devices().stream())
                .distinct()
                .toList();
    }

    /** Whether an engine of this id draws on a device. */
    public static boolean isDevice(String id) {
        return deviceFamilies().stream().anyMatch(family -> isOf(family, id));
    }

    private static boolean isOf(String family, String id) {
        return id.equals(family) || id.startsWith(family + ":");
    }

    /** All engines known here, working or not, the JVM's own first and devices last. */
    public static List<EngineOffer> offers() {
        return offers(_ -> true);
    }

    /** Those of them that are known at once, without looking for devices. */
    public static List<EngineOffer> offersAtOnce() {
        return offers(provider -> provider.devices().isEmpty());
    }

    private static List<EngineOffer> offers(Predicate<EngineProvider> asked) {
        return providers()
                .filter(asked)
                .sorted(Comparator.comparing((EngineProvider provider) -> !(provider instanceof JvmEngines))
                        .thenComparing(provider -> provider.devices().isPresent())
                        .thenComparing(provider -> provider.getClass().getName()))
                .flatMap(provider -> provider.offers().stream())
                .toList();
    }

    private static Stream<EngineProvider> providers() {
        return ServiceLoader.load(EngineProvider.class).stream().map(ServiceLoader.Provider::get);
    }

    /**
     * Opens the engine of that name; a family's name alone is its first device.
     *
     * @throws UnknownEngineException where no engine has that name
     * @throws EngineException where it cannot be opened
     */
    public static Engine open(String id) {
        return offer(id).opener().get();
    }

    /**
     * The engine of that name, working or not; a family's name alone is its first device.
     *
     * @throws UnknownEngineException where no engine has that name
     */
    public static EngineOffer offer(String id) {
        return find(offersAtOnce(), id).orElseGet(() -> findEverywhere(id));
    }

    private static EngineOffer findEverywhere(String id) {
        List<EngineOffer> offers = offers();
        return find(offers, id)
                .orElseThrow(() -> new UnknownEngineException("no engine is called '" + id + "'; there are "
                        + offers.stream().map(EngineOffer::id).collect(Collectors.joining(", "))));
    }

    /** Which of the offers that name means; a family's name alone is its first device. */
    public static Optional<EngineOffer> find(List<EngineOffer> offers, String name) {
        return offers.stream()
                .filter(offer -> offer.id().equals(name))
                .findFirst()
                .or(() -> offers.stream()
                        .filter(offer -> deviceFamilies().contains(name) && isOf(name, offer.id()))
                        .findFirst());
    }
}
