package dev.twister.bench.benchmark;

import dev.twister.engine.Engine;
import dev.twister.engine.Engines;
import dev.twister.engine.auto.FastestEngine;

/**
 * An engine with the name by which it was requested: {@value FastestEngine#AUTO} opens another engine, which may be
 * measured too.
 *
 * @param id the name in the report
 */
record AskedEngine(String id, Engine engine) {
    /** The engine's device, preceded by the engine's own id if that differs. */
    String device() {
        return (engine.id().equals(id) ? "" : engine.id() + ": ") + engine.device();
    }

    /** Whether the engine runs on a device. */
    boolean isDevice() {
        return Engines.isDevice(engine.id());
    }
}
