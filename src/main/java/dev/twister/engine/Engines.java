package dev.twister.engine;

import dev.twister.image.Frame;
import dev.twister.world.FrameInput;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.ServiceLoader;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** Lists, finds and opens the engines of this machine. */
public final class Engines {
    private Engines() {}

    /** Names of the families whose engines run on devices; each also names the family's first engine. */
    public static List<String> deviceFamilies() {
        return providers()
                .flatMap(provider -> provider.devices().stream())
                .distinct()
                .toList();
    }

    /** Whether the engine with this id runs on a device. */
    public static boolean isDevice(String id) {
        return deviceFamilies().stream().anyMatch(family -> isOf(family, id));
    }

    private static boolean isOf(String family, String id) {
        return id.equals(family) || id.startsWith(family + ":");
    }

    /** All known engines, including those that cannot run here; the JVM's own first, devices last. */
    public static List<EngineOffer> offers() {
        return offers(_ -> true);
    }

    /** The engines of families without devices, which are known at once. */
    public static List<EngineOffer> offersAtOnce() {
        return offers(provider -> provider.devices().isEmpty());
    }

    public static List<EngineOffer> offers(Predicate<EngineProvider> asked) {
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
     * Opens an engine by name. A family's name stands for its first device.
     *
     * @throws UnknownEngineException if no engine has that name
     * @throws EngineException if the engine cannot be opened
     */
    public static Engine open(String id) {
        return new OpenEngine(offer(id).opener().get());
    }

    /**
     * Finds an engine by name, even if it cannot run here. A family's name stands for its first device.
     *
     * @throws UnknownEngineException if no engine has that name
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

    /** Finds an engine among offers by name. A family's name stands for its first device. */
    public static Optional<EngineOffer> find(List<EngineOffer> offers, String name) {
        return offers.stream()
                .filter(offer -> offer.id().equals(name))
                .findFirst()
                .or(() -> offers.stream()
                        .filter(offer -> deviceFamilies().contains(name) && isOf(name, offer.id()))
                        .findFirst());
    }

    /** An engine that refuses to render once it is closed. */
    private static final class OpenEngine implements Engine {
        private final Engine engine;
        private volatile boolean closed;

        OpenEngine(Engine engine) {
            this.engine = engine;
        }

        @Override
        public String id() {
            return engine.id();
        }

        @Override
        public String device() {
            return engine.device();
        }

        @Override
        public void render(FrameInput input, Frame frame) {
            if (closed) {
                throw new IllegalStateException("engine " + id() + " is closed");
            }
            engine.render(input, frame);
        }

        @Override
        public void onFaster(Runnable listener) {
            engine.onFaster(listener);
        }

        @Override
        public boolean drawsBandsInProportion() {
            return engine.drawsBandsInProportion();
        }

        @Override
        public boolean declines(FrameInput input) {
            return engine.declines(input);
        }

        @Override
        public void rest() {
            engine.rest();
        }

        @Override
        public void close() {
            closed = true;
            engine.close();
        }
    }
}
