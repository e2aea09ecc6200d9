package dev.twister.cli.option;

import dev.twister.cli.file.BadInputException;
import dev.twister.engine.EngineOffer;
import dev.twister.engine.Engines;
import dev.twister.engine.auto.FastestEngine;
import java.util.List;
import java.util.stream.Collectors;

/** The engines that a repeated {@code --engine} means. */
public final class EngineNames {
    private EngineNames() {}

    /**
     * The named ones, each once; without a name all but {@value FastestEngine#AUTO}, working or not.
     *
     * @throws BadInputException where no engine has one of the names
     */
    public static List<EngineOffer> chosen(List<String> names) {
        List<EngineOffer> offers = Engines.offers();
        if (names.isEmpty()) {
            return offers.stream()
                    .filter(offer -> !offer.id().equals(FastestEngine.AUTO))
                    .toList();
        }
        // An error in the last name should not come out after minutes of measuring the others.
        return names.stream()
                .map(name -> Engines.find(offers, name)
                        .orElseThrow(() -> new BadInputException("--engine is '" + name + "', but must be one of "
                                + offers.stream().map(EngineOffer::id).collect(Collectors.joining(", ")))))
                .distinct()
                .toList();
    }
}
