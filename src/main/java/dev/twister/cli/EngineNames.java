package dev.twister.cli;

import dev.twister.engine.EngineOffer;
import dev.twister.engine.Engines;
import dev.twister.engine.UnknownEngineException;
import java.util.List;
import java.util.stream.Collectors;

/** The engines that a command line names. */
final class EngineNames {
    private EngineNames() {}

    /**
     * Their ids, each once, in the order in which they were named.
     *
     * @param offers all that there are
     * @throws UnknownEngineException where none has one of the names: an error in the last one should not come out after minutes
     *     of measuring the others
     */
    static List<String> resolve(List<String> names, List<EngineOffer> offers) {
        return names.stream().map(name -> resolve(name, offers)).distinct().toList();
    }

    private static String resolve(String name, List<EngineOffer> offers) {
        return Engines.find(offers, name)
                .map(EngineOffer::id)
                .orElseThrow(() -> new UnknownEngineException("--engine is '" + name + "', but must be one of "
                        + offers.stream().map(EngineOffer::id).collect(Collectors.joining(", "))));
    }
}
