package dev.twister.oracle;

import dev.twister.scene.Scene;
import dev.twister.sky.Skybox;

/** A scene with its sky at hand, whatever file it names. */
public record LitScene(Scene scene, Skybox sky) {}
