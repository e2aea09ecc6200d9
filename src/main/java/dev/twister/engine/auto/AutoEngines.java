package dev.twister.engine.auto;

import com.google.auto.service.AutoService;
import dev.twister.engine.EngineOffer;
import dev.twister.engine.EngineProvider;
import dev.twister.engine.Engines;
import java.util.List;

/** Offers {@value FastestEngine#AUTO}: opening it opens the fastest of the others. */
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
