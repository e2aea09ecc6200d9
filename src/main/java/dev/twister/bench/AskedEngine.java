package dev.twister.bench;

import dev.twister.engine.Engine;
import dev.twister.engine.Engines;
import dev.twister.engine.auto.FastestEngine;

/**
 * An engine under the name that it was asked for by: {@value FastestEngine#AUTO} becomes another one, which may be
 * measured beside it.
 *
 * @param id the name in the report
 */
record AskedEngine(String id, Engine engine) {
    /** What does the work; with the engine's own name where that is another one. */
    String device() {
        return (engine.id().equals(id) ? "" : engine.id() + ": ") + engine.device();
    }

    /** Whether it draws on a device, whatever it is called. */
    boolean isDevice() {
        return Engines.isDevice(engine.id());
    }
}
