package dev.twister.gui.drawing;

import dev.twister.engine.EngineOffer;

/**
 * A person's choice of an engine. Each choice is one of its own, so that an engine that failed is tried again when it
 * is chosen again, and only then.
 *
 * @param number counts the choices up
 * @param offer the engine
 */
public record EngineChoice(long number, EngineOffer offer) {}
