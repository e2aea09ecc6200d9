package dev.twister.engine.auto;

import dev.twister.engine.EngineOffer;
import dev.twister.engine.Engines;
import dev.twister.engine.Processor;
import dev.twister.files.TwisterVersion;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.UUID;
import java.util.stream.Collectors;

/**
 * The facts on which a choice of engine depends; if any changes, the engines are measured again.
 *
 * @param facts values by name
 */
record MachineKey(Map<String, String> facts) {
    MachineKey {
        facts = Map.copyOf(facts);
    }

    /** The key that includes all engines and devices. */
    static MachineKey of(List<EngineOffer> engines) {
        return of(engines, "looked for");
    }

    /** The key that is known before looking for devices. */
    static MachineKey beforeDevices(List<EngineOffer> engines) {
        return of(
                engines.stream()
                        .filter(engine -> !Engines.isDevice(engine.id()))
                        .toList(),
                "not looked for");
    }

    private static MachineKey of(List<EngineOffer> engines, String devices) {
        return new MachineKey(Map.of(
                "devices", devices,
                "processor", Processor.name(),
                "cores", Integer.toString(Runtime.getRuntime().availableProcessors()),
                "jdk", Runtime.version().toString(),
                "twister", TwisterVersion.text(),
                "engines",
                        engines.stream()
                                .map(engine -> engine.id() + " on " + engine.device())
                                .collect(Collectors.joining(", "))));
    }

    /** A file name, equal for equal facts and almost certainly different for others. */
    String fileName() {
        String text = new TreeMap<>(facts).toString();
        return "engine-" + UUID.nameUUIDFromBytes(text.getBytes(StandardCharsets.UTF_8)) + ".properties";
    }
}
