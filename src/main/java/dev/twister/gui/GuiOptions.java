package dev.twister.gui;

import dev.twister.engine.EngineOffer;
import dev.twister.scene.Scene;
import java.nio.file.Path;

/**
 * What the window starts with.
 *
 * @param scene shown first
 * @param file where it came from
 * @param engine draws first
 */
public record GuiOptions(Scene scene, Path file, EngineOffer engine) {}
