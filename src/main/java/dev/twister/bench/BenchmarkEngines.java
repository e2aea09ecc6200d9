package dev.twister.bench;

import dev.twister.engine.Engine;
import dev.twister.engine.EngineException;
import dev.twister.engine.Engines;
import dev.twister.engine.UnknownEngineException;
import dev.twister.engine.auto.FastestEngine;

/** Opens engines to be measured. */
public final class BenchmarkEngines {
    private BenchmarkEngines() {}

    /**
     * Opens the engine of that name. {@value FastestEngine#AUTO} has chosen before it draws: frames of another engine
     * meanwhile would be measured as its own.
     *
     * @throws UnknownEngineException where no engine has that name
     * @throws EngineException where it cannot be opened
     */
    public static Engine open(String id) {
        return id.equals(FastestEngine.AUTO)
                ? FastestEngine.ofThisMachine().openMeasured(Engines.offers())
                : Engines.open(id);
    }
}
