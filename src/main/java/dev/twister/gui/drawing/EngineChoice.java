package dev.twister.gui.drawing;

import dev.twister.engine.EngineOffer;

/**
 * A choice of an engine. An engine that failed is tried again only when it is chosen again, which makes a new choice.
 *
 * @param number counts the choices
 */
public record EngineChoice(long number, EngineOffer offer) {}
