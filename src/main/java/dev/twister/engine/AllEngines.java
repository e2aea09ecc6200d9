package dev.twister.engine;

import com.google.auto.service.AutoService;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** Offers {@value #ALL}, which renders each frame with the processor and every device together. */
@AutoService(EngineProvider.class)
public final class AllEngines implements EngineProvider {
    public static final String ALL = "all";

    private static final String DESCRIPTION =
            "the processor and every device render bands of the same frame, where it gets shorter with them";

    /** The processor's engines, the faster ones first. */
    private static final List<String> OF_THE_PROCESSOR = List.of("vector", JvmEngines.PARALLEL);

    @Override
    public List<EngineOffer> offers() {
        List<EngineOffer> others = Engines.offers(provider -> !(provider instanceof AllEngines)).stream()
                .filter(EngineOffer::works)
                .toList();
        List<EngineOffer> devices =
                others.stream().filter(offer -> Engines.isDevice(offer.id())).toList();
        if (devices.isEmpty()) {
            return List.of(EngineOffer.impossible(
                    ALL,
                    "the processor and every device",
                    DESCRIPTION,
                    "no device works here; 'twister devices' says what they need"));
        }
        List<EngineOffer> taken =
                Stream.concat(ofTheProcessor(others), devices.stream()).toList();
        return List.of(EngineOffer.working(ALL, names(taken), DESCRIPTION, () -> open(taken)));
    }

    @Override
    public Optional<String> devices() {
        return Optional.of(ALL);
    }

    private static Stream<EngineOffer> ofTheProcessor(List<EngineOffer> offers) {
        return OF_THE_PROCESSOR.stream()
                .flatMap(id -> Engines.find(offers, id).stream())
                .limit(1);
    }

    private static String names(List<EngineOffer> offers) {
        return offers.stream().map(EngineOffer::device).collect(Collectors.joining(" + "));
    }

    private static Engine open(List<EngineOffer> offers) {
        List<Engine> opened = new ArrayList<>();
        try {
            offers.forEach(offer -> opened.add(offer.opener().get()));
        } catch (RuntimeException | Error problem) {
            opened.forEach(Engine::close);
            throw problem;
        }
        return new AllEngine(opened);
    }
}
