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
 * What a choice of engine holds for; where any of it changes, the engines are measured again.
 *
 * @param facts by name, in the order of their names
 */
record MachineKey(Map<String, String> facts) {
    MachineKey {
        facts = Map.copyOf(facts);
    }

    /** With all engines, devices included. */
    static MachineKey of(List<EngineOffer> engines) {
        return of(engines, "looked for");
    }

    /** What of it is known before devices are looked for. */
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

    /** A name for a file: the same for the same facts, and hardly ever for others. */
    String fileName() {
        String text = new TreeMap<>(facts).toString();
        return "engine-" + UUID.nameUUIDFromBytes(text.getBytes(StandardCharsets.UTF_8)) + ".properties";
    }
}
