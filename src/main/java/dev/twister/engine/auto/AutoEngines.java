package dev.twister.engine.auto;

import com.google.auto.service.AutoService;
import dev.twister.engine.EngineOffer;
import dev.twister.engine.EngineProvider;
import dev.twister.engine.Engines;
import java.util.List;

/** Offers {@value FastestEngine#AUTO}, which opens the fastest of the other engines. */
@AutoService(EngineProvider.class)
public final class AutoEngines implements EngineProvider {
    @Override
    public List<EngineOffer> offers() {
        return List.of(EngineOffer.working(
                FastestEngine.AUTO,
                "the fastest of the others",
                "measured here once it has been used for some seconds, then remembered",
                () -> FastestEngine.ofThisMachine().openAtOnce(Engines.offersAtOnce(), Engines::offers)));
    }
}
